// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/cycle_breaking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace etendue::cycle_breaking_test {
namespace {

bool has_cycle(std::int32_t nodes, const std::vector<FlowEdge>& edges) {
  const auto component = strong_components(nodes, edges);
  return std::any_of(edges.begin(), edges.end(), [&](const FlowEdge& e) {
    return component[static_cast<std::size_t>(e.from)] == component[static_cast<std::size_t>(e.to)];
  });
}

std::vector<FlowEdge> without(const std::vector<FlowEdge>& edges, const std::vector<std::int32_t>& faces) {
  std::vector<FlowEdge> rest;
  for (const FlowEdge& e : edges)
    if (!std::binary_search(faces.begin(), faces.end(), e.face)) rest.push_back(e);
  return rest;
}

TEST(CycleBreaking, FindsTheComponentsOfTwoRingsJoinedByABridge) {
  const std::vector<FlowEdge> edges{{0, 1, 1, 0}, {1, 2, 1, 1}, {2, 0, 1, 2},
                                    {2, 3, 1, 3}, {3, 4, 1, 4}, {4, 3, 1, 5}};
  const auto component = strong_components(5, edges);
  EXPECT_EQ(component[0], component[1]);
  EXPECT_EQ(component[0], component[2]);
  EXPECT_EQ(component[3], component[4]);
  EXPECT_NE(component[0], component[3]);
}

TEST(CycleBreaking, CutsTheLightestEdgeOfARing) {
  const std::vector<FlowEdge> edges{{0, 1, 5, 10}, {1, 2, 0.1, 11}, {2, 3, 5, 12}, {3, 0, 5, 13}};
  EXPECT_EQ(feedback_faces(4, edges), std::vector<std::int32_t>{11});
}

TEST(CycleBreaking, LeavesAcyclicGraphsAlone) {
  const std::vector<FlowEdge> edges{{0, 1, 1, 0}, {0, 2, 1, 1}, {1, 3, 1, 2}, {2, 3, 1, 3}};
  EXPECT_TRUE(feedback_faces(4, edges).empty());
}

TEST(CycleBreaking, LeavesNoCycleInRandomGraphs) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<FlowEdge> edges;
    std::uniform_int_distribution<std::int32_t> node(0, 39);
    std::uniform_real_distribution<double> weight(0, 1);
    for (std::int32_t f = 0; f < 100; ++f) {
      const FlowEdge e{node(random), node(random), weight(random), f};
      if (e.from != e.to) edges.push_back(e);
    }
    const auto faces = feedback_faces(40, edges);
    EXPECT_FALSE(has_cycle(40, without(edges, faces)));
    EXPECT_LT(faces.size(), edges.size() / 2);
  }
}

}  // namespace
}  // namespace etendue::cycle_breaking_test
