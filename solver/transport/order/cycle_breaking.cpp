// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/cycle_breaking.h"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

namespace etendue {
namespace {

/// Edges by the node they leave (or enter): compressed rows of edge numbers.
struct Adjacency {
  std::vector<std::int32_t> start;
  std::vector<std::int32_t> edge;

  Adjacency(std::int32_t nodes, const std::vector<FlowEdge>& edges, std::int32_t FlowEdge::*end)
      : start(static_cast<std::size_t>(nodes) + 1, 0), edge(edges.size()) {
    for (const FlowEdge& e : edges) ++start[static_cast<std::size_t>(e.*end) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::int32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < edges.size(); ++i)
      edge[static_cast<std::size_t>(next[static_cast<std::size_t>(edges[i].*end)]++)] =
          static_cast<std::int32_t>(i);
  }
};

/// Position of each node of a component in the sequence of Eades, Lin and Smyth: sources first, sinks last,
/// and between them the node with the largest surplus of leaving over entering weight.
class GreedySequence {
 public:
  GreedySequence(std::int32_t nodes, const std::vector<FlowEdge>& edges)
      : edges_(edges),
        leaving_(nodes, edges, &FlowEdge::from),
        entering_(nodes, edges, &FlowEdge::to),
        surplus_(static_cast<std::size_t>(nodes), 0),
        out_(static_cast<std::size_t>(nodes), 0),
        in_(static_cast<std::size_t>(nodes), 0) {
    for (const FlowEdge& e : edges) {
      surplus_[static_cast<std::size_t>(e.from)] += e.weight;
      surplus_[static_cast<std::size_t>(e.to)] -= e.weight;
      ++out_[static_cast<std::size_t>(e.from)];
      ++in_[static_cast<std::size_t>(e.to)];
    }
    for (std::int32_t v = 0; v < nodes; ++v) left_.emplace(rank(v), v);
  }

  std::vector<std::int32_t> positions() {
    std::vector<std::int32_t> position(surplus_.size(), 0);
    std::int32_t first = 0;
    std::int32_t last = static_cast<std::int32_t>(surplus_.size()) - 1;
    while (!left_.empty()) {
      const std::int32_t node = left_.begin()->second;
      const bool sink = out_[static_cast<std::size_t>(node)] == 0;
      position[static_cast<std::size_t>(node)] = sink ? last-- : first++;
      remove(node);
    }
    return position;
  }

 private:
  /// Sinks, then sources, then by falling surplus.
  std::pair<int, double> rank(std::int32_t v) const {
    const auto i = static_cast<std::size_t>(v);
    return {out_[i] == 0 ? 0 : in_[i] == 0 ? 1 : 2, -surplus_[i]};
  }

  void remove(std::int32_t node) {
    left_.erase({rank(node), node});
    gone_.insert(node);
    update(leaving_, node, &FlowEdge::to, in_, +1);
    update(entering_, node, &FlowEdge::from, out_, -1);
  }

  void update(const Adjacency& rows, std::int32_t node, std::int32_t FlowEdge::*other,
              std::vector<std::int32_t>& degree, int sign) {
    const auto row = static_cast<std::size_t>(node);
    for (std::int32_t k = rows.start[row]; k < rows.start[row + 1]; ++k) {
      const FlowEdge& e = edges_[static_cast<std::size_t>(rows.edge[static_cast<std::size_t>(k)])];
      const std::int32_t neighbour = e.*other;
      if (gone_.contains(neighbour)) continue;
      left_.erase({rank(neighbour), neighbour});
      surplus_[static_cast<std::size_t>(neighbour)] += sign * e.weight;
      --degree[static_cast<std::size_t>(neighbour)];
      left_.emplace(rank(neighbour), neighbour);
    }
  }

  const std::vector<FlowEdge>& edges_;
  Adjacency leaving_;
  Adjacency entering_;
  std::vector<double> surplus_;
  std::vector<std::int32_t> out_;
  std::vector<std::int32_t> in_;
  std::set<std::pair<std::pair<int, double>, std::int32_t>> left_;
  std::set<std::int32_t> gone_;
};

/// The edges inside one component, with its nodes numbered from zero.
struct ComponentGraph {
  std::int32_t nodes = 0;
  std::vector<FlowEdge> edges;
};

}  // namespace

std::vector<std::int32_t> strong_components(std::int32_t nodes, const std::vector<FlowEdge>& edges) {
  const Adjacency leaving(nodes, edges, &FlowEdge::from);
  const auto size = static_cast<std::size_t>(nodes);
  std::vector<std::int32_t> component(size, -1), index(size, -1), low(size, 0), next(size, 0), stack, path;
  std::int32_t visited = 0, components = 0;
  const auto enter = [&](std::int32_t node) {
    const auto i = static_cast<std::size_t>(node);
    index[i] = low[i] = visited++;
    next[i] = leaving.start[i];
    stack.push_back(node);
    path.push_back(node);
  };
  // Depth first without recursion: a mesh has longer paths than the call stack.
  for (std::int32_t root = 0; root < nodes; ++root) {
    if (index[static_cast<std::size_t>(root)] < 0) enter(root);
    while (!path.empty()) {
      const auto v = static_cast<std::size_t>(path.back());
      if (next[v] < leaving.start[v + 1]) {
        const auto e = static_cast<std::size_t>(leaving.edge[static_cast<std::size_t>(next[v]++)]);
        const auto w = static_cast<std::size_t>(edges[e].to);
        if (index[w] < 0) {
          enter(edges[e].to);
        } else if (component[w] < 0) {
          low[v] = std::min(low[v], index[w]);
        }
        continue;
      }
      path.pop_back();
      if (!path.empty()) {
        const auto parent = static_cast<std::size_t>(path.back());
        low[parent] = std::min(low[parent], low[v]);
      }
      if (low[v] != index[v]) continue;
      std::int32_t member;
      do {
        member = stack.back();
        stack.pop_back();
        component[static_cast<std::size_t>(member)] = components;
      } while (static_cast<std::size_t>(member) != v);
      ++components;
    }
  }
  return component;
}

std::vector<std::int32_t> feedback_faces(std::int32_t nodes, const std::vector<FlowEdge>& edges) {
  const std::vector<std::int32_t> component = strong_components(nodes, edges);
  const std::int32_t components =
      component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  std::vector<ComponentGraph> graphs(static_cast<std::size_t>(components));
  std::vector<std::int32_t> local(static_cast<std::size_t>(nodes));
  for (std::size_t v = 0; v < local.size(); ++v)
    local[v] = graphs[static_cast<std::size_t>(component[v])].nodes++;
  for (const FlowEdge& e : edges) {
    const std::int32_t own = component[static_cast<std::size_t>(e.from)];
    if (own != component[static_cast<std::size_t>(e.to)]) continue;
    graphs[static_cast<std::size_t>(own)].edges.push_back(
        {local[static_cast<std::size_t>(e.from)], local[static_cast<std::size_t>(e.to)], e.weight, e.face});
  }
  std::vector<std::int32_t> faces;
  for (const ComponentGraph& graph : graphs) {
    if (graph.edges.empty()) continue;
    const std::vector<std::int32_t> position = GreedySequence(graph.nodes, graph.edges).positions();
    for (const FlowEdge& e : graph.edges)
      if (position[static_cast<std::size_t>(e.from)] > position[static_cast<std::size_t>(e.to)])
        faces.push_back(e.face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace etendue
