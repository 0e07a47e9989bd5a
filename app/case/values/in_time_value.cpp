// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/in_time_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "app/case/keys/resolve_path.h"
#include "base/piecewise_linear.h"
#include "base/text/number_columns.h"

namespace etendue {
namespace {

InTime of_table(const TomlNode& node, const std::filesystem::path& case_folder) {
  InTime read{InTime::Kind::table, node.text(), {}, {}, node.origin};
  auto columns = read_columns(readable_path(node, case_folder), {"t", "factor"});
  if (columns[0].empty() ||
      std::ranges::adjacent_find(columns[0], std::greater_equal<>()) != columns[0].end())
    throw InputError(fault_at(node.origin, "\"" + node.text() + "\"",
                              "needs lines of t and factor, and times that rise throughout"));
  if (std::ranges::any_of(columns[1], [](double factor) { return factor < 0; }))
    throw InputError(fault_at(node.origin, "\"" + node.text() + "\"", "has a factor below 0"));
  read.times = std::move(columns[0]);
  read.factors = std::move(columns[1]);
  return read;
}

InTime of_formula(const TomlNode& node) {
  try {
    Expression(Formula{node.text()}, {"t"});
  } catch (const InputError& error) {
    throw InputError(fault_at(node.origin, "\"" + node.text() + "\"",
                              "is neither \"pulse\", \"step\", a formula in t nor the name of a .csv file: " +
                                  error.faults().front().text));
  }
  return {InTime::Kind::formula, node.text(), {}, {}, node.origin};
}

std::function<double(double)> factor_by_formula(const InTime& in_time) {
  struct Shared {
    explicit Shared(const Formula& text) : formula(text, {"t"}) {}
    Expression formula;
    std::mutex in_use;  // an expression serves one thread at a time
  };
  const auto shared = std::make_shared<Shared>(Formula{in_time.text});
  return [shared, in_time](double t) {
    const std::lock_guard lock(shared->in_use);
    return formula_factor(in_time, shared->formula, t);
  };
}

std::function<double(double)> factor_by_table(const InTime& in_time) {
  return [in_time](double t) { return piecewise_linear(in_time.times, in_time.factors, t).value; };
}

}  // namespace

double formula_factor(const InTime& in_time, const Expression& formula, double t) {
  const double factor = formula(std::array{t});
  if (!(factor >= 0) || !std::isfinite(factor))
    throw InputError(fault_at(
        in_time.origin, "\"" + in_time.text + "\"",
        fmt::format("is {:.6g} at t = {:.6g}; use a formula that is finite and not below 0", factor, t)));
  return factor;
}

std::function<double(double t)> factor_in_time(const InTime& in_time) {
  if (in_time.kind == InTime::Kind::formula) return factor_by_formula(in_time);
  if (in_time.kind == InTime::Kind::table) return factor_by_table(in_time);
  return [](double) { return 1.0; };
}

std::optional<InTime> read_in_time(Section& section, const std::filesystem::path& case_folder) {
  const TomlNode* node = section.find_or_default("in_time");
  if (node == nullptr) return std::nullopt;
  const std::string& text = node->text();
  if (text == "pulse") return InTime{InTime::Kind::pulse, text, {}, {}, node->origin};
  if (text == "step") return InTime{InTime::Kind::step, text, {}, {}, node->origin};
  try {
    return text.ends_with(".csv") ? of_table(*node, case_folder) : of_formula(*node);
  } catch (const InputError& error) {
    const std::vector<Fault>& faults = error.faults();
    section.faults().insert(section.faults().end(), faults.begin(), faults.end());
    return std::nullopt;
  }
}

}  // namespace etendue
