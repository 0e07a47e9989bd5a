// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <etendue/mesh.h>

namespace etendue {
ETENDUE_INTERFACE_BEGIN
/// A case file, read and checked; every default is filled in. Nothing is meshed or solved yet. Copies share
/// it.
class ETENDUE_EXPORT Case {
 public:
  /// Changes of keys, `key=value` as TOML: "solve.tolerance=1e-8".
  using Overrides = std::vector<std::string>;

  /// Throws FileError where the file cannot be read, else one InputError with all faults and their lines.
  static Case from_file(const std::filesystem::path& file, const Overrides& overrides = {});
  /// The same of TOML text. `file` need not exist: paths in the text start in its folder, and its name is
  /// in messages.
  static Case from_text(std::string_view text, const std::filesystem::path& file = "case.toml",
                        const Overrides& overrides = {});
  /// A case whose mesh is given: it replaces the table [mesh] of the text. A mesh that mesh() made replaces
  /// nothing: the text must have the table that it was made from.
  static Case from_text(std::string_view text, const Mesh& mesh,
                        const std::filesystem::path& file = "case.toml", const Overrides& overrides = {});
  ~Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;

  const std::string& title() const;
  const std::vector<std::string>& bands() const;
  std::vector<std::string> cameras() const;  ///< names
  const std::string& length_unit() const;    ///< "m"
  const std::string& power_unit() const;     ///< "W"
  /// TOML with overrides applied and defaults filled in; reads back to the same case.
  const std::string& resolved_toml() const;
  /// The mesh that was given, or else the geometry filled with tetrahedra or the mesh file read; made anew
  /// in each call. Throws InputError and FileError.
  Mesh mesh() const;

  struct Impl;
  explicit Case(std::shared_ptr<const Impl> impl);
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

ETENDUE_INTERFACE_END
}  // namespace etendue
