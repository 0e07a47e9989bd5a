// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/error_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "solver/observe/camera/picture.h"
#include "solver/uncollided/first_collision/solve_rotated.h"
#include "tests/solver/transport/linear_fits.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::error_images_test {
namespace {

std::vector<CameraCase> cameras() {
  CameraCase camera;
  camera.camera.position = {0.45, -1.2, 0.6};
  camera.camera.look_at = {0.5, 0.5, 0.5};
  camera.camera.field_of_view = 40;
  camera.camera.pixels = {24, 18};
  camera.camera.errors = true;
  return {camera};
}

/// What an error scene makes of each pixel.
std::vector<double> layer(const RayRadiance& erring, const RayRadiance& scene) {
  const Camera camera = cameras().front().camera;
  std::vector<double> difference = take_picture(erring, camera, 1).radiance;
  const std::vector<double> picture = take_picture(scene, camera, 1).radiance;
  for (std::size_t i = 0; i < picture.size(); ++i) difference[i] = std::abs(difference[i] - picture[i]);
  return difference;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double smooth(const Vec3& p) { return 2 + std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + p.z() * p.z(); }

Vec3 slope(const Vec3& p) {
  return {3 * std::cos(3 * p.x() + 1) * std::cos(2 * p.y()),
          -2 * std::sin(3 * p.x() + 1) * std::sin(2 * p.y()), 2 * p.z()};
}

/// A smooth fluence as discontinuous elements have it at best.
SavedState elements_of(const TetrahedralMesh& mesh) {
  SavedState state;
  state.bands = 1;
  state.irradiance.assign(3 * static_cast<std::size_t>(mesh.boundary_face_count()), 0);
  state.fluence = linear_fits(mesh, smooth);
  return state;
}

/// Root mean squares over the picture: what the layer says, what the picture of the elements is off by, and
/// what is left of that when the picture of the quadratics stands for it.
struct SpaceError {
  double estimated;
  double true_one;
  double left;
};

/// From a point of the unit cube to where a ray leaves it.
double distance_through(const Vec3& from, const Vec3& direction) {
  double path_length = 2;
  for (int axis = 0; axis < 3; ++axis)
    if (direction[axis] != 0)
      path_length = std::min(path_length, ((direction[axis] > 0 ? 1 : 0) - from[axis]) / direction[axis]);
  return path_length;
}

/// The radiance along a ray through the cube, from where it comes in.
using ExactRadiance = std::function<double(const Vec3& start, const Vec3& direction)>;

/// Root mean squares of what the layer says, the picture is off by, and that of the error scene is.
SpaceError compare(const RayRadiance& scene, const RayRadiance& erring, const ExactRadiance& exact) {
  const Camera camera = cameras().front().camera;
  const CameraRays rays(camera);
  std::vector<double> off = take_picture(scene, camera, 1).radiance;
  std::vector<double> left = take_picture(erring, camera, 1).radiance;
  for (int row = 0; row < camera.pixels[1]; ++row)
    for (int column = 0; column < camera.pixels[0]; ++column) {
      const CameraRay ray = rays.through(column + 0.5, row + 0.5);
      const auto start = scene.enter(ray.origin, ray.direction);
      if (!start) continue;
      const double truth = exact(start->position, ray.direction);
      off[static_cast<std::size_t>(row * camera.pixels[0] + column)] -= truth;
      left[static_cast<std::size_t>(row * camera.pixels[0] + column)] -= truth;
    }
  return {root_mean_square(layer(erring, scene)), root_mean_square(off), root_mean_square(left)};
}

SpaceError space_error(double max_volume) {
  const TetrahedralMesh mesh = cube_mesh(max_volume);
  const Problem haze = uniform_problem(mesh, uniform_medium(1, 0.2, 1.5, 0), uniform_wall(1, 0, 0, 0));
  const LightSetup lights(haze);
  const DirectionSet directions = directions_product(2);
  const SolveOptions options = tight_options();
  const SavedState state = elements_of(mesh);
  const RayRadiance scene(lights, directions, options, state, 1);
  const ErrorImages errors(cameras(), lights, directions, options, state, {});
  EXPECT_EQ(errors.of_directions(), nullptr) << "nothing is known of them";
  // The exact picture is that of a very fine sum along the rays.
  return compare(scene, *errors.of_cells(), [](const Vec3& start, const Vec3& direction) {
    const double path_length = distance_through(start, direction);
    constexpr int steps = 1000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double along = path_length * (i + 0.5) / steps;
      sum += path_length / steps * std::exp(-1.7 * along) * 1.5 / (4 * std::numbers::pi) *
             smooth(start + along * direction);
    }
    return sum;
  });
}

// The layer of cells falls at the order of linear elements, as what it estimates does, and is that but for
// what falls faster.
TEST(ErrorImages, ErrorOfCellsFollowsTheTrueOneAtOrderTwo) {
  const SpaceError coarse = space_error(2e-2), middle = space_error(2e-2 / 8), fine = space_error(2e-2 / 64);
  for (const SpaceError& error : {coarse, middle, fine}) {
    EXPECT_NEAR(error.estimated, error.true_one, 0.1 * error.true_one);
    EXPECT_LT(error.left, 0.5 * error.true_one);
  }
  EXPECT_LT(fine.left, 0.15 * fine.true_one);
  EXPECT_GT(std::log2(coarse.estimated / fine.estimated) / 2, 1.7);
  EXPECT_GT(std::log2(coarse.true_one / fine.true_one) / 2, 1.7);
  EXPECT_GT(std::log2(coarse.left / fine.left) / 2, 2.5);
}

/// The same of a wall that smooth light falls on, in the faces as its value and slope in their middles have
/// it.
SpaceError wall_error(double max_volume) {
  const TetrahedralMesh mesh = cube_mesh(max_volume);
  const Problem room = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(room);
  const DirectionSet directions = directions_product(2);
  const SolveOptions options = tight_options();
  SavedState state;
  state.bands = 1;
  state.fluence.assign(4 * static_cast<std::size_t>(mesh.cell_count()), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (const std::int32_t vertex : mesh.vertices(FaceIndex(f))) {
      const Vec3 middle = mesh.centroid(FaceIndex(f));
      state.irradiance.push_back(smooth(middle) +
                                 slope(middle).dot(mesh.point(VertexIndex(vertex)) - middle));
    }
  const RayRadiance scene(lights, directions, options, state, 1);
  const ErrorImages errors(cameras(), lights, directions, options, state, {});
  return compare(scene, *errors.of_cells(), [&](const Vec3& start, const Vec3& direction) {
    const Vec3 end = start + distance_through(start, direction) * direction;
    Vec3 outwards = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(end[axis] - std::round(end[axis])) < 1e-9) outwards[axis] = 2 * std::round(end[axis]) - 1;
    return 0.5 / directions.half_range(outwards) * smooth(end);
  });
}

// Walls show what is joined, which differs from the linear elements as much as from the light.
TEST(ErrorImages, ErrorOfWallsFollowsTheTrueOneAtOrderTwo) {
  const SpaceError coarse = wall_error(2e-2), middle = wall_error(2e-2 / 8), fine = wall_error(2e-2 / 64);
  for (const SpaceError& error : {coarse, middle, fine})
    EXPECT_NEAR(error.estimated, error.true_one, 0.2 * error.true_one);
  EXPECT_GT(std::log2(coarse.estimated / fine.estimated) / 2, 1.7);
}

// The layer of directions is what pictures of the rotated sets differ by, as a standard error, or more: it
// adds up along a ray what differs in the mean over each cell. It is zero where all sets agree.
TEST(ErrorImages, ErrorOfDirectionsTracksTheSpreadOfRotations) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "xmin" ? 1 : 0, 0, 0));
    walls.back().name = name;
    walls.back().uncollided = Uncollided::no;
  }
  const Problem haze(mesh, {}, {uniform_medium(1, 0.2, 1, 0)}, walls);
  const LightSetup lights(haze);
  const std::vector<DirectionSet> sets = rotated_copies(directions_product(4), 8, 1);
  std::vector<SavedState> states;
  const SolveOptions options = tight_options();
  const auto reader = [&](const DirectionSetSolution& found) { states.push_back(found.solution.state); };
  const Solution mean = solve_rotated(lights, sets, options, {}, {}, reader);
  const RayRadiance scene(lights, sets.front(), options, mean.state, 1);
  const ErrorImages errors(cameras(), lights, sets.front(), options, mean.state, mean.direction_error);
  const std::vector<double> bound = layer(*errors.of_directions(), scene);
  std::vector<double> sum(bound.size(), 0), squares(bound.size(), 0);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const RayRadiance one(lights, sets[i], options, states[i], 1);
    const Picture picture = take_picture(one, cameras().front().camera, 1);
    for (std::size_t p = 0; p < sum.size(); ++p) {
      sum[p] += picture.radiance[p];
      squares[p] += picture.radiance[p] * picture.radiance[p];
    }
  }
  constexpr double count = 8;
  std::vector<double> spread;
  int bounded = 0;
  for (std::size_t p = 0; p < sum.size(); ++p) {
    spread.push_back(
        std::sqrt(std::max(0.0, squares[p] / count - std::pow(sum[p] / count, 2)) / (count - 1)));
    bounded += spread[p] <= bound[p] ? 1 : 0;
  }
  // Within cells the sets may differ more than in their means.
  EXPECT_GT(bounded, 0.7 * static_cast<double>(spread.size()));
  EXPECT_LT(root_mean_square(spread), root_mean_square(bound));
  EXPECT_GT(root_mean_square(spread), 0.1 * root_mean_square(bound)) << "it is no idle bound";

  const Problem furnace = uniform_problem(mesh, uniform_medium(1, 0.2, 1, 0.6), uniform_wall(1, 3, 0, 0));
  const LightSetup none(furnace);
  const SolveOptions plain = tight_options();
  const Solution constant = solve_rotated(none, {sets[0], sets[1]}, plain);
  const RayRadiance hot(none, sets.front(), plain, constant.state, 1);
  const ErrorImages zero(cameras(), none, sets.front(), plain, constant.state, constant.direction_error);
  EXPECT_LT(root_mean_square(layer(*zero.of_directions(), hot)), 1e-8);
}

}  // namespace
}  // namespace etendue::error_images_test
