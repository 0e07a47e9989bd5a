// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/compare/method_answer.h"

namespace etendue {

/// Two answers to one case. All differences are second - first.
struct Comparison {
  MethodAnswer first;
  MethodAnswer second;
};

/// A difference over the error of both together; 0 where they are the same, infinite where they differ
/// although neither admits an error.
double in_errors(double difference, double first_error, double second_error);

/// How the means of the cells agree in one band.
struct CellAgreement {
  double within = 0;            ///< share of the cells that differ by at most three errors
  double root_mean_square = 0;  ///< of the differences in errors
  double median_first = 0;      ///< relative error of the cells, median
  double median_second = 0;
  double difference = 0;  ///< volume-weighted root mean square of the difference, relative to the first
};
std::vector<CellAgreement> cell_agreement(const Comparison& comparison, const TetrahedralMesh& mesh,
                                          std::size_t bands);

/// For people: the agreement of the cells, and numbers; only those that differ most where there are many.
std::string comparison_text(const Comparison& comparison, const std::vector<CellAgreement>& cells,
                            const std::vector<std::string>& bands);

/// where,band,quantity,FIRST,FIRST_error,SECOND,SECOND_error,difference,in_errors
std::string comparison_csv(const Comparison& comparison);

}  // namespace etendue
