// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/mesh/files/read_message.h"
#include "tests/mesh/files/scratch_folder.h"

namespace etendue::tetgen_files_test {
namespace {

const std::string kNodes =
    "# a comment, and a blank line\n\n5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0 # here too\n4 0 0 1\n5 1 1 1\n";
const std::string kCells = "2 4 1\n1 1 2 3 4 7\n2 2 3 4 5 8\n";
const std::string kFaces =
    "7 1\n1 1 2 3 5\n2 1 2 4 5\n3 1 3 4 -1\n4 2 3 4 0\n5 2 3 5 6\n6 2 4 5 6\n7 3 4 5 6\n";

TEST(TetgenFiles, AreReadFromAnyOfTheirNames) {
  const ScratchFolder folder;
  folder.write("m.node", kNodes);
  folder.write("m.ele", kCells);
  folder.write("m.face", kFaces);
  for (const char* name : {"m.node", "m.ele", "m.face"}) {
    const RawMesh raw = read_mesh(folder.path() / name, 2);
    ASSERT_EQ(raw.points.size(), 5u);
    EXPECT_EQ(raw.points[4], Vec3(2, 2, 2));
    EXPECT_EQ(raw.cells, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_EQ(raw.region_names, (std::vector<std::string>{"7", "8"}));
    EXPECT_EQ(raw.wall_names, (std::vector<std::string>{"5", "boundary", "6"}));
    EXPECT_EQ(raw.cell_lines, (std::vector<int>{2, 3}));
    const TetrahedralMesh mesh(raw);
    EXPECT_EQ(mesh.boundary_face_count(), 6);
    EXPECT_EQ(mesh.wall_names().size(), 3u);
  }
}

TEST(TetgenFiles, CountFromZeroToo) {
  const ScratchFolder folder;
  folder.write("m.node", "4\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
  const auto path = folder.write("m.ele", "1\n0 0 1 2 3\n");
  const TetrahedralMesh mesh(read_mesh(path));
  EXPECT_EQ(mesh.cell_count(), 1);
  EXPECT_EQ(mesh.region_names(), std::vector<std::string>{"domain"});
  EXPECT_EQ(mesh.wall_names(), std::vector<std::string>{"boundary"});
}

TEST(TetgenFiles, FaultsOfTheMeshPointAtTheLineOfTheCell) {
  const ScratchFolder folder;
  folder.write("m.node", kNodes);
  const auto path = folder.write("m.ele", "# header\n2 4 0\n1 1 2 3 4\n2 2 3 4 1\n");
  try {
    TetrahedralMesh mesh(read_mesh(path));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults()[0].line, 4);
    EXPECT_EQ(
        error.faults()[0].text,
        "cell 2: volume -0.166667 is not positive (vertices 2 3 4 1, centroid (0.25, 0.25, 0.25)); check "
        "node order");
  }
}

/// The message where one of the files has other content.
std::string message_with(const std::string& ending, const std::string& bytes) {
  const ScratchFolder folder;
  folder.write("m.node", kNodes);
  folder.write("m.ele", kCells);
  folder.write("m.face", kFaces);
  folder.write("m" + ending, bytes);
  return read_message(folder.path() / "m.ele");
}

TEST(TetgenFiles, SayWhichSiblingIsMissing) {
  const ScratchFolder folder;
  const auto path = folder.write("m.ele", kCells);
  EXPECT_EQ(read_message(path), "FileError m.node: cannot be opened (No such file or directory)");
}

TEST(TetgenFiles, RejectWhatIsNoMesh) {
  EXPECT_EQ(message_with(".node", ""), "m.node: the file is empty");
  EXPECT_EQ(message_with(".ele", " \n\n"), "m.ele: the file is empty");
  EXPECT_EQ(message_with(".ele", "# only a comment\n"),
            "m.ele:1: the file ends where the header should follow (is it cut short?)");
  EXPECT_EQ(message_with(".ele", std::string("2 4 1\n\0\1\2", 9)),
            "m.ele: is a binary file; save the mesh as text (ASCII)");
  EXPECT_EQ(message_with(".ele", "hello\n"), "m.ele:1: number of cells = hello: is not an integer");
}

TEST(TetgenFiles, RejectHeadersThatCannotBe) {
  EXPECT_EQ(message_with(".node", "1 2 0 0\n"), "m.node:1: dimension = 2: must be 3");
  EXPECT_EQ(message_with(".node", "999999999999 3 0 0\n1 0 0 0\n"),
            "m.node:1: number of points = 999999999999: is more than the file holds (is it cut short?)");
  EXPECT_EQ(message_with(".node", "99999999999999999999999 3\n"),
            "m.node:1: number of points = 99999999999999999999999: is too large an integer");
  EXPECT_EQ(message_with(".node", "-4 3 0 0\n"),
            "m.node:1: number of points = -4: is too small; use 0 or more");
  EXPECT_EQ(message_with(".ele", "1 10 0\n1 1 2 3 4 1 2 3 4 5 1\n"),
            "m.ele:1: corners = 10: must be 4 (cells of higher order are not read)");
}

TEST(TetgenFiles, RejectPointsThatCannotBe) {
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n2 1 nan 0\n"), "m.node:3: y = nan: is not a finite number");
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n2 1 1e999 0\n"),
            "m.node:3: y = 1e999: is not a finite number");
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n2 1 zero 0\n"), "m.node:3: y = zero: is not a number");
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n2 1 0\n"), "m.node:3: z is missing; give a number");
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n"),
            "m.node:2: the file ends where point 2 of 2 should follow (is it cut short?)");
  EXPECT_EQ(message_with(".node", "2 3\n3 0 0 0\n"), "m.node:2: point number = 3: the first must be 0 or 1");
  EXPECT_EQ(message_with(".node", "2 3\n1 0 0 0\n5 0 0 0\n"),
            "m.node:3: point number = 5: must be 2 (points count up)");
}

TEST(TetgenFiles, RejectCellsAndFacesThatCannotBe) {
  EXPECT_EQ(message_with(".ele", "1 4 0\n1 1 2 3 6\n"), "m.ele:2: point = 6: is out of range; use 1 to 5");
  EXPECT_EQ(message_with(".ele", "1 4 0\n1 1 2 3 -1\n"), "m.ele:2: point = -1: is out of range; use 1 to 5");
  EXPECT_EQ(message_with(".ele", "1 4 0\n1 1 2 3\n"), "m.ele:2: point is missing; give an integer");
  EXPECT_EQ(message_with(".ele", "1 4 1\n1 1 2 3 4\n"), "m.ele:2: attribute is missing; give a number");
  EXPECT_EQ(message_with(".face", "1 1\n1 1 2 3 wall\n"),
            "m.face:2: boundary marker = wall: is not an integer");
  EXPECT_EQ(message_with(".face", "2 1\n1 1 2 3 5\n"),
            "m.face:2: the file ends where face 2 of 2 should follow (is it cut short?)");
}

}  // namespace
}  // namespace etendue::tetgen_files_test
