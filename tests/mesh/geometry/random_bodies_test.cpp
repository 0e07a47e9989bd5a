// SPDX-License-Identifier: AGPL-3.0-or-later
// Bodies that touch, overlap, and nearly do: every scene must be meshed, or refused with a message, in time.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/geometry/scene.h"

namespace etendue::random_bodies_test {
namespace {

constexpr int kScenes = 40;
constexpr double kMostSeconds = 20;           // of the processor
constexpr int kFewCells = 100'000;            // a tenth of what is allowed without a limit
constexpr double kMostCellsOfStrips = 1.2e6;  // 825,000 of them

const Vec3 kRoom(4, 3, 2.5);

/// Bodies in a room whose coordinates are often those of earlier ones, but for a gap of 0 or 1e-12 to 1e-4.
class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

  Geometry scene() {
    Geometry geometry{{box("room", Vec3::Zero(), kRoom)}, {}};
    for (int axis = 0; axis < 3; ++axis) known_[static_cast<std::size_t>(axis)] = {0, kRoom[axis]};
    const int bodies = whole(2, 4);
    for (int i = 0; i < bodies; ++i) geometry.primitives.push_back(body());
    return geometry;
  }

 private:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

  double gap() { return whole(0, 1) == 0 ? 0 : (whole(0, 1) ? 1 : -1) * std::pow(10.0, whole(-12, -4)); }

  /// Mostly of furniture, now and then of a wire.
  double size() { return std::pow(10.0, whole(0, 9) == 0 ? uniform(-6, -1) : uniform(-1, 0)); }

  double coordinate(int axis) {
    std::vector<double>& known = known_[static_cast<std::size_t>(axis)];
    const double value =
        whole(0, 1) == 0
            ? uniform(0, kRoom[axis])
            : known[static_cast<std::size_t>(whole(0, static_cast<int>(known.size()) - 1))] + gap();
    known.push_back(value);
    return value;
  }

  Vec3 place() { return {coordinate(0), coordinate(1), coordinate(2)}; }

  Primitive body() {
    const bool hole = whole(0, 3) == 0;
    const std::string name(1, "abc"[whole(0, 2)]);
    const int kind = whole(0, 3);
    const Vec3 from = place();
    const double radius = size() / 2;
    if (kind == 2) {
      const int facets = whole(0, 1) == 0 ? 80 : 320;
      return hole ? sphere_hole(name, from, radius, facets) : sphere(name, from, radius, facets);
    }
    if (kind == 3) {
      const Vec3 to = from + size() * (whole(0, 1) == 0 ? Vec3::Unit(whole(0, 2)) : Vec3(0.6, 0, 0.8));
      const int facets = whole(3, 24);
      return hole ? cylinder_hole(name, from, to, radius, facets) : cylinder(name, from, to, radius, facets);
    }
    Vec3 to;
    for (int axis = 0; axis < 3; ++axis) {
      to[axis] = from[axis] + size();
      known_[static_cast<std::size_t>(axis)].push_back(to[axis]);
    }
    return hole ? box_hole(name, from, to) : box(name, from, to);
  }

  std::mt19937 random_;
  std::array<std::vector<double>, 3> known_;  ///< [axis] coordinates so far
};

/// Time of the processor that this process and its children have taken [s].
double processor_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    seconds += static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
               1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }
  return seconds;
}

struct Attempt {
  std::string message;  ///< empty: meshed
  double seconds;       ///< of the processor
  double cells = 0;     ///< where meshed
  double seconds_per_cell() const { return seconds / cells; }
};

Attempt attempt(const Geometry& geometry, const TetrahedraOptions& options) {
  const double begun = processor_seconds();
  Attempt tried{};
  try {
    const TetrahedralMesh mesh(tetrahedralize(arrange(geometry), options));
    tried.cells = mesh.cell_count();
  } catch (const InputError& error) {
    tried.message = error.what();
  }
  tried.seconds = processor_seconds() - begun;
  return tried;
}

Attempt attempt(const Geometry& geometry, int max_cells) {
  return attempt(geometry, {{}, 1.4, {}, max_cells});
}

TEST(RandomBodies, AreMeshedOrRefusedInTime) {
  int meshed = 0;  // the others are refused: attempt() takes no other end
  for (int scene = 0; scene < kScenes; ++scene) {
    const Attempt tried = attempt(SceneMaker(static_cast<unsigned>(scene)).scene(), kFewCells);
    EXPECT_LT(tried.seconds, kMostSeconds) << "scene " << scene << " " << tried.message;
    if (tried.message.empty()) ++meshed;
  }
  RecordProperty("meshed", meshed);
  EXPECT_GE(meshed, kScenes / 4);
}

TEST(RandomBodies, StripsOfAThousandthAreMeshed) {
  const Attempt tried = attempt({{box("room", Vec3::Zero(), kRoom),
                                  box("a", {0.4716748146842442, 2.282887334737727, 0.15776705471927333},
                                      {2.276815499288849, 2.4067951835045505, 1.1806131089402916}),
                                  box("c", {0.3754383470969396, 0.08504242956601893, 0.005265133377776732},
                                      {1.7310682716202135, 2.286840247373826, 2.089412759799674})},
                                 {}},
                                0);
  EXPECT_EQ(tried.message, "");
  const Attempt plain =
      attempt({{box("room", Vec3::Zero(), kRoom)}, {}}, {{kRoom.prod() / 200'000}, 1.4, {}, 0});
  EXPECT_EQ(plain.message, "");
  // Its time is that of many cells, on a slow machine more than kMostSeconds; a cell costs 2.4 times that of
  // a plain room.
  EXPECT_LT(tried.cells, kMostCellsOfStrips);
  EXPECT_LT(tried.seconds_per_cell(), 4 * plain.seconds_per_cell());
}

TEST(RandomBodies, NeedlesAndThinStripsAreRefusedWithTheirPlace) {
  const Attempt needle =
      attempt({{box("room", Vec3::Zero(), kRoom),
                cylinder_hole("h1", {3.892, 1.331, 2.283}, {3.892, 1.331, 2.783}, 4.6e-6, 6)},
               {}},
              kFewCells);
  EXPECT_NE(needle.message.find("edges near (3.89"), std::string::npos) << needle.message;
  EXPECT_LT(needle.seconds, kMostSeconds);
  const Attempt strips =
      attempt({{box("room", Vec3::Zero(), kRoom), box_hole("h1", {0, 2.5, 2.5}, {0.5, 3.5, 3.5}),
                box("c", {0.0001, 2.4999, 2.5}, {0.5001, 3.5, 3.4999}), sphere("c", {0.8, 2.7, 2.7}, 0.3)},
               {}},
              kFewCells);
  EXPECT_NE(strips.message.find("details so fine that it needs more than"), std::string::npos)
      << strips.message;
  EXPECT_LT(strips.seconds, kMostSeconds);
}

}  // namespace
}  // namespace etendue::random_bodies_test
