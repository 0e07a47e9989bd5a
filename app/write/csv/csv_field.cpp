// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/csv_field.h"

namespace etendue {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace etendue
