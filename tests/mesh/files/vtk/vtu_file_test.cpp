// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "tests/mesh/files/read_message.h"
#include "tests/mesh/files/scratch_folder.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::vtu_file_test {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expect_same(const TetrahedralMesh& a, const TetrahedralMesh& b) {
  EXPECT_TRUE(std::ranges::equal(a.points(), b.points()));
  EXPECT_TRUE(std::ranges::equal(a.cell_vertices(), b.cell_vertices()));
  EXPECT_TRUE(std::ranges::equal(a.cell_faces(), b.cell_faces()));
  EXPECT_TRUE(std::ranges::equal(a.face_vertices(), b.face_vertices()));
  EXPECT_TRUE(std::ranges::equal(a.face_cells(), b.face_cells()));
  EXPECT_TRUE(std::ranges::equal(a.face_area_normals(), b.face_area_normals()));
  EXPECT_TRUE(std::ranges::equal(a.volumes(), b.volumes()));
  EXPECT_TRUE(std::ranges::equal(a.cell_regions(), b.cell_regions()));
  EXPECT_TRUE(std::ranges::equal(a.face_walls(), b.face_walls()));
  EXPECT_EQ(a.region_names(), b.region_names());
  EXPECT_EQ(a.wall_names(), b.wall_names());
}

TEST(VtuFile, IsReadBackIdentically) {
  const ScratchFolder folder;
  for (const TetrahedralMesh& mesh : {two_region_mesh(1e-3), cyclic_ring(), single_tetrahedron()}) {
    write_mesh(folder.path() / "m.vtu", mesh);
    expect_same(TetrahedralMesh(read_mesh(folder.path() / "m.vtu")), mesh);
  }
}

TEST(VtuFile, IsReadBackIdenticallyFromAppendedDataToo) {
  const ScratchFolder folder;
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  write_mesh(folder.path() / "m.vtu", mesh, {.encoding = VtkEncoding::appended_raw});
  EXPECT_NE(bytes_of(folder.path() / "m.vtu").find("<AppendedData"), std::string::npos);
  expect_same(TetrahedralMesh(read_mesh(folder.path() / "m.vtu")), mesh);
}

TEST(VtuFile, IsXmlAloneAndHoldsTheTextsThatAreGiven) {
  const ScratchFolder folder;
  write_mesh(folder.path() / "m.vtu", two_region_mesh(1e-2), {.field_texts = {{"title", {"<Two> & two"}}}});
  const std::string text = bytes_of(folder.path() / "m.vtu");
  EXPECT_EQ(text.find("<AppendedData"), std::string::npos);
  EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  for (const char* name : {"title", "region_name", "wall_name", "region_names", "wall_names"})
    EXPECT_NE(text.find(std::string("Name=\"") + name + "\""), std::string::npos) << name;
}

TEST(VtuFile, IsReplacedWholeAndLeavesNothingElse) {
  const ScratchFolder folder;
  const auto path = folder.write("m.vtu", "an older file");
  write_mesh(path, single_tetrahedron());
  EXPECT_EQ(TetrahedralMesh(read_mesh(path)).cell_count(), 1);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(VtuFile, ThatCannotBeWrittenIsAFileError) {
  const ScratchFolder folder;
  try {
    write_mesh(folder.path() / "none" / "m.vtu", single_tetrahedron());
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("none/m.vtu: cannot be written ("), std::string::npos);
  }
  try {
    std::filesystem::create_directory(folder.path() / "taken.vtu");
    folder.write("taken.vtu/file", "x");
    write_mesh(folder.path() / "taken.vtu", single_tetrahedron());
    FAIL() << "written";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("taken.vtu: cannot be written (Is a directory)"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(write_mesh(folder.path() / "m.msh", single_tetrahedron()), InputError);
}

/// A grid of one tetrahedron in ASCII; parts of it can be replaced.
std::string grid(const std::string& cell_data, const std::string& field_data = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>" +
         field_data + "</FieldData>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">\n<CellData>" +
         cell_data +
         "</CellData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
         "0 0 0 1 0 0 0 1 0 0 0 1\n</DataArray></Points>\n<Cells>\n"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 0 1 2 0 1</DataArray>\n"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 7 9</DataArray>\n"
         "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 5 3</DataArray>\n"
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string array(const std::string& name, const std::string& values, const std::string& type = "Int32") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string message_of(const std::string& bytes) {
  const ScratchFolder folder;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::string message = read_message(folder.write("m.vtu", bytes));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  return message;
}

TEST(VtuFile, OfOtherProgramsIsRead) {
  const ScratchFolder folder;
  const RawMesh plain = read_mesh(folder.write("m.vtu", grid("")), 3);
  EXPECT_EQ(plain.cells.size(), 1u);
  EXPECT_EQ(plain.points[3], Vec3(0, 0, 3));
  EXPECT_EQ(plain.region_names, std::vector<std::string>{"domain"});
  EXPECT_TRUE(plain.triangles.empty());
  const RawMesh numbered =
      read_mesh(folder.write("m.vtu", grid(array("region", "4 0 0") + array("wall", "0 2 0"))));
  EXPECT_EQ(numbered.region_names, std::vector<std::string>{"4"});
  EXPECT_EQ(numbered.wall_names, std::vector<std::string>{"2"});
  EXPECT_EQ(numbered.triangles.size(), 1u);
}

TEST(VtuFile, ThatIsNoneIsRejected) {
  EXPECT_EQ(message_of(""), "m.vtu: the file is empty");
  EXPECT_EQ(message_of("hello"), "m.vtu: is not a VTK XML file (no <VTKFile> in it)");
  EXPECT_EQ(message_of("<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"></VTKFile>"),
            "m.vtu: holds no UnstructuredGrid; save the mesh as one");
  EXPECT_EQ(message_of(replaced(grid(""), "NumberOfPoints=\"4\"", "NumberOfPoints=\"400000000000\"")),
            "m.vtu: NumberOfPoints = 400000000000: is more than the file holds (is it cut short?)");
  EXPECT_EQ(message_of(replaced(grid(""), "NumberOfCells=\"3\"", "NumberOfCells=\"-3\"")),
            "m.vtu: NumberOfCells = -3: is not a count");
  const ScratchFolder folder;
  EXPECT_EQ(read_message(folder.path() / "none.vtu"),
            "FileError none.vtu: cannot be opened (No such file or directory)");
}

TEST(VtuFile, ThatIsCutShortIsRejectedWithoutNoise) {
  const ScratchFolder folder;
  write_mesh(folder.path() / "whole.vtu", two_region_mesh(1e-2));
  const std::string whole = bytes_of(folder.path() / "whole.vtu");
  for (std::size_t twentieth = 0; twentieth < 20; ++twentieth) {
    const std::string message = message_of(whole.substr(0, whole.size() * twentieth / 20));
    EXPECT_EQ(message.find("m.vtu: "), 0u) << message;
  }
  const std::string text = grid("");
  EXPECT_EQ(message_of(text.substr(0, 500)).find("m.vtu: VTK cannot read it ("), 0u)
      << message_of(text.substr(0, 500));
}

TEST(VtuFile, WithBytesThatChangedNeverCrashes) {
  const ScratchFolder folder;
  write_mesh(folder.path() / "whole.vtu", TetrahedralMesh(kuhn_cube_raw()));
  const std::string whole = bytes_of(folder.path() / "whole.vtu");
  std::mt19937 random(3);
  int rejected = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::string broken = whole;
    for (int change = 0; change < 3; ++change) broken[random() % broken.size()] = static_cast<char>(random());
    if (message_of(broken) != "no error") ++rejected;
  }
  EXPECT_GT(rejected, 50);
}

TEST(VtuFile, WithCellsThatCannotBeIsRejected) {
  EXPECT_EQ(message_of(replaced(grid(""), "0 1 2 3 0 1 2 0 1", "0 1 2 9 0 1 2 0 1")),
            "m.vtu: cell 0: point 9 does not exist; there are 4");
  EXPECT_EQ(message_of(replaced(grid(""), "0 1 2 3 0 1 2 0 1", "0 1 2 -3 0 1 2 0 1")),
            "m.vtu: cell 0: point -3 does not exist; there are 4");
  EXPECT_EQ(message_of(replaced(grid(""), "4 7 9", "5 7 9")), "m.vtu: cell 0: has 5 points; must have 4");
  EXPECT_EQ(message_of(replaced(grid(""), "4 7 9", "4 70 90")).find("m.vtu: "), 0u);
  EXPECT_EQ(message_of(replaced(grid(""), "4 7 9", "4 2 9")).find("m.vtu: "), 0u);
  EXPECT_EQ(message_of(replaced(grid(""), "10 5 3", "24 5 3")),
            "m.vtu: cell 0: VTK cell type 24 has curved edges or is unknown; use tetrahedra, hexahedra, "
            "wedges, pyramids "
            "or polyhedra");
}

TEST(VtuFile, WithNamesThatCannotBeIsRejected) {
  EXPECT_EQ(message_of(grid(array("region", "1.5 0 0", "Float64"))),
            "m.vtu: cell 0: region = 1.500000: must be an integer");
  EXPECT_EQ(
      message_of(grid(array("region", "1 0 0"),
                      "<Array type=\"String\" Name=\"region_names\" NumberOfTuples=\"1\" format=\"ascii\">97 "
                      "105 114 0</Array>")),
      "m.vtu: cell 0: region = 1: has no name; there are 1 in region_names");
  EXPECT_EQ(message_of(grid("",
                            "<DataArray type=\"Int32\" Name=\"wall_names\" NumberOfTuples=\"1\" "
                            "format=\"ascii\">1</DataArray>")),
            "m.vtu: field array wall_names: must hold strings");
}

TEST(MeshFile, WithAnotherEndingIsRejectedAtTheKey) {
  EXPECT_EQ(
      read_message("room.obj", {"case.toml", 4, "mesh.file"}),
      "case.toml:4: mesh.file = \"room.obj\": is not the name of a mesh file; use .msh (Gmsh), .vtu (VTK), "
      ".node, .ele, .face (TetGen) or the folder of an OpenFOAM case");
}

TEST(MeshFile, ThatIsADirectoryIsAFileError) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "m.msh");
  EXPECT_EQ(
      read_message(folder.path() / "m.msh"),
      "FileError m.msh: is a directory without constant/polyMesh; name a file of a mesh or the folder of an "
      "OpenFOAM case");
}

}  // namespace
}  // namespace etendue::vtu_file_test
