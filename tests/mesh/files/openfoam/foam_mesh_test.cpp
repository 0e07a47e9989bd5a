// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/openfoam/foam_mesh.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <sstream>

#include "tests/mesh/files/read_message.h"
#include "tests/mesh/files/scratch_folder.h"
#include "tests/mesh/polyhedra/sample_polyhedra.h"

namespace etendue::foam_mesh_test {
namespace {

using sample_polyhedra::hexahedra;
using sample_polyhedra::write_foam_mesh;

std::string text_of_file(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The folder of a case with a box of 2 x 3 x 2 hexahedra, whose files can be changed.
class FoamCase {
 public:
  explicit FoamCase(const PolyhedralMesh& mesh = hexahedra({2, 3, 2})) {
    write_foam_mesh(folder_.path(), mesh);
  }

  std::filesystem::path path() const { return folder_.path(); }
  std::filesystem::path file(const std::string& name) const { return path() / "constant/polyMesh" / name; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
  }
  /// Replaces a part of a file, which must be there.
  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = text_of_file(file(name));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write(name, text.replace(at, from.size(), to));
  }
  /// What reading it says, without the path of the folder.
  std::string message() const {
    std::string text = read_message(path());
    const std::string folder = path().string() + "/constant/polyMesh/";
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    const std::string name = path().filename().string() + "/constant/polyMesh/";
    for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
      text.erase(at, name.size());
    return text;
  }

 private:
  ScratchFolder folder_;
};

/// The message where a part of a file is another.
std::string message_with(const std::string& name, const std::string& from, const std::string& to) {
  const FoamCase foam;
  foam.change(name, from, to);
  return foam.message();
}

TEST(FoamMesh, IsReadInTheOrderOfItsFiles) {
  const PolyhedralMesh written = hexahedra({2, 3, 2}, Vec3(1, 2, 1.0 / 3));
  const FoamCase foam(written);
  const PolyhedralMesh mesh = read_foam_mesh(foam.path());
  EXPECT_EQ(mesh.points, written.points);
  EXPECT_EQ(mesh.face_points, written.face_points);
  EXPECT_EQ(mesh.face_ends, written.face_ends);
  EXPECT_EQ(mesh.owners, written.owners);
  EXPECT_EQ(mesh.neighbors, written.neighbors);
  EXPECT_EQ(mesh.face_walls, written.face_walls);
  EXPECT_EQ(mesh.wall_names, written.wall_names);
  EXPECT_EQ(mesh.patch_types, written.patch_types);
  EXPECT_EQ(mesh.cell_regions, written.cell_regions);
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"domain"});
}

TEST(FoamMesh, IsAMeshOfTetrahedraWithPatchesAsWalls) {
  const FoamCase foam;
  const TetrahedralMesh mesh(read_mesh(foam.path(), 2));
  EXPECT_EQ(mesh.cell_count(), 12 * 12);
  EXPECT_EQ(mesh.wall_names().size(), 6U);
  double volume = 0;
  for (const double part : mesh.volumes()) volume += part;
  EXPECT_NEAR(volume, 8, 1e-13);
  EXPECT_EQ(mesh.parents().mesh->points.back(), Vec3(2, 2, 2));
}

TEST(FoamMesh, HasItsZonesAsRegions) {
  PolyhedralMesh written = hexahedra({2, 3, 2});
  written.region_names = {"hot", "cold", "domain"};
  for (std::size_t c = 0; c < 12; ++c) written.cell_regions[c] = c < 3 ? 0 : c < 5 ? 1 : 2;
  const FoamCase foam(written);
  const PolyhedralMesh mesh = read_foam_mesh(foam.path());
  EXPECT_EQ(mesh.cell_regions, written.cell_regions);
  EXPECT_EQ(mesh.region_names, written.region_names);
  foam.change("cellZones", "3\n(\n0\n", "3\n(\n4\n");
  EXPECT_EQ(foam.message(), "cellZones:33: cell 4: is in the zones hot and cold; a cell has one region");
}

TEST(FoamMesh, OfOneOfSeveralRegionsIsReadFromItsFolder) {
  const FoamCase foam;
  EXPECT_EQ(read_foam_mesh(foam.path() / "constant").cell_count(), 12U);
}

TEST(FoamMesh, LeavesOutCommentsAndOtherEntries) {
  const FoamCase foam;
  foam.change("boundary", "nFaces",
              "note \"a } text;\"; list ( 1 (2 3) ); sub { a b; } // nFaces 7;\n nFaces");
  foam.change("owner", "(\n", "/* several\nlines */ (\n");
  EXPECT_EQ(foam.message(), "no error");
}

/// The bytes of a value.
template <class Value>
std::string bytes_of(Value value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string binary_header(const std::string& type, const std::string& arch) {
  return "FoamFile\n{\n version 2.0;\n format binary;\n arch \"" + arch + "\";\n class " + type +
         ";\n object x;\n}\n";
}

template <class Label>
std::string binary_labels(const std::vector<int>& labels) {
  std::string text = std::to_string(labels.size()) + "\n(";
  for (const int label : labels) text += bytes_of(static_cast<Label>(label));
  return text + ")\n";
}

/// Writes the lists in binary.
template <class Label, class Scalar>
void write_binary(const FoamCase& foam, const PolyhedralMesh& mesh) {
  const std::string arch =
      "LSB;label=" + std::to_string(8 * sizeof(Label)) + ";scalar=" + std::to_string(8 * sizeof(Scalar));
  std::string points = binary_header("vectorField", arch) + std::to_string(mesh.points.size()) + "\n(";
  for (const Vec3& point : mesh.points)
    for (const double x : point) points += bytes_of(static_cast<Scalar>(x));
  foam.write("points", points + ")\n");
  std::vector<int> begins = {0};
  begins.insert(begins.end(), mesh.face_ends.begin(), mesh.face_ends.end());
  foam.write("faces", binary_header("faceCompactList", arch) + binary_labels<Label>(begins) + "\n" +
                          binary_labels<Label>(mesh.face_points));
  foam.write("owner", binary_header("labelList", arch) + binary_labels<Label>(mesh.owners));
  std::vector<int> inside(mesh.neighbors.begin(), std::ranges::find(mesh.neighbors, -1));
  foam.write("neighbour", binary_header("labelList", arch) + binary_labels<Label>(inside));
}

TEST(FoamMesh, IsReadInBinaryToo) {
  const PolyhedralMesh written = hexahedra({2, 3, 2}, Vec3(1, 3, 0.5));
  const FoamCase foam(written);
  const auto expect_same = [&] {
    const PolyhedralMesh mesh = read_foam_mesh(foam.path());
    EXPECT_EQ(mesh.points, written.points);
    EXPECT_EQ(mesh.face_points, written.face_points);
    EXPECT_EQ(mesh.owners, written.owners);
    EXPECT_EQ(mesh.neighbors, written.neighbors);
  };
  write_binary<std::int32_t, double>(foam, written);
  expect_same();
  write_binary<std::int64_t, float>(foam, written);
  expect_same();
  const std::string owners = text_of_file(foam.file("owner"));
  foam.write("owner", owners.substr(0, owners.size() - 20));
  EXPECT_EQ(foam.message(), "owner:10: the file ends within a binary list (is it cut short?)");
  foam.change("points", "LSB", "MSB");
  EXPECT_EQ(foam.message(), "points:5: arch: numbers are big-endian; write the mesh as ascii");
}

TEST(FoamMesh, RefusesFilesThatAreNotThereOrOfAnotherKind) {
  const FoamCase foam;
  std::filesystem::rename(foam.file("points"), foam.file("points.gz"));
  EXPECT_EQ(foam.message(), "points.gz: is compressed; unpack it with gunzip");
  std::filesystem::remove(foam.file("points.gz"));
  EXPECT_EQ(foam.message(), "FileError points: cannot be opened (No such file or directory)");
  foam.write("points", "hello");
  EXPECT_EQ(foam.message(), "points:1: is no file of OpenFOAM (it does not begin with FoamFile)");
  EXPECT_EQ(message_with("points", "vectorField", "labelList"),
            "points:8: class labelList: must be vectorField");
  EXPECT_EQ(message_with("points", "version 2.0;\n    format ascii;", "version"),
            "points:7: class : must be vectorField");
}

TEST(FoamMesh, RefusesListsThatAreWrong) {
  EXPECT_EQ(message_with("points", "36\n(", "3600\n("),
            "points:11: number of points = 3600: is more than the file holds (is it cut short?)");
  EXPECT_EQ(message_with("points", "36\n(", "37\n("), "points:49: ): must be (");
  EXPECT_EQ(message_with("points", "(0.5 0 0)", "(0.5 zero 0)"),
            "points:14: point 1 = zero: is not a finite number");
  EXPECT_EQ(message_with("points", "(0.5 0 0)", "(1e999 0 0)"),
            "points:14: point 1 = 1e999: is not a finite number");
  EXPECT_EQ(message_with("faces", "4(", "4(-"), "faces:13: point = -1: is out of range; use 0 to 35");
  EXPECT_EQ(message_with("faces", "4(1 4", "4(4 4"),
            "faces:13: face 0: has a point twice; must have three points or more, all different");
  EXPECT_EQ(message_with("faces", "4(", "2000000000("),
            "faces:13: length of the list of point = 2000000000: is out of range; use 0 to 36");
  EXPECT_EQ(message_with("owner", "52\n(", "2000000000{0}"),
            "owner:11: length of the list of owner = 2000000000: is out of range; use 0 to 52");
  EXPECT_EQ(message_with("owner", "52\n(", "40\n("), "owner:53: 0: must be )");
  EXPECT_EQ(message_with("owner", "(\n0\n", "(\n-1\n"), "owner:13: owner = -1: is out of range; use 0 to 25");
  EXPECT_EQ(message_with("neighbour", "(\n1\n", "(\n0\n"),
            "neighbour:33: face 0: lies between cells 0 and 0; must be two cells");
}

TEST(FoamMesh, RefusesListsThatAreCutShort) {
  for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"}) {
    const FoamCase foam;
    const std::string text = text_of_file(foam.file(name));
    foam.write(name, text.substr(0, text.size() - 5));
    const std::string message = foam.message();
    EXPECT_EQ(message.find(std::string(name) + ":"), 0U) << message;
    EXPECT_NE(message.find("is it cut short?"), std::string::npos) << message;
  }
}

TEST(FoamMesh, RefusesCellsWithoutFaces) {
  const FoamCase foam;
  foam.change("owner", "\n11\n", "\n20\n");
  EXPECT_EQ(foam.message(), "owner:65: cell 12: owns no face and has none as neighbor");
  PolyhedralMesh written = hexahedra({2, 3, 2});
  written.owners.pop_back();
  const FoamCase short_owners(written);
  EXPECT_EQ(short_owners.message(), "owner:64: has 51 entries; must have one for each of the 52 faces");
}

TEST(FoamMesh, RefusesPatchesThatDoNotFit) {
  EXPECT_EQ(message_with("boundary", "nFaces 6;", "nFaces 600;"),
            "boundary:19: patch xmin: faces 20 to 619 do not exist on the boundary; there are 20 to 51");
  EXPECT_EQ(message_with("boundary", "startFace 20;", "startFace 0;"),
            "boundary:19: patch xmin: faces 0 to 5 do not exist on the boundary; there are 20 to 51");
  EXPECT_EQ(message_with("boundary", "startFace 20;", "startFace 21;"),
            "boundary:26: patch xmax: face 26 is in patch xmin too");
  EXPECT_EQ(message_with("boundary", "nFaces 6;", "nFaces 5;"),
            "boundary:55: face 25: is on the boundary, but in no patch");
  EXPECT_EQ(message_with("boundary", "nFaces 6;", ""),
            "boundary:19: patch xmin: nFaces or startFace is missing");
  EXPECT_EQ(message_with("boundary", "xmax", "xmin"), "boundary:26: patch xmin: there are two of this name");
}

TEST(FoamMesh, RefusesPatchesThatAreNoWalls) {
  EXPECT_EQ(message_with("boundary", "type wall", "type empty"),
            "boundary:19: patch xmin: type empty leaves out a dimension; give the case its third dimension, "
            "with walls "
            "or symmetry planes");
  EXPECT_NE(message_with("boundary", "type wall", "type wedge").find("mesh the whole body"),
            std::string::npos);
  EXPECT_NE(message_with("boundary", "type wall", "type cyclicAMI").find("joins two patches"),
            std::string::npos);
  EXPECT_NE(message_with("boundary", "type wall", "type processor").find("reconstructParMesh"),
            std::string::npos);
}

TEST(FoamMesh, WithBytesThatChangedNeverCrashes) {
  std::mt19937 random(5);
  int rejected = 0;
  for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"})
    for (int trial = 0; trial < 40; ++trial) {
      const FoamCase foam;
      std::string broken = text_of_file(foam.file(name));
      for (int change = 0; change < 3; ++change)
        broken[random() % broken.size()] = static_cast<char>(random());
      foam.write(name, broken);
      if (foam.message() != "no error") ++rejected;
    }
  EXPECT_GT(rejected, 100);
}

}  // namespace
}  // namespace etendue::foam_mesh_test
