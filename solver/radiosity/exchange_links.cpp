// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange_links.h"

#include <algorithm>
#include <cmath>

#include "solver/radiosity/exchange_area.h"
#include "solver/radiosity/node_exchange.h"

namespace etendue {
namespace {

// Pairs that are judged side by side: enough for all threads, few enough to take no memory.
constexpr std::size_t pairs_at_once = 1 << 15;
// Measured, in a cube and in a room with a crate.
constexpr double links_of_a_patch = 1.5;

}  // namespace

ExchangeLinks::ExchangeLinks(const std::vector<FlatPatch>& patches, const LinkRule& rule, int rays,
                             int threads, const FactorProgress& progress)
    : Exchange(patches, rays, threads), tree_(patches) {
  find_links(rule, progress);
  sort_links();
}

// A node of radius r has links to those at distances R at which the kernel is linear to the tolerance:
// (r/R)^4, and there are some (R/r)^2 of these.
std::size_t ExchangeLinks::likely_count(std::size_t patches, double tolerance) {
  const auto count = static_cast<double>(patches);
  return static_cast<std::size_t>(count * std::min(count / 2, links_of_a_patch * std::pow(tolerance, -0.5)));
}

std::size_t ExchangeLinks::bytes_of(std::size_t links) {
  return links * (sizeof(Link) + 2 * sizeof(std::uint32_t));
}

// Pairs are judged in the same order for any number of threads.
void ExchangeLinks::find_links(const LinkRule& rule, const FactorProgress& progress) {
  const std::vector<PatchNode>& nodes = tree_.nodes();
  std::vector<double> power(nodes.size(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (const std::int32_t p : tree_.patches_of(nodes[n]))
      power[n] += patches()[static_cast<std::size_t>(p)].area() *
                  std::max(1.0, rule.brightness[static_cast<std::size_t>(p)]);
  const auto extent = [&](const Link& pair) {
    return (pair.a == pair.b ? 1 : 2) * nodes[static_cast<std::size_t>(pair.a)].area *
           nodes[static_cast<std::size_t>(pair.b)].area;
  };
  std::vector<Link> open = {{0, 0}}, batch;
  std::vector<Verdict> verdicts;
  const double all = extent(open[0]);
  double done = 0;
  while (!open.empty()) {
    const std::size_t count = std::min(open.size(), pairs_at_once);
    batch.assign(open.end() - static_cast<std::ptrdiff_t>(count), open.end());
    open.resize(open.size() - count);
    verdicts.assign(count, Verdict::nothing);
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads())
    for (std::size_t i = 0; i < count; ++i) verdicts[i] = judge(batch[i], power, rule.tolerance);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t a = batch[i].a, b = batch[i].b;
      const PatchNode &first = nodes[static_cast<std::size_t>(a)],
                      &second = nodes[static_cast<std::size_t>(b)];
      if (verdicts[i] != Verdict::split) {
        done += extent(batch[i]);
        if (verdicts[i] == Verdict::link) links_.push_back(batch[i]);
      } else if (a == b) {
        open.push_back({first.children, first.children});
        open.push_back({first.children, first.children + 1});
        open.push_back({first.children + 1, first.children + 1});
      } else if (second.is_patch() || (!first.is_patch() && first.radius > second.radius)) {
        open.push_back({first.children, b});
        open.push_back({first.children + 1, b});
      } else {
        open.push_back({a, second.children});
        open.push_back({a, second.children + 1});
      }
    }
    if (progress) progress(done / all);
  }
}

ExchangeLinks::Verdict ExchangeLinks::judge(Link& link, const std::vector<double>& power,
                                            double tolerance) const {
  const auto a = static_cast<std::size_t>(link.a), b = static_cast<std::size_t>(link.b);
  const PatchNode &first = tree_.nodes()[a], &second = tree_.nodes()[b];
  const bool last = first.is_patch() && second.is_patch();
  if (a == b) return last ? Verdict::nothing : Verdict::split;
  if (are_behind(first, second)) return Verdict::nothing;
  NodeKernel kernel = node_kernel(first, second);
  const double sent = std::max(power[a], power[b]);
  const double deviation = last ? kernel.variation : kernel.residual;
  const bool fits = are_apart(first, second) && deviation * sent <= tolerance;
  if (!fits && !last) return Verdict::split;
  if (!fits)
    kernel.mean = exchange_area(patches()[static_cast<std::size_t>(tree_.patches_of(first)[0])],
                                patches()[static_cast<std::size_t>(tree_.patches_of(second)[0])]) /
                  (first.area * second.area);
  if (kernel.mean <= 0) return Verdict::nothing;
  const double share = visibility().share(tree_, a, b);
  // What one of its parts may see more, or less, than the whole.
  if (!last && kernel.mean * std::min(share, 1 - share) * sent > tolerance) return Verdict::split;
  link.mean = static_cast<float>(share * kernel.mean);
  for (Eigen::Index x = 0; x < 3; ++x) {
    link.slope_a[static_cast<std::size_t>(x)] = static_cast<float>(share * kernel.slope_a[x]);
    link.slope_b[static_cast<std::size_t>(x)] = static_cast<float>(share * kernel.slope_b[x]);
  }
  return share > 0 ? Verdict::link : Verdict::nothing;
}

void ExchangeLinks::sort_links() {
  begin_.assign(tree_.nodes().size() + 1, 0);
  for (const Link& link : links_)
    for (const std::int32_t node : {link.a, link.b}) ++begin_[static_cast<std::size_t>(node) + 1];
  for (std::size_t n = 1; n < begin_.size(); ++n) begin_[n] += begin_[n - 1];
  of_nodes_.resize(2 * links_.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < links_.size(); ++i)
    for (const std::int32_t node : {links_[i].a, links_[i].b})
      of_nodes_[next[static_cast<std::size_t>(node)]++] = static_cast<std::uint32_t>(i);
}

std::vector<double> ExchangeLinks::found_row(std::size_t j) const {
  std::vector<double> unit(size(), 0);
  unit[j] = 1;
  return found_times(unit, 1);
}

// Pull: what nodes send, and its moment about their centres; links: what arrives at nodes, and its slope
// there; push: what arrives at their patches. Four numbers for each node and band.
std::vector<double> ExchangeLinks::found_times(std::span<const double> x, std::size_t bands) const {
  const std::vector<PatchNode>& nodes = tree_.nodes();
  const auto patch_of = [&](const PatchNode& node) {
    return static_cast<std::size_t>(tree_.patches_of(node)[0]);
  };
  using Four = std::array<double, 4>;
  std::vector<Four> sent(nodes.size() * bands, Four{}), incident = sent;
  for (std::size_t n = nodes.size(); n-- > 0;)
    for (std::size_t b = 0; b < bands; ++b) {
      Four& whole = sent[n * bands + b];
      if (nodes[n].is_patch()) {
        whole[0] = nodes[n].area * x[patch_of(nodes[n]) * bands + b];
        continue;
      }
      for (const std::int32_t child : {nodes[n].children, nodes[n].children + 1}) {
        const auto c = static_cast<std::size_t>(child);
        const Vec3 way = nodes[c].center - nodes[n].center;
        const Four& part = sent[c * bands + b];
        whole[0] += part[0];
        for (std::size_t i = 0; i < 3; ++i)
          whole[i + 1] += part[i + 1] + way[static_cast<Eigen::Index>(i)] * part[0];
      }
    }
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads())
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t place = begin_[n]; place < begin_[n + 1]; ++place) {
      const Link& link = links_[of_nodes_[place]];
      const bool is_a = static_cast<std::size_t>(link.a) == n;
      const auto other = static_cast<std::size_t>(is_a ? link.b : link.a);
      const std::array<float, 3>&here = is_a ? link.slope_a : link.slope_b,
                              &there = is_a ? link.slope_b : link.slope_a;
      for (std::size_t b = 0; b < bands; ++b) {
        const Four& from = sent[other * bands + b];
        Four& to = incident[n * bands + b];
        to[0] += static_cast<double>(link.mean) * from[0];
        for (std::size_t i = 0; i < 3; ++i) {
          to[0] += static_cast<double>(there[i]) * from[i + 1];
          to[i + 1] += static_cast<double>(here[i]) * from[0];
        }
      }
    }
  std::vector<double> result(x.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t b = 0; b < bands; ++b) {
      const Four whole = incident[n * bands + b];
      if (nodes[n].is_patch()) {
        result[patch_of(nodes[n]) * bands + b] = nodes[n].area * whole[0];
        continue;
      }
      for (const std::int32_t child : {nodes[n].children, nodes[n].children + 1}) {
        const auto c = static_cast<std::size_t>(child);
        const Vec3 way = nodes[c].center - nodes[n].center;
        Four& part = incident[c * bands + b];
        part[0] += whole[0];
        for (std::size_t i = 0; i < 3; ++i) {
          part[0] += way[static_cast<Eigen::Index>(i)] * whole[i + 1];
          part[i + 1] += whole[i + 1];
        }
      }
    }
  return result;
}

}  // namespace etendue
