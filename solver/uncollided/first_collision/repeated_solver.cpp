// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/repeated_solver.h"

#include "base/parallel/thread_count.h"
#include "solver/solution/following_emission.h"

namespace etendue {
namespace {

std::optional<FirstCollision> input_of(const UncollidedLight& uncollided, const DirectionSet& directions,
                                       const SolveOptions& options) {
  if (uncollided.lights().empty()) return std::nullopt;
  return std::make_optional<FirstCollision>(uncollided.lights(), uncollided.field(), directions,
                                            thread_count(options.threads));
}

SolveOptions with_input(SolveOptions options, const AngularInput* input) {
  options.angular_input = input;
  return options;
}

}  // namespace

RepeatedSolver::RepeatedSolver(const UncollidedLight& uncollided, const DirectionSet& directions,
                               const SolveOptions& options)
    : uncollided_(uncollided),
      directions_(directions),
      remaining_(uncollided.lights().remaining()),
      input_(input_of(uncollided, directions, options)),
      options_(with_input(options, input_ ? &*input_ : nullptr)),
      solver_(remaining_, directions, options_) {
  if (input_ && options.following_emission != nullptr)
    options.following_emission->set_unswept({uncollided.field().fluence, uncollided.field().irradiance, {}});
}

Solution RepeatedSolver::solve(const SolveObserver& observer) {
  swept_ = solver_.solve(observer);
  Solution whole = swept_;
  if (input_) uncollided_.complete(whole, options_);
  return whole;
}

void RepeatedSolver::read(const DirectionSetObserver& reader) const {
  if (reader) reader({directions_, kept_, options_.angular_input});
}

}  // namespace etendue
