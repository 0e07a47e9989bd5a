// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/surface_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "tests/mesh/geometry/surface_measures.h"

namespace etendue::surface_file_test {
namespace {

using Areas = std::map<std::string, double>;
using Counts = std::map<std::string, int>;
using testing::EndsWith;
using testing::HasSubstr;

/// A file of the running test, gone after it.
class SurfaceFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "." +
         std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    folder_ = folder;
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }
  ~SurfaceFile() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

 private:
  std::filesystem::path folder_;
};

const Origin kOrigin{"case.toml", 3, "mesh.surface"};

SurfaceFileOptions options() {
  SurfaceFileOptions result;
  result.origin = kOrigin;
  return result;
}

std::string fault_of(const std::filesystem::path& path, const SurfaceFileOptions& with = options()) {
  try {
    read_surface(path, with);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

/// The points and quadrilaterals of a cube as OBJ text; faces count from `first`.
std::string cube_points(double low, double high) {
  std::string text;
  for (const double z : {low, high})
    for (const double y : {low, high})
      for (const double x : {low, high})
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  return text;
}

constexpr std::array<std::array<int, 4>, 6> kCube{
    {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}};

std::string cube_face(int face, int first = 0) {
  std::string text = "f";
  for (const int corner : kCube.at(static_cast<std::size_t>(face)))
    text += " " + std::to_string(first + corner);
  return text + "\n";
}

std::string cube_faces(int first = 0) {
  std::string text;
  for (int face = 0; face < 6; ++face) text += cube_face(face, first);
  return text;
}

TEST_F(SurfaceFile, ObjGroupsNameWalls) {
  std::string text = "# a cube\n" + cube_points(0, 2) + "g floor\n" + cube_face(0) + "g sides\n";
  for (int face = 1; face < 6; ++face) text += cube_face(face);
  const SurfaceComplex surface = read_surface(write("cube.obj", text), options());
  const Areas areas = wall_areas(surface);
  EXPECT_NEAR(areas.at("floor"), 4, 1e-12);
  EXPECT_NEAR(areas.at("sides"), 20, 1e-12);
  EXPECT_EQ(seed_counts(surface), (Counts{{"domain", 1}}));
  EXPECT_TRUE(surface.holes.empty());
}

TEST_F(SurfaceFile, ObjWithoutGroupsIsBoundary) {
  const SurfaceComplex surface = read_surface(write("cube.obj", cube_points(0, 1) + cube_faces()), options());
  EXPECT_NEAR(wall_areas(surface).at("boundary"), 6, 1e-12);
}

TEST_F(SurfaceFile, ScaleMultipliesCoordinates) {
  SurfaceFileOptions millimetres = options();
  millimetres.scale = 1e-3;
  millimetres.regions = {{"glass", Vec3(5e-4, 5e-4, 5e-4)}};
  const SurfaceComplex surface =
      read_surface(write("cube.obj", cube_points(0, 1) + cube_faces()), millimetres);
  EXPECT_NEAR(wall_areas(surface).at("boundary"), 6e-6, 1e-18);
  EXPECT_EQ(seed_counts(surface), (Counts{{"glass", 1}}));
}

TEST_F(SurfaceFile, FacesThatTurnBothWaysAreOriented) {
  std::string text = cube_points(0, 1) + "f 2 4 3 1\n";
  for (int face = 1; face < 6; ++face) text += cube_face(face);
  EXPECT_EQ(read_surface(write("cube.obj", text), options()).facets.size(), 12u);
}

TEST_F(SurfaceFile, ShellInAShellIsACavity) {
  const std::string text =
      cube_points(0, 3) + cube_points(1, 2) + "g out\n" + cube_faces() + "g in\n" + cube_faces(8);
  const SurfaceComplex surface = read_surface(write("cavity.obj", text), options());
  EXPECT_EQ(seed_counts(surface), (Counts{{"domain", 1}}));
  ASSERT_EQ(surface.holes.size(), 1u);
  EXPECT_TRUE((surface.holes[0].array() > 1).all() && (surface.holes[0].array() < 2).all());
  EXPECT_NEAR(wall_areas(surface).at("in"), 6, 1e-12);
}

TEST_F(SurfaceFile, RegionPointsFillShells) {
  const std::string text =
      cube_points(0, 3) + cube_points(1, 2) + "g out\n" + cube_faces() + "g in\n" + cube_faces(8);
  SurfaceFileOptions two = options();
  two.regions = {{"air", Vec3(0.5, 0.5, 0.5)}, {"core", Vec3(1.5, 1.5, 1.5)}};
  const SurfaceComplex surface = read_surface(write("two.obj", text), two);
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}, {"core", 1}}));
  EXPECT_TRUE(surface.holes.empty());
  EXPECT_NEAR(wall_areas(surface).at(""), 6, 1e-12);
  EXPECT_FALSE(wall_areas(surface).contains("in"));
}

TEST_F(SurfaceFile, RefusesRegionPointsOutsideOrTwice) {
  const std::filesystem::path cube = write("cube.obj", cube_points(0, 1) + cube_faces());
  SurfaceFileOptions bad = options();
  bad.regions = {{"a", Vec3(0.5, 0.5, 0.5)}, {"b", Vec3(0.25, 0.5, 0.5)}, {"c", Vec3(2, 0, 0)}};
  EXPECT_EQ(
      fault_of(cube, bad),
      "case.toml:3: mesh.surface: regions.b = [0.25, 0.5, 0.5]: lies in the same part as region \"a\"; parts "
      "are told apart by closed surfaces\n"
      "case.toml:3: mesh.surface: regions.c = [2, 0, 0]: lies in no closed part of the surface; give a point "
      "inside");
}

TEST_F(SurfaceFile, RefusesHolesWithTheirPlace) {
  std::string text = cube_points(0, 1);
  for (int face = 1; face < 6; ++face) text += cube_face(face);
  const std::string fault = fault_of(write("open.obj", text));
  EXPECT_THAT(fault, HasSubstr("case.toml:3: mesh.surface = \""));
  EXPECT_THAT(fault, HasSubstr("the surface is not closed: it has 1 hole (one with an edge from ["));
  EXPECT_THAT(fault, EndsWith(", 4 around); close it"));
}

TEST_F(SurfaceFile, RefusesSelfIntersectionsWithTheirPlace) {
  const std::string text = cube_points(0, 2) + cube_points(1, 3) + cube_faces() + cube_faces(8);
  const std::string fault = fault_of(write("crossing.obj", text));
  EXPECT_THAT(fault, HasSubstr("the surface cuts or touches itself in "));
  EXPECT_THAT(fault, HasSubstr(" with ["));
  EXPECT_THAT(fault, EndsWith("; ...; part or unite what overlaps"));
}

TEST_F(SurfaceFile, RefusesEdgesOfMoreThanTwoPolygons) {
  const std::string fault = fault_of(write("double.obj", cube_points(0, 1) + cube_faces() + "f 1 2 8 7\n"));
  EXPECT_THAT(fault, HasSubstr("3 polygons meet in the edge from [0, 0, 0] to [1, 0, 0]"));
}

TEST_F(SurfaceFile, RefusesTrianglesWithoutArea) {
  // A corner of the tetrahedron's base edge is split by a flat triangle.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.5 0 0\n"
      "f 1 3 2\nf 1 5 4\nf 5 2 4\nf 2 3 4\nf 3 1 4\nf 1 2 5\n";
  EXPECT_THAT(fault_of(write("flat.obj", text)), HasSubstr("has no area; remove it and join its neighbours"));
}

TEST_F(SurfaceFile, RefusesMalformedObjWithFileAndLine) {
  const std::filesystem::path number = write("number.obj", "v 0 0 0\nv 1 x 0\n");
  EXPECT_EQ(fault_of(number), number.string() + ":2: y = x: must be a finite number");
  const std::filesystem::path infinite = write("infinite.obj", "v 0 0 inf\n");
  EXPECT_EQ(fault_of(infinite), infinite.string() + ":1: z = inf: must be a finite number");
  const std::filesystem::path corner = write("corner.obj", "v 0 0 0\n\nf 1 2 3\n");
  EXPECT_EQ(fault_of(corner), corner.string() + ":3: corner = 2: there are only 1 points so far");
  const std::filesystem::path two = write("two.obj", "v 0 0 0\nf 1 1\n");
  EXPECT_EQ(fault_of(two), two.string() + ":2: a face needs at least 3 corners");
  EXPECT_THAT(fault_of(write("empty.obj", "")), EndsWith("has no polygons"));
}

std::string stl_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::string text = " facet normal 0 0 0\n  outer loop\n";
  for (const Vec3& p : {a, b, c})
    text += "   vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
            "\n";
  return text + "  endloop\n endfacet\n";
}

const Vec3 kO(0, 0, 0), kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST_F(SurfaceFile, StlSolidsNameWalls) {
  const std::string text = "solid bottom plate\n" + stl_triangle(kO, kY, kX) +
                           "endsolid bottom plate\nsolid\n" + stl_triangle(kO, kX, kZ) +
                           stl_triangle(kX, kY, kZ) + stl_triangle(kY, kO, kZ) + "endsolid\n";
  const Areas areas = wall_areas(read_surface(write("tet.stl", text), options()));
  EXPECT_NEAR(areas.at("bottom plate"), 0.5, 1e-12);
  EXPECT_NEAR(areas.at("boundary"), 1 + std::sqrt(3) / 2, 1e-12);
}

TEST_F(SurfaceFile, BinaryStlIsRead) {
  std::string content(80, ' ');
  const std::string solid = "solid by name only";
  content.replace(0, solid.size(), solid);
  const std::uint32_t count = 4;
  content.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle :
       {std::array{kO, kY, kX}, std::array{kO, kX, kZ}, std::array{kX, kY, kZ}, std::array{kY, kO, kZ}}) {
    std::array<float, 12> values{};
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        values[3 + 3 * i + static_cast<std::size_t>(k)] = static_cast<float>(triangle[i][k]);
    content.append(reinterpret_cast<const char*>(values.data()), sizeof values);
    content.append(2, '\0');
  }
  const SurfaceComplex surface = read_surface(write("tet.stl", content), options());
  EXPECT_EQ(surface.facets.size(), 4u);
  EXPECT_EQ(surface.points.size(), 4u);
}

TEST_F(SurfaceFile, RefusesTruncatedStlWithFileAndLine) {
  const std::filesystem::path cut =
      write("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  EXPECT_EQ(fault_of(cut), cut.string() + ":4: the file ends early; expected \"vertex\"");
  const std::filesystem::path odd = write("odd.stl", "solid a\ntriangle 1 2 3\n");
  EXPECT_EQ(fault_of(odd), odd.string() + ":2: expected \"facet\" (ASCII STL)");
}

TEST_F(SurfaceFile, OffAndPlyAreRead) {
  const std::string off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  EXPECT_EQ(read_surface(write("tet.off", off), options()).facets.size(), 4u);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  EXPECT_EQ(read_surface(write("tet.ply", ply), options()).facets.size(), 4u);
}

TEST_F(SurfaceFile, RefusesBrokenOffAndPly) {
  EXPECT_THAT(fault_of(write("cut.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n")),
              EndsWith("cut.off: is not a whole .off file (CGAL cannot read it)"));
  EXPECT_THAT(fault_of(write("corner.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")),
              HasSubstr("is not a whole .off file"));
  EXPECT_THAT(fault_of(write("text.ply", "not a ply\n")), HasSubstr("is not a whole .ply file"));
}

TEST_F(SurfaceFile, RefusesFilesThatCgalBreaksDownOn) {
  // The reader takes the property before it has an element to give it to.
  EXPECT_THAT(fault_of(write("header.ply", "ply\nt ascii 6\nproperty float x")),
              HasSubstr("header.ply: CGAL breaks down on it; is the file damaged?"));
  const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_THAT(fault_of(write("many.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" +
                                             vertices + faces)),
              HasSubstr("many.ply: "));
}

/// A square tube: its two ends are polygons with a hole, as CAD programs write them: one outline that goes in
/// along a bridge, around the hole and back.
const std::string kTube =
    "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
    "v 0 0 1\nv 3 0 1\nv 3 3 1\nv 0 3 1\nv 1 1 1\nv 2 1 1\nv 2 2 1\nv 1 2 1\n"
    "g ends\nf 1 4 3 2 1 5 6 7 8 5\nf 9 10 11 12 9 13 16 15 14 13\n"
    "g outside\nf 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 1 9 12\n"
    "g inside\nf 5 13 14 6\nf 6 14 15 7\nf 7 15 16 8\nf 8 16 13 5\n";

TEST_F(SurfaceFile, PolygonsWithHolesAreCutIntoTriangles) {
  const SurfaceComplex surface = read_surface(write("tube.obj", kTube), options());
  const Areas areas = wall_areas(surface);
  ASSERT_EQ(areas.size(), 3u);
  EXPECT_NEAR(areas.at("ends"), 16, 1e-12);
  EXPECT_NEAR(areas.at("outside"), 12, 1e-12);
  EXPECT_NEAR(areas.at("inside"), 4, 1e-12);
  EXPECT_EQ(surface.points.size(), 16u);
  ASSERT_EQ(surface.seeds.size(), 1u);
}

TEST_F(SurfaceFile, RefusesPolygonsThatComeBackAndCrossThemselves) {
  EXPECT_THAT(
      fault_of(write("loop.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 5 0\nf 1 4 2 3 4 5\n")),
      HasSubstr("the polygon of 6 corners that begins [0, 0, 0] [2, 2, 0] crosses itself; cut it into "
                "simple polygons"));
}

TEST_F(SurfaceFile, RefusesUnknownEndingsAndMissingFiles) {
  EXPECT_THAT(
      fault_of("room.step"),
      testing::StrEq(
          "case.toml:3: mesh.surface = \"room.step\": is not a kind of surface file; use .poly, .smesh, "
          ".stl, .obj, .ply or .off"));
  for (const char* name : {"/nowhere/a.stl", "/nowhere/a.obj", "/nowhere/a.ply", "/nowhere/a.poly"})
    EXPECT_THROW(read_surface(name, options()), FileError) << name;
}

const std::string kPolyCube =
    "# a cube with a square opening in its floor's facet\n"
    "8 3 0 0\n"
    "1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 0 0 2\n6 2 0 2\n7 2 2 2\n8 0 2 2\n";

TEST_F(SurfaceFile, SmeshMarkersNameWalls) {
  const std::string text = kPolyCube +
                           "6 1\n4 1 2 3 4 10\n4 5 6 7 8 20\n4 1 2 6 5 0\n4 2 3 7 6 0\n4 3 4 8 7 0\n"
                           "4 4 1\n 5 8 -1\n0\n0\n";
  const SurfaceComplex surface = read_surface(write("cube.smesh", text), options());
  const Areas areas = wall_areas(surface);
  EXPECT_NEAR(areas.at("10"), 4, 1e-12);
  EXPECT_NEAR(areas.at("20"), 4, 1e-12);
  EXPECT_NEAR(areas.at("boundary"), 16, 1e-12);
  EXPECT_EQ(seed_counts(surface), (Counts{{"domain", 1}}));
}

TEST_F(SurfaceFile, PolyRegionsAndHolesAreKept) {
  // A cube within a cube, the inner one by its own facets.
  std::string text =
      "16 3\n0 0 0 0\n1 3 0 0\n2 3 3 0\n3 0 3 0\n4 0 0 3\n5 3 0 3\n6 3 3 3\n7 0 3 3\n"
      "8 1 1 1\n9 2 1 1\n10 2 2 1\n11 1 2 1\n12 1 1 2\n13 2 1 2\n14 2 2 2\n15 1 2 2\n12 0\n";
  for (const int first : {0, 8})
    for (const std::array<int, 4>& f :
         {std::array{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
      text += "1\n4 " + std::to_string(first + f[0]) + " " + std::to_string(first + f[1]) + " " +
              std::to_string(first + f[2]) + " " + std::to_string(first + f[3]) + "\n";
  const SurfaceComplex filled =
      read_surface(write("a.poly", text + "0\n1\n1 1.5 1.5 1.5 7 0.1\n"), options());
  EXPECT_EQ(seed_counts(filled), (Counts{{"7", 1}, {"domain", 1}}));
  const SurfaceComplex hollow = read_surface(write("b.poly", text + "1\n1 1.5 1.5 1.5\n"), options());
  EXPECT_EQ(seed_counts(hollow), (Counts{{"domain", 1}}));
  EXPECT_EQ(hollow.holes.size(), 1u);
}

TEST_F(SurfaceFile, PolyFacetsMayHaveOpenings) {
  // A square pipe: the two end facets are open where the pipe goes through the block.
  const std::string text =
      "16 3\n0 0 0 0\n1 3 0 0\n2 3 3 0\n3 0 3 0\n4 0 0 3\n5 3 0 3\n6 3 3 3\n7 0 3 3\n"
      "8 1 1 0\n9 2 1 0\n10 2 2 0\n11 1 2 0\n12 1 1 3\n13 2 1 3\n14 2 2 3\n15 1 2 3\n"
      "10 1\n2 1 5\n4 0 1 2 3\n4 8 9 10 11\n1 1.5 1.5 0\n2 1 5\n4 4 5 6 7\n4 12 13 14 15\n1 1.5 1.5 3\n"
      "1 0 6\n4 0 1 5 4\n1 0 6\n4 1 2 6 5\n1 0 6\n4 2 3 7 6\n1 0 6\n4 3 0 4 7\n"
      "1 0 7\n4 8 9 13 12\n1 0 7\n4 9 10 14 13\n1 0 7\n4 10 11 15 14\n1 0 7\n4 11 8 12 15\n0\n0\n";
  const SurfaceComplex surface = read_surface(write("pipe.poly", text), options());
  EXPECT_EQ(seed_counts(surface), (Counts{{"domain", 1}}));
  EXPECT_NEAR(wall_areas(surface).at("5"), 16, 1e-12);
  const Vec3 seed = surface.seeds.front().point;
  EXPECT_FALSE(seed.x() > 1 && seed.x() < 2 && seed.y() > 1 && seed.y() < 2);
}

TEST_F(SurfaceFile, PolyPointsMayStandInANodeFile) {
  write("cube.node", kPolyCube);
  const std::filesystem::path poly = write(
      "cube.smesh", "0 3 0 0\n6 0\n4 1 2 3 4\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n0\n");
  EXPECT_NEAR(wall_areas(read_surface(poly, options())).at("boundary"), 24, 1e-12);
}

TEST_F(SurfaceFile, PolyFacetsMayBeLonePointsAndSegments) {
  std::string text = kPolyCube + "8 0\n1\n1 1\n1\n2 1 7\n";
  for (const char* corners : {"1 2 3 4", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"})
    text += std::string("1\n4 ") + corners + "\n";
  const SurfaceComplex surface = read_surface(write("points.poly", text + "0\n"), options());
  EXPECT_EQ(surface.facets.size(), 8u);
  EXPECT_EQ(seed_counts(surface), (Counts{{"domain", 1}}));
}

TEST_F(SurfaceFile, RefusesMalformedPolyWithFileAndLine) {
  const std::filesystem::path corner = write("corner.smesh", kPolyCube + "1 0\n3 1 2 9\n");
  EXPECT_EQ(fault_of(corner), corner.string() + ":12: corner = 9: there is no such point (1 to 8)");
  const std::filesystem::path low = write("low.smesh", kPolyCube + "1 0\n3 1 2 -2147483648\n");
  EXPECT_EQ(fault_of(low), low.string() + ":12: corner = -2147483648: there is no such point (1 to 8)");
  const std::filesystem::path empty = write("empty.poly", kPolyCube + "1 0\n0\n");
  EXPECT_EQ(fault_of(empty), empty.string() + ":12: a facet needs polygons");
  const std::filesystem::path cut = write("cut.poly", kPolyCube + "2 0\n1\n3 1 2 3\n");
  EXPECT_EQ(fault_of(cut), cut.string() + ":13: the file ends early; expected facet 2 of 2");
  const std::filesystem::path word = write("word.poly", "eight 3\n");
  EXPECT_EQ(fault_of(word), word.string() + ":1: number of points = eight: must be a whole number");
  const std::filesystem::path flat = write("flat.poly", "3 2\n");
  EXPECT_EQ(fault_of(flat), flat.string() + ":1: dimension = 2: must be 3");
  const std::filesystem::path open = write("open.smesh", kPolyCube + "1 0\n4 1 2 3 4\n0\n");
  EXPECT_EQ(fault_of(open),
            open.string() + ": the facets shut nothing in (the surface is not closed); close it");
  const std::filesystem::path none = write("none.smesh", kPolyCube + "0 0\n0\n");
  EXPECT_EQ(fault_of(none), none.string() + ": has no facets (nothing to fill)");
}

// 1e160 squared overflows: sums of it were not numbers, and were sorted.
TEST_F(SurfaceFile, RefusesCoordinatesOutOfRange) {
  EXPECT_THAT(fault_of(write("large.obj", "v 0 0 0\nv 1e160 0 0\nv 0 1 0\nf 1 2 3\n")),
              HasSubstr("point (1e+160, 0, 0)"));
  EXPECT_THAT(fault_of(write("large.poly", "2 3 0 0\n0 1e160 0 0\n1 1 0 0\n")),
              HasSubstr("large.poly:2: point (1e+160, 0, 0)"));
}

}  // namespace
}  // namespace etendue::surface_file_test
