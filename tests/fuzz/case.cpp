// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/case.h"

#include <algorithm>
#include <cstdlib>

#include "app/case/toml/toml_document.h"
#include "base/errors.h"
#include "mesh/files/fields/field_file.h"
#include "tests/fuzz/input_parts.h"

namespace {

using etendue::TomlNode;

/// Whether a text, as the name of a file, leads out of the folder of the case.
bool leads_out(const TomlNode& node) {
  if (node.is_text()) return node.text().starts_with('/') || node.text().find("..") != std::string::npos;
  if (node.is_table())
    return std::ranges::any_of(node.table().entries,
                               [](const auto& entry) { return leads_out(*entry.node); });
  return node.is_array() &&
         std::ranges::any_of(node.array(), [](const auto& entry) { return leads_out(*entry); });
}

}  // namespace

/// In the place of the reader by VTK.
etendue::FieldData etendue::read_field(const FieldRequest& request) {
  throw FileError(request.path.string(), "cannot be opened");
}

/// A case is read, and its record is read as the same again; or it is refused. Its folder is empty.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // The albedo of microfacets takes a tenth of a second to tabulate, and ten seconds under the sanitizers.
  if (text.find("ggx") != std::string_view::npos) return -1;
  const std::filesystem::path file = etendue::test::input_folder().path() / "case.toml";
  std::string once;
  try {
    if (leads_out(etendue::parse_toml(text, file.string()))) return -1;
    once = etendue::read_case_text(text, file).resolved_toml;
  } catch (const etendue::InputError&) {
    return 0;
  } catch (const etendue::FileError&) {
    return 0;
  }
  if (etendue::read_case_text(once, file).resolved_toml != once) std::abort();
  return 0;
}
