// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/case/toml/toml_place.h"

namespace etendue {

/// Problem of a TOML text in plain words, with what helps, and the place that it concerns.
struct TomlProblem {
  TomlPlace place;
  std::string text;
};

/// What is wrong at `place`. `description` is that of toml++, which tells the rule of the grammar that is
/// broken.
TomlProblem toml_problem(const TomlPlace& place, std::string_view description);

/// `file:line:column: problem`; two lines below show the line and a caret under the column.
std::string toml_message(const TomlProblem& problem, const std::string& file);

}  // namespace etendue
