// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "solver/materials/media/coefficient.h"

namespace etendue {

bool is_number(const Value& value);

/// The value as a factor or term of a longer formula: in parentheses.
Formula term(const Value& value);

/// `a sign b` as a formula that calls the functions of both.
Formula joined(const Value& a, const char* sign, const Value& b);

/// Numbers where both are numbers.
Value product(const Value& a, const Value& b);
Value sum(const Value& a, const Value& b);

/// Terms of x^0, x^1 and so on, at least one.
Value polynomial(const Value& x, const std::vector<Value>& terms);

/// The value as a coefficient that depends on the place.
Coefficient coefficient_of(const Value& value);

}  // namespace etendue
