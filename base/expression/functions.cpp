// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/expression/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"

namespace etendue {
namespace {

double sign(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }
double zero(double) { return 0; }
double reciprocal(double x) { return 1 / x; }

// log is the natural one, as in muParser.
constexpr std::array unary_functions = {
    UnaryFunction{"sin", [](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }},
    UnaryFunction{"cos", [](double x) { return std::cos(x); }, [](double x) { return -std::sin(x); }},
    UnaryFunction{"tan", [](double x) { return std::tan(x); },
                  [](double x) { return 1 / (std::cos(x) * std::cos(x)); }},
    UnaryFunction{"asin", [](double x) { return std::asin(x); },
                  [](double x) { return 1 / std::sqrt(1 - x * x); }},
    UnaryFunction{"acos", [](double x) { return std::acos(x); },
                  [](double x) { return -1 / std::sqrt(1 - x * x); }},
    UnaryFunction{"atan", [](double x) { return std::atan(x); }, [](double x) { return 1 / (1 + x * x); }},
    UnaryFunction{"sinh", [](double x) { return std::sinh(x); }, [](double x) { return std::cosh(x); }},
    UnaryFunction{"cosh", [](double x) { return std::cosh(x); }, [](double x) { return std::sinh(x); }},
    UnaryFunction{"tanh", [](double x) { return std::tanh(x); },
                  [](double x) { return 1 / (std::cosh(x) * std::cosh(x)); }},
    UnaryFunction{"asinh", [](double x) { return std::asinh(x); },
                  [](double x) { return 1 / std::sqrt(x * x + 1); }},
    UnaryFunction{"acosh", [](double x) { return std::acosh(x); },
                  [](double x) { return 1 / std::sqrt(x * x - 1); }},
    UnaryFunction{"atanh", [](double x) { return std::atanh(x); }, [](double x) { return 1 / (1 - x * x); }},
    UnaryFunction{"log2", [](double x) { return std::log2(x); },
                  [](double x) { return 1 / (x * std::numbers::ln2); }},
    UnaryFunction{"log10", [](double x) { return std::log10(x); },
                  [](double x) { return 1 / (x * std::numbers::ln10); }},
    UnaryFunction{"log", [](double x) { return std::log(x); }, reciprocal},
    UnaryFunction{"ln", [](double x) { return std::log(x); }, reciprocal},
    UnaryFunction{"exp", [](double x) { return std::exp(x); }, [](double x) { return std::exp(x); }},
    UnaryFunction{"sqrt", [](double x) { return std::sqrt(x); }, [](double x) { return 0.5 / std::sqrt(x); }},
    UnaryFunction{"sign", sign, zero},
    UnaryFunction{"rint", [](double x) { return std::floor(x + 0.5); }, zero},
    UnaryFunction{"abs", [](double x) { return std::abs(x); }, sign},
    UnaryFunction{"blackbody_fraction", blackbody_fraction, blackbody_fraction_slope},
};

}  // namespace

const UnaryFunction* find_unary_function(std::string_view name) {
  const auto* found = std::find_if(unary_functions.begin(), unary_functions.end(),
                                   [&](const UnaryFunction& function) { return function.name == name; });
  return found == unary_functions.end() ? nullptr : found;
}

}  // namespace etendue
