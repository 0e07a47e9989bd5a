// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/mesh/files/read_message.h"
#include "tests/mesh/files/scratch_folder.h"

namespace etendue::gmsh_file_test {
namespace {

const std::string kNames =
    "$PhysicalNames\n3\n2 5 \"outer wall\"\n3 7 \"air\"\n3 8 \"smoke\"\n$EndPhysicalNames\n";

const std::string kVersion2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + kNames +
                              "$Comments\nanything\n$EndComments\n"
                              "$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 1 1 1\n$EndNodes\n"
                              "$Elements\n10\n"
                              "1 15 2 0 1 10\n2 1 2 0 1 10 20\n"
                              "3 2 2 5 1 10 20 30\n4 2 2 5 1 10 20 40\n5 2 2 5 1 10 30 40\n"
                              "6 2 2 9 1 20 30 50\n7 2 2 9 1 20 40 50\n8 2 2 9 1 30 40 50\n"
                              "9 4 2 7 1 10 20 30 40\n10 4 2 8 1 20 30 40 50\n$EndElements\n";

const std::string kVersion4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
    "$Entities\n1 1 3 2\n"
    "1 0 0 0 0 \n"
    "1 0 0 0 1 0 0 0 2 1 -1 \n"
    "1 0 0 0 1 1 0 1 5 0 \n2 0 0 0 1 1 1 1 9 0 \n3 0 0 0 1 1 1 0 0\n"
    "1 0 0 0 1 1 1 1 7 1 1 \n2 0 0 0 1 1 1 1 -8 1 2 \n"
    "$EndEntities\n"
    "$Nodes\n2 5 10 50\n0 1 0 1\n10\n0 0 0\n3 1 0 4\n20\n30\n40\n50\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
    "$Elements\n6 10 1 10\n"
    "0 1 15 1\n1 10 \n"
    "2 1 2 3\n3 10 20 30 \n4 10 20 40 \n5 10 30 40 \n"
    "2 2 2 3\n6 20 30 50 \n7 20 40 50 \n8 30 40 50 \n"
    "2 3 2 1\n9 20 30 40 \n"
    "3 1 4 1\n10 10 20 30 40 \n"
    "3 2 4 1\n11 20 30 40 50 \n$EndElements\n";

// Gmsh writes the elements of a partitioned mesh by parts of its entities: volumes 3 and 4, surfaces 4 and 5.
// Surface 6 lies between the volumes and has the group 7 of its parent, which is one of volumes.
const std::string kPartitioned =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
    "$Entities\n1 0 2 2\n"
    "1 0 0 0 0 \n"
    "1 0 0 0 1 1 0 1 5 0 \n2 0 0 0 1 1 1 1 9 0 \n"
    "1 0 0 0 1 1 1 1 7 1 1 \n2 0 0 0 1 1 1 1 8 1 2 \n"
    "$EndEntities\n"
    "$PartitionedEntities\n2\n1\n9 1\n1 0 3 2\n"
    "2 0 1 2 1 2 0 0 0 0 \n"
    "4 2 1 1 1 0 0 0 1 1 0 1 5 0 \n5 2 2 1 2 0 0 0 1 1 1 1 9 0 \n6 3 1 2 1 2 0 0 0 1 1 1 1 7 0 \n"
    "3 3 1 1 1 0 0 0 1 1 1 1 7 2 4 6 \n4 3 2 1 2 0 0 0 1 1 1 1 8 2 5 6 \n"
    "$EndPartitionedEntities\n"
    "$Nodes\n2 5 10 50\n0 2 0 1\n10\n0 0 0\n3 3 0 4\n20\n30\n40\n50\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
    "$Elements\n5 9 1 11\n"
    "2 4 2 3\n3 10 20 30 \n4 10 20 40 \n5 10 30 40 \n"
    "2 5 2 3\n6 20 30 50 \n7 20 40 50 \n8 30 40 50 \n"
    "2 6 2 1\n9 20 30 40 \n"
    "3 3 4 1\n10 10 20 30 40 \n"
    "3 4 4 1\n11 20 30 40 50 \n$EndElements\n";

std::string message_of(const std::string& bytes) {
  const ScratchFolder folder;
  return read_message(folder.write("m.msh", bytes));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(GmshFile, AllVersionsGiveTheSameMesh) {
  const ScratchFolder folder;
  for (const auto& [name, bytes] :
       {std::pair{"2.msh", kVersion2}, {"4.msh", kVersion4}, {"partitioned.msh", kPartitioned}}) {
    const RawMesh raw = read_mesh(folder.write(name, bytes), 0.5);
    ASSERT_EQ(raw.points.size(), 5u);
    EXPECT_EQ(raw.points[1], Vec3(0.5, 0, 0));
    EXPECT_EQ(raw.cells, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_EQ(raw.region_names, (std::vector<std::string>{"air", "smoke"}));
    EXPECT_EQ(raw.wall_names, (std::vector<std::string>{"outer wall", "9"}));
    EXPECT_EQ(raw.triangles.size(), 6u);
    EXPECT_EQ(raw.point_numbers[4], 50);
    const TetrahedralMesh mesh(raw);
    EXPECT_EQ(mesh.cell_count(), 2);
    EXPECT_EQ(mesh.boundary_face_count(), 6);
    EXPECT_EQ(mesh.wall_names().size(), 2u);
  }
}

TEST(GmshFile, WithoutPhysicalGroupsIsOneDomain) {
  const ScratchFolder folder;
  const auto path =
      folder.write("m.msh",
                   "$MeshFormat\r\n2.2 0 8\r\n$EndMeshFormat\r\n$Nodes\r\n4\r\n1 0 0 0\r\n2 1 0 0\r\n3 0 1 "
                   "0\r\n4 0 0 1\r\n"
                   "$EndNodes\r\n$Elements\r\n2\r\n1 2 2 0 6 1 2 3\r\n2 4 2 0 1 1 2 3 4\r\n$EndElements\r\n");
  const TetrahedralMesh mesh(read_mesh(path));
  EXPECT_EQ(mesh.region_names(), std::vector<std::string>{"domain"});
  EXPECT_EQ(mesh.wall_names(), std::vector<std::string>{"boundary"});
}

TEST(GmshFile, FaultsOfTheMeshNameElementNodesAndLine) {
  const ScratchFolder folder;
  const auto path =
      folder.write("m.msh", replaced(kVersion2, "10 4 2 8 1 20 30 40 50", "10 4 2 8 1 30 20 40 50"));
  try {
    TetrahedralMesh mesh(read_mesh(path));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults()[0].line, 32);
    EXPECT_EQ(error.faults()[0].text.find("cell 10: volume -0.333333 is not positive (vertices 30 20 40 50"),
              0u);
  }
}

TEST(GmshFile, RejectsOtherFormats) {
  EXPECT_EQ(message_of(""), "m.msh: the file is empty");
  EXPECT_EQ(message_of("solid cube\n"), "m.msh:1: is not a Gmsh mesh (it must begin with $MeshFormat)");
  EXPECT_EQ(message_of(replaced(kVersion2, "2.2 0 8", "2.2 1 8")),
            "m.msh:2: file type = 1: binary meshes are not read; save as ASCII");
  EXPECT_EQ(message_of(replaced(kVersion4, "4.1 0 8", "4 0 8")),
            "m.msh:2: version = 4: is not read; save the mesh as Gmsh 4.1 or 2.2");
  EXPECT_EQ(message_of(std::string("$MeshFormat\n2.2 1 8\n\1\0\0\0", 24)),
            "m.msh: is a binary file; save the mesh as text (ASCII)");
}

TEST(GmshFile, RejectsFilesThatAreCutShort) {
  const ScratchFolder folder;
  for (const std::string& whole : {kVersion2, kVersion4})
    for (std::size_t length = 0; length < whole.find("$EndElements"); length += 11) {
      const auto path = folder.write("m.msh", whole.substr(0, length));
      EXPECT_THROW(TetrahedralMesh(read_mesh(path)), InputError) << length;
    }
  EXPECT_EQ(message_of(kVersion2.substr(0, kVersion2.find("10 4 2 8"))),
            "m.msh:31: the file ends where element 10 of 10 should follow (is it cut short?)");
  EXPECT_EQ(message_of(kVersion4.substr(0, kVersion4.find("0 1 0\n0 0 1"))),
            "m.msh:30: the file ends where the coordinates of node 30 should follow (is it cut short?)");
}

TEST(GmshFile, RejectsNodesThatCannotBe) {
  EXPECT_EQ(message_of(replaced(kVersion2, "20 1 0 0", "20 inf 0 0")),
            "m.msh:16: x = inf: is not a finite number");
  EXPECT_EQ(message_of(replaced(kVersion2, "20 1 0 0", "10 1 0 0")), "m.msh:16: node = 10: is given twice");
  EXPECT_EQ(message_of(replaced(kVersion2, "$Nodes\n5", "$Nodes\n4")),
            "m.msh:19: Nodes section = 50: must end with $EndNodes");
  EXPECT_EQ(message_of(replaced(kVersion2, "$Nodes\n5", "$Nodes\n900000000000")),
            "m.msh:14: number of nodes = 900000000000: is more than the file holds (is it cut short?)");
}

TEST(GmshFile, RejectsElementsThatCannotBe) {
  EXPECT_EQ(message_of(replaced(kVersion2, "9 4 2 7 1 10 20 30 40", "9 4 2 7 1 10 20 30 99")),
            "m.msh:31: node = 99: does not exist");
  EXPECT_EQ(message_of(replaced(kVersion2, "9 4 2 7 1 10 20 30 40", "9 4 2 7 1 10 20 30")),
            "m.msh:31: node is missing; give an integer");
  EXPECT_EQ(message_of(replaced(kVersion2, "9 4 2", "9 11 2")),
            "m.msh:31: element type = 11: elements of higher order are not read; save the mesh with order 1");
  EXPECT_EQ(message_of(replaced(kVersion2, "9 4 2", "9 5 2")),
            "m.msh:31: element type = 5: is not a tetrahedron; mesh the volume with tetrahedra only");
  EXPECT_EQ(message_of(replaced(kVersion2, "9 4 2 7", "9 4 -2 7")),
            "m.msh:31: number of tags = -2: is out of range; use 0 to 1000");
}

TEST(GmshFile, RejectsGroupsThatCannotBe) {
  EXPECT_EQ(message_of(replaced(kVersion2, "\"air\"", "air")),
            "m.msh:7: physical name = air: must be a text in double quotes");
  EXPECT_EQ(message_of(replaced(kVersion4, "1 1 1 7 1 1", "1 1 2 7 8 1 1")),
            "m.msh:17: physical tag = 8: the entity 1 of dimension 3 is already in group 7; an entity has "
            "one name");
  EXPECT_EQ(message_of(replaced(kVersion2, "$Comments", "Comments")),
            "m.msh:10: section = Comments: must begin with $");
}

}  // namespace
}  // namespace etendue::gmsh_file_test
