// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "solver/radiosity/exchange/exchange.h"
#include "solver/radiosity/patches/patch_tree.h"

namespace etendue {

/// Where links stay.
struct LinkRule {
  /// A link stays where what it may be wrong by brings less than this part of the mean irradiance of all
  /// walls to any place.
  double tolerance = 3e-4;
  /// [patch] What patches send out, of the mean irradiance: known roughly before. At least 1 is taken, which
  /// bounds the error of form factors too.
  std::vector<double> brightness;
};

/// Exchange between nodes of a tree of patches: a link means that all patches of one node exchange with all
/// of the other by one kernel, G_jk = k(x_j, x_k) A_j A_k (Hanrahan, Salzman, Aupperle 1991; there it is
/// constant, here linear in both places, node_kernel(), and the tree is joined upwards from patches, so that
/// it serves many small faces too). A link is split where the kernel is too far from that between the samples
/// of both nodes, times what the node sends (their BF refinement), or where something blocks a part of the
/// paths; between single patches it is the exchange area. Both directions are one link: the matrix that it
/// stands for is symmetric. Links and time are about in proportion to patches.
class ExchangeLinks : public Exchange {
 public:
  /// The patches must outlive it.
  ExchangeLinks(const std::vector<FlatPatch>& patches, const LinkRule& rule, int rays, int threads,
                const FactorProgress& progress = {});

  /// Splits the links that do not stay by the rule if patches send this [patch], until all that is left do;
  /// returns how many were split. If any were, rows are no longer closed.
  std::size_t refine(const std::vector<double>& brightness, const FactorProgress& progress = {});

  std::size_t link_count() const { return links_.size(); }
  /// About so many links has an exchange, where every patch sees most others.
  static std::size_t likely_count(std::size_t patches, double tolerance);
  /// Bytes that so many links take, with what it takes to make them.
  static std::size_t bytes_of(std::size_t links);

 private:
  /// A link, or a pair of nodes that is to be examined.
  struct Link {
    std::int32_t a, b;
    float mean = 0;  ///< [1/length^2]
    std::array<float, 3> slope_a{}, slope_b{};
    float most_sent = 0;  ///< power of its stronger node up to which it stays
  };
  enum class Verdict : std::uint8_t { nothing, idle, link, split };

  std::vector<double> powers(const std::vector<double>& brightness) const;
  double strongest(const Link& pair, const std::vector<double>& power) const;
  void find_links(std::vector<Link> open, const std::vector<double>& power, const FactorProgress& progress);
  Verdict judge(Link& link, const std::vector<double>& power) const;
  void split(const Link& pair, std::vector<Link>& open) const;
  void sort_links();
  std::vector<double> found_row(std::size_t j) const override;
  std::vector<double> found_times(std::span<const double> x, std::size_t bands) const override;

  PatchTree tree_;
  double tolerance_;
  std::vector<Link> links_;
  std::vector<Link> idle_;               ///< pairs that exchange nothing as far as the tolerance looks
  std::vector<std::size_t> begin_;       ///< [node and one more] of its places in of_nodes_
  std::vector<std::uint32_t> of_nodes_;  ///< links, node by node
};

}  // namespace etendue
