// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/transport/order/batch_sections.h"
#include "solver/transport/sweep/batch_workspace.h"
#include "solver/transport/sweep/moment_operators.h"
#include "solver/transport/sweep/section_sums.h"
#include "solver/transport/sweep/sweep_pass.h"

namespace etendue {

/// Sum of the batches of one sweep: adds fluence, moments, irradiance and what is recorded to the next state
/// and the record, batch after batch in each section, and the sections in a binary tree, so that the bits
/// depend neither on the number of threads nor on that of ranks.
///
/// The sums of sections that wait for their siblings form a stack, of which the lowest has its arrays in the
/// next state.
template <class Real>
class BatchReduction {
 public:
  using Workspaces = std::span<const std::unique_ptr<BatchWorkspace<Real>>>;

  /// The arguments must outlive it. `waiting` serves one sweep after the other; `seconds` counts the
  /// processor time.
  BatchReduction(const Discretization& discretization, MomentOperators<Real>& moments,
                 WaitingSections& waiting, const SweepPass& pass, int threads, double& seconds);

  /// The batches of this rank in the order in which they are added.
  std::int32_t first_batch() const { return next_batch_; }
  std::int32_t end_batch() const { return sections_.begin(end_section_); }
  /// Adds the next ones of them, one from each of the workspaces, and sets their sums to zero.
  void add(Workspaces workspaces);
  /// Adds the sums of all ranks, once each has added its batches, or wants to stop: then throws SweepStopped.
  void finish(bool stops);

 private:
  /// Neighbouring batches of one section.
  struct Portion {
    Workspaces workspaces;
    bool begins, ends;  ///< the section
  };

  /// Parts of the next state of which each entry is of one ordinate: zero at first where it is that of
  /// another rank, which brings it in the end.
  std::array<std::span<double>, 3> parts_by_ordinate() const;
  void add_portion(const Portion& portion);
  /// Adds arrays of workspaces to that of the section, and that of a section that ends to its sibling's.
  template <class Number, class ArrayOf>
  void add_arrays(const Portion& portion, std::span<double> SummedArrays::*array, const ArrayOf& array_of);
  void add_moments(const Portion& portion);
  /// Puts the section that has ended on the stack and adds up what are siblings there.
  void end_section();
  /// Adds the arrays at a place of the stack to those at the place below.
  void add_to_lower(std::size_t place);
  /// Whether the sibling of the section is on the stack.
  bool completes_pair() const { return !stack_.empty() && are_siblings(stack_.back(), {0, 0, section_}); }
  /// Arrays of a place in the stack.
  SummedArrays arrays(std::size_t place, bool with_moments);

  const Discretization& d_;
  MomentOperators<Real>& moments_;
  WaitingSections& waiting_;
  const SweepPass& pass_;
  SummedArrays sums_;  ///< of the sweep
  RankGroup* ranks_;
  int threads_;
  double& seconds_;
  BatchSections sections_;
  std::int32_t section_;      ///< of the next batch
  std::int32_t end_section_;  ///< of this rank's
  std::int32_t next_batch_;
  std::vector<SumNode> stack_;
};

extern template class BatchReduction<double>;
extern template class BatchReduction<float>;

}  // namespace etendue
