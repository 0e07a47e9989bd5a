// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/harmonics.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "solver/angular/harmonics/spherical_harmonics.h"

namespace etendue {
namespace {

// A function of which less than this part is new (in the norm of the set) depends on those before it: what is
// left is rounding, about 1e-15, on sets where a harmonic vanishes or repeats a lower one.
constexpr double dependent = 1e-8;

/// Functions on the ordinates as columns, scaled by sqrt(w / full range): orthonormal columns are what is
/// wanted.
class OrthonormalFunctions {
 public:
  OrthonormalFunctions(std::size_t ordinates, int most)
      : columns_(static_cast<Eigen::Index>(ordinates), most) {}

  /// Takes a function that is already orthonormal to all others.
  void take(const Eigen::VectorXd& function) { columns_.col(count_++) = function; }

  /// Takes what is new in a function, by Gram and Schmidt's process, twice for full accuracy (Giraud et al.
  /// 2005). Returns whether anything was.
  bool take_new_part(Eigen::VectorXd function) {
    const double before = function.norm();
    for (int pass = 0; pass < 2; ++pass)
      for (int k = 0; k < count_; ++k) function -= columns_.col(k).dot(function) * columns_.col(k);
    const double after = function.norm();
    if (!(after > dependent * before)) return false;
    take(function / after);
    return true;
  }

  double operator()(int k, std::size_t m) const { return columns_(static_cast<Eigen::Index>(m), k); }

 private:
  Eigen::MatrixXd columns_;
  int count_ = 0;
};

/// Raw harmonics on the set, [ordinate, k], scaled by sqrt(w / full range).
Eigen::MatrixXd raw_harmonics(const DirectionSet& set, int degree) {
  Eigen::MatrixXd values(set.count(), harmonic_count(set.space(), degree));
  std::vector<double> row(static_cast<std::size_t>(values.cols()));
  for (int m = 0; m < set.count(); ++m) {
    harmonics(set.space(), set.direction(OrdinateIndex(m)), degree, row);
    const double scale = std::sqrt(set.weight(OrdinateIndex(m)) / full_range(set.space()));
    values.row(m) = scale * Eigen::Map<const Eigen::RowVectorXd>(row.data(), values.cols());
  }
  return values;
}

/// The columns of 1, x, y and z among the raw harmonics; in the plane of 1, x and y.
std::vector<int> linear_columns(AngularSpace space) {
  if (space == AngularSpace::plane) return {0, 2, 1};
  return {0, 3, 1, 2};
}

}  // namespace

DiscreteHarmonics::DiscreteHarmonics(const DirectionSet& set, int degree) : space_(set.space()) {
  const Eigen::MatrixXd raw = raw_harmonics(set, degree);
  OrthonormalFunctions functions(set.directions().size(), harmonic_count(space_, degree));
  // Every set is exact to degree 2: 1, x, y and z are orthonormal on it as they are.
  for (const int column : linear_columns(space_))
    if (column < raw.cols()) {
      functions.take(raw.col(column));
      degrees_.push_back(column == 0 ? 0 : 1);
    }
  // No more functions are independent than there are ordinates.
  for (int l = 2; l <= degree && count() < set.count(); ++l)
    for (int column = harmonic_count(space_, l - 1); column < harmonic_count(space_, l); ++column)
      if (functions.take_new_part(raw.col(column))) degrees_.push_back(l);

  for (std::size_t m = 0; m < set.directions().size(); ++m) {
    const double scale = std::sqrt(full_range(space_) / set.weights()[m]);
    const Vec3 first = std::sqrt(dimension(space_)) * set.directions()[m];
    for (int k = 0; k < count(); ++k)
      values_.push_back(k == 0 ? 1.0 : k <= dimension(space_) ? first[k - 1] : functions(k, m) * scale);
  }
}

DiscreteHarmonics complete_harmonics(const DirectionSet& set) {
  int degree = static_cast<int>(std::sqrt(set.count()));
  while (true) {
    DiscreteHarmonics harmonics(set, degree);
    if (harmonics.count() == set.count()) return harmonics;
    degree += std::max(1, degree / 4);
  }
}

int DiscreteHarmonics::full_degree() const {
  int degree = 0;
  const auto complete = [this](int l) {
    return std::count(degrees_.begin(), degrees_.end(), l) ==
           harmonic_count(space_, l) - harmonic_count(space_, l - 1);
  };
  while (complete(degree + 1)) ++degree;
  return degree;
}

}  // namespace etendue
