// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs on the meshes of other programs, which get their heat back on their own cells.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mesh/files/fields/field_file.h"
#include "mesh/files/mesh_file.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"
#include "tests/mesh/polyhedra/sample_polyhedra.h"

namespace etendue::coupling_run_test {
namespace {

using sample_polyhedra::hexahedra;
using sample_polyhedra::write_foam_mesh;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::Outcome;
using test::text_of;
using test::write_text;

constexpr std::array<int, 3> cells = {4, 3, 3};
const Vec3 size(2, 1, 1);

/// Hot gas between colder walls.
std::string gas_on(const std::string& mesh) {
  return "[mesh]\n" + mesh +
         "[media.domain]\nabsorption = \"0.5 + x\"\nscattering = 0.5\ntemperature = \"1500 - 800*z\"\n"
         "[walls.\"*\"]\nemissivity = 0.8\ntemperature = 400\n"
         "[walls.zmax]\nemissivity = 0.5\ntemperature = 900\n"
         "[directions]\nset = \"product\"\norder = 4\n[solve]\ntolerance = 1e-10\n"
         "[output]\ndirectory = \"results\"\n";
}

/// A case on the folder `foam` beside it.
class FoamRun : public CaseFolder {
 public:
  explicit FoamRun(const PolyhedralMesh& mesh = hexahedra(cells, size))
      : CaseFolder(gas_on("file = \"foam\"\n")) {
    write_foam_mesh(path() / "foam", mesh);
  }
  void run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"run", file()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = etendue_says(arguments);
    ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  }
  std::string result(const std::string& name) const { return text_of(path() / "results" / name); }
};

/// The numbers of the list that follows a word in a file of OpenFOAM.
std::vector<double> foam_list(const std::string& text, const std::string& after) {
  std::istringstream rest(text.substr(text.find("List<scalar>", text.find(after)) + 12));
  std::size_t count = 0;
  char bracket = 0;
  rest >> count >> bracket;
  std::vector<double> values(count);
  for (double& value : values) rest >> value;
  EXPECT_FALSE(rest.fail()) << after;
  return values;
}

/// [cell] an array of cells.vtu, in which each cell is a hexahedron: its twelve parts have its value.
std::vector<double> array_of_hexahedra(const std::filesystem::path& file, const std::string& name) {
  const FieldData field = read_field({.path = file, .array = name, .component = 0});
  std::vector<double> values;
  for (std::size_t part = 0; part < field.values.size(); ++part)
    if (part % 12 == 0)
      values.push_back(field.values[part]);
    else
      EXPECT_EQ(field.values[part], values.back()) << name;
  return values;
}

TEST(CouplingRun, GivesTheHeatOfEachCellOfTheOpenFoamCase) {
  const FoamRun run;
  run.run();
  const std::vector<double> divergence = foam_list(run.result("openfoam/divergence"), "internalField");
  ASSERT_EQ(divergence.size(), 36U);
  double sum = 0;
  for (const double value : divergence) sum += value * 2 / 36;
  const CsvTable heat(run.result("heat.csv"));
  const double net = heat.number({"region", "domain"}, "net");
  EXPECT_GT(net, 1000);
  EXPECT_NEAR(sum / net, 1, 1e-9);
}

TEST(CouplingRun, GivesTheHeatFluxOfEachFaceOfAPatch) {
  const FoamRun run;
  run.run();
  const CsvTable heat(run.result("heat.csv"));
  const std::string qr = run.result("openfoam/qr");
  for (const auto& [wall, faces, area] :
       {std::tuple("xmax", 9U, 1.0), std::tuple("ymin", 12U, 2.0), std::tuple("zmax", 12U, 2.0)}) {
    const std::vector<double> fluxes = foam_list(qr, std::string(wall) + "\n    {");
    ASSERT_EQ(fluxes.size(), faces) << wall;
    double sum = 0;
    for (const double flux : fluxes) sum += flux * area / faces;
    EXPECT_NEAR(sum / heat.number({"wall", wall}, "net"), 1, 1e-9) << wall;
  }
  // The gas is hottest at the floor, and what is farther in x absorbs and emits more.
  EXPECT_GT(foam_list(qr, "zmin\n    {")[7], foam_list(qr, "zmin\n    {")[4]);
}

TEST(CouplingRun, WritesTheCellsOfTheOtherMeshWithTheirMeans) {
  const FoamRun run;
  run.run();
  const std::filesystem::path file = run.path() / "results/cells.vtu";
  const std::vector<double> divergence = array_of_hexahedra(file, "divergence"),
                            volume = array_of_hexahedra(file, "volume"),
                            temperature = array_of_hexahedra(file, "temperature");
  const std::vector<double> as_foam = foam_list(run.result("openfoam/divergence"), "internalField");
  ASSERT_EQ(divergence.size(), 36U);
  ASSERT_EQ(as_foam.size(), 36U);
  ASSERT_EQ(volume.size(), 36U);
  ASSERT_EQ(temperature.size(), 36U);
  for (std::size_t c = 0; c < 36; ++c) {
    EXPECT_NEAR(divergence[c] / as_foam[c], 1, 1e-9);
    EXPECT_NEAR(volume[c], 2.0 / 36, 1e-15);
    const double z = (static_cast<double>(c / 12) + 0.5) / 3;
    EXPECT_NEAR(temperature[c], 1500 - 800 * z, 1e-9);  // the mean of an affine field
  }
  EXPECT_EQ(array_of_hexahedra(file, "fluence_mean").size(), 36U);
  const RawMesh again = read_mesh(file);
  ASSERT_TRUE(again.parents.mesh != nullptr);
  EXPECT_EQ(again.parents.mesh->cell_count(), 36U);
  EXPECT_EQ(again.region_names, std::vector<std::string>{"domain"});
}

TEST(CouplingRun, AgreesWithTheSameBoxOfTetrahedra) {
  const FoamRun run;
  run.run();
  const CaseFolder box(
      gas_on("edge_length = 0.3\n[[mesh.box]]\nregion = \"domain\"\nmin = [0, 0, 0]\nmax = [2, 1, 1]\n"));
  ASSERT_EQ(etendue_says({"run", box.file()}).code, ExitCode::done);
  const CsvTable there(text_of(box.path() / "results/heat.csv")), here(run.result("heat.csv"));
  for (const auto& [kind, name] :
       {std::pair("region", "domain"), std::pair("wall", "zmin"), std::pair("wall", "ymax")})
    EXPECT_NEAR(here.number({kind, name}, "net") / there.number({kind, name}, "net"), 1, 0.01) << name;
}

TEST(CouplingRun, HasTheSameBitsByAnyNumberOfThreads) {
  const FoamRun run;
  std::vector<std::string> texts[2];
  for (const int threads : {1, 2}) {
    run.run({"--set", "solve.threads=" + std::to_string(threads)});
    for (const char* name : {"openfoam/divergence", "openfoam/qr", "cells.vtu"})
      texts[threads - 1].push_back(run.result(name));
  }
  EXPECT_EQ(texts[0], texts[1]);
}

/// A box none of whose roof faces is flat, with points that single precision does not hold.
PolyhedralMesh warped_box() {
  PolyhedralMesh warped = hexahedra(cells, size);
  for (Vec3& point : warped.points) point.z() *= 1 + 0.05 * std::sin(3 * point.x()) * std::cos(4 * point.y());
  return warped;
}

/// Adds a field of the time 0 to the folder `foam`.
void write_foam_field(const std::filesystem::path& folder, const std::string& name,
                      const std::vector<double>& values) {
  std::filesystem::create_directories(folder / "system");
  std::filesystem::create_directories(folder / "0");
  write_text(folder / "system/controlDict",
             "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
             "startTime 0; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;\n");
  std::ostringstream text;
  text.precision(17);
  text << "FoamFile { version 2.0; format ascii; class volScalarField; object " << name
       << "; }\ndimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar>\n"
       << values.size() << "\n(\n";
  for (const double value : values) text << value << '\n';
  write_text(folder / "0" / name, text.str() + ")\n;\nboundaryField { \".*\" { type zeroGradient; } }\n");
}

TEST(CouplingRun, TakesFieldsOfTheOpenFoamCaseCellByCell) {
  const FoamRun run(warped_box());
  std::vector<double> given;
  for (int c = 0; c < 36; ++c) given.push_back(600 + 25 * c);
  write_foam_field(run.path() / "foam", "T", given);
  run.run(
      {"--set", "media.domain.temperature={file=\"" + (run.path() / "foam").string() + "\",array=\"T\"}"});
  const std::vector<double> taken = array_of_hexahedra(run.path() / "results/cells.vtu", "temperature");
  ASSERT_EQ(taken.size(), 36U);
  for (std::size_t c = 0; c < 36; ++c) EXPECT_NEAR(taken[c], given[c], 1e-9);
}

TEST(CouplingRun, TakesFieldsOnTheSameCellsUnchanged) {
  const FoamRun run(warped_box());
  run.run();
  run.run({"--output", (run.path() / "again").string(), "--set",
           "media.domain.temperature={file=\"" + (run.path() / "results/cells.vtu").string() +
               "\",array=\"temperature\"}"});
  const std::vector<double> given = array_of_hexahedra(run.path() / "results/cells.vtu", "temperature"),
                            taken = array_of_hexahedra(run.path() / "again/cells.vtu", "temperature");
  ASSERT_EQ(given.size(), 36U);
  ASSERT_EQ(taken.size(), 36U);
  for (std::size_t c = 0; c < 36; ++c) EXPECT_NEAR(taken[c], given[c], 1e-9);
}

TEST(CouplingRun, LeavesNoFilesOfAnotherMesh) {
  const FoamRun run;
  run.run();
  write_text(run.path() / "results/openfoam/notes", "mine");
  const CaseFolder box(
      gas_on("edge_length = 0.6\n[[mesh.box]]\nregion = \"domain\"\nmin = [0, 0, 0]\nmax = [2, 1, 1]\n"));
  ASSERT_EQ(etendue_says({"run", box.file(), "--output", (run.path() / "results").string()}).code,
            ExitCode::done);
  EXPECT_FALSE(std::filesystem::exists(run.path() / "results/cells.vtu"));
  EXPECT_EQ(test::ScratchFolder::names_in(run.path() / "results/openfoam"),
            std::vector<std::string>{"notes"});
}

}  // namespace
}  // namespace etendue::coupling_run_test
