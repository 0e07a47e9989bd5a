// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/exchange_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/radiosity/exchange/node_exchange.h"
#include "solver/radiosity/form_factors/exchange_area.h"

namespace etendue {
namespace {

// Pairs that are judged side by side: enough for all threads, few enough to take no memory.
constexpr std::size_t pairs_at_once = 1 << 15;
// Measured, in a cube and in a room with a crate.
constexpr double links_of_a_patch = 1.5;
// Of what a link holds in single precision.
constexpr double link_rounding = 1e-6;

}  // namespace

ExchangeLinks::ExchangeLinks(const std::vector<FlatPatch>& patches, const LinkRule& rule, int rays,
                             int threads, const FactorProgress& progress)
    : Exchange(patches, rays, threads), tree_(patches), tolerance_(rule.tolerance) {
  find_links({{0, 0}}, powers(rule.brightness), progress);
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

// [node] What its patches send.
std::vector<double> ExchangeLinks::powers(const std::vector<double>& brightness) const {
  std::vector<double> power(tree_.nodes().size(), 0);
  for (std::size_t n = 0; n < power.size(); ++n)
    for (const std::int32_t p : tree_.patches_of(tree_.nodes()[n]))
      power[n] += patches()[static_cast<std::size_t>(p)].area() *
                  std::max(1.0, brightness[static_cast<std::size_t>(p)]);
  return power;
}

double ExchangeLinks::strongest(const Link& pair, const std::vector<double>& power) const {
  return std::max(power[static_cast<std::size_t>(pair.a)], power[static_cast<std::size_t>(pair.b)]);
}

std::size_t ExchangeLinks::refine(const std::vector<double>& brightness, const FactorProgress& progress) {
  const std::vector<double> power = powers(brightness);
  const auto stays = [&](const Link& link) {
    return strongest(link, power) <= (1 + link_rounding) * link.most_sent;
  };
  std::vector<Link> open;
  std::size_t count = 0;
  for (std::vector<Link>* list : {&links_, &idle_}) {
    const auto weak = std::stable_partition(list->begin(), list->end(), stays);
    std::for_each(weak, list->end(), [&](const Link& link) { split(link, open); });
    count += static_cast<std::size_t>(list->end() - weak);
    list->erase(weak, list->end());
  }
  if (count == 0) return 0;
  find_links(std::move(open), power, progress);
  sort_links();
  reopen();
  return count;
}

// Pairs are judged in the same order for any number of threads.
void ExchangeLinks::find_links(std::vector<Link> open, const std::vector<double>& power,
                               const FactorProgress& progress) {
  const std::vector<PatchNode>& nodes = tree_.nodes();
  const auto extent = [&](const Link& pair) {
    return (pair.a == pair.b ? 1 : 2) * nodes[static_cast<std::size_t>(pair.a)].area *
           nodes[static_cast<std::size_t>(pair.b)].area;
  };
  double all = 0, done = 0;
  for (const Link& pair : open) all += extent(pair);
  std::vector<Link> batch;
  std::vector<Verdict> verdicts;
  while (!open.empty()) {
    const std::size_t count = std::min(open.size(), pairs_at_once);
    batch.assign(open.end() - static_cast<std::ptrdiff_t>(count), open.end());
    open.resize(open.size() - count);
    verdicts.assign(count, Verdict::nothing);
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads())
    for (std::size_t i = 0; i < count; ++i) verdicts[i] = judge(batch[i], power);
    for (std::size_t i = 0; i < count; ++i) {
      if (verdicts[i] == Verdict::split) {
        split(batch[i], open);
        continue;
      }
      done += extent(batch[i]);
      if (verdicts[i] == Verdict::link) links_.push_back(batch[i]);
      if (verdicts[i] == Verdict::idle) idle_.push_back(batch[i]);
    }
    if (progress) progress(done / all);
  }
}

void ExchangeLinks::split(const Link& pair, std::vector<Link>& open) const {
  const PatchNode &first = tree_.nodes()[static_cast<std::size_t>(pair.a)],
                  &second = tree_.nodes()[static_cast<std::size_t>(pair.b)];
  if (first.is_patch() && second.is_patch()) {
    open.push_back({pair.a, pair.b});
  } else if (pair.a == pair.b) {
    open.push_back({first.children, first.children});
    open.push_back({first.children, first.children + 1});
    open.push_back({first.children + 1, first.children + 1});
  } else if (second.is_patch() || (!first.is_patch() && first.radius > second.radius)) {
    open.push_back({first.children, pair.b});
    open.push_back({first.children + 1, pair.b});
  } else {
    open.push_back({pair.a, second.children});
    open.push_back({pair.a, second.children + 1});
  }
}

ExchangeLinks::Verdict ExchangeLinks::judge(Link& link, const std::vector<double>& power) const {
  const auto a = static_cast<std::size_t>(link.a), b = static_cast<std::size_t>(link.b);
  const PatchNode &first = tree_.nodes()[a], &second = tree_.nodes()[b];
  const bool last = first.is_patch() && second.is_patch();
  if (a == b) return last ? Verdict::nothing : Verdict::split;
  if (are_behind(first, second)) return Verdict::nothing;
  NodeKernel kernel = node_kernel(first, second);
  const double sent = strongest(link, power);
  const double deviation = last ? kernel.variation : kernel.residual;
  const bool fits = are_apart(first, second) && deviation * sent <= tolerance_;
  if (!fits && !last) return Verdict::split;
  if (!fits)
    kernel.mean = exchange_area(patches()[static_cast<std::size_t>(tree_.patches_of(first)[0])],
                                patches()[static_cast<std::size_t>(tree_.patches_of(second)[0])]) /
                  (first.area * second.area);
  const double share = kernel.mean > 0 ? visibility().share(tree_, a, b) : 0;
  // What one of its parts may see more, or less, than the whole.
  const double shaded = kernel.mean * std::min(share, 1 - share);
  if (!last && shaded * sent > tolerance_) return Verdict::split;
  // Between patches the rays tell what they can, and where the kernel is not good enough it is the exchange
  // area.
  const double wrong = last ? (fits ? deviation : 0) : std::max(deviation, shaded);
  link.most_sent =
      wrong > 0 ? static_cast<float>(tolerance_ / wrong) : std::numeric_limits<float>::infinity();
  if (share <= 0) return wrong > 0 ? Verdict::idle : Verdict::nothing;
  link.mean = static_cast<float>(share * kernel.mean);
  for (Eigen::Index x = 0; x < 3; ++x) {
    link.slope_a[static_cast<std::size_t>(x)] = static_cast<float>(share * kernel.slope_a[x]);
    link.slope_b[static_cast<std::size_t>(x)] = static_cast<float>(share * kernel.slope_b[x]);
  }
  return Verdict::link;
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

// Pull: what nodes send, and its moment about their centres; links: the incident power of nodes, and its
// slope there; push: that of their patches. Four numbers for each node and band.
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
        const Vec3 separation = nodes[c].center - nodes[n].center;
        const Four& part = sent[c * bands + b];
        whole[0] += part[0];
        for (std::size_t i = 0; i < 3; ++i)
          whole[i + 1] += part[i + 1] + separation[static_cast<Eigen::Index>(i)] * part[0];
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
        const Vec3 separation = nodes[c].center - nodes[n].center;
        Four& part = incident[c * bands + b];
        part[0] += whole[0];
        for (std::size_t i = 0; i < 3; ++i) {
          part[0] += separation[static_cast<Eigen::Index>(i)] * whole[i + 1];
          part[i + 1] += whole[i + 1];
        }
      }
    }
  return result;
}

}  // namespace etendue
