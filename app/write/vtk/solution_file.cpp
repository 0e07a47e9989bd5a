// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/vtk/solution_bytes.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "app/write/json/summary.h"
#include "app/write/result/fingerprint.h"
#include "app/write/result/output_folder.h"
#include "app/write/vtk/vtk_arrays.h"
#include "app/write/vtk/vtk_output.h"
#include "base/array_bytes.h"
#include "base/child_process.h"
#include "mesh/files/vtk/vtk_threads.h"

namespace etendue {
namespace {

constexpr const char* file_name = "solution.vtu";
constexpr const char* direction_error_name = "direction_error";
constexpr const char* following_name = "temperature_unknowns";

std::vector<std::string> lines_of(const std::vector<CasePart>& case_parts) {
  std::vector<std::string> lines;
  for (const CasePart& part : case_parts) lines.push_back(part.name + " " + part.hash);
  return lines;
}

// ---- In the child process: VTK on a file that may be broken -----------------------------------------------

std::vector<double> values_of(vtkDataArray* array) {
  auto* doubles = vtkDoubleArray::SafeDownCast(array);
  if (doubles == nullptr) return {};
  const double* first = doubles->GetPointer(0);
  return {first, first + doubles->GetNumberOfValues()};
}

/// Each string with a line end.
std::vector<char> texts_of(vtkFieldData& fields, const char* name) {
  std::vector<char> text;
  auto* strings = vtkStringArray::SafeDownCast(fields.GetAbstractArray(name));
  for (vtkIdType i = 0; strings != nullptr && i < strings->GetNumberOfValues(); ++i) {
    const std::string value = strings->GetValue(i);
    text.insert(text.end(), value.begin(), value.end());
    text.push_back('\n');
  }
  return text;
}

int read_to_file(const std::filesystem::path& path, std::FILE* file) {
  use_vtk_without_threads();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || grid == nullptr) return 1;
  vtkFieldData& fields = *grid->GetFieldData();
  for (const char* name : {"format", "mesh_hash", "case_parts", "band_names"})
    write_array(file, texts_of(fields, name));
  write_array(file, std::vector<std::int64_t>{grid->GetNumberOfCells()});
  write_array(file, values_of(grid->GetCellData()->GetArray("collided_fluence")));
  for (const StatePart& part : state_parts) write_array(file, values_of(fields.GetArray(part.name)));
  write_array(file, values_of(grid->GetCellData()->GetArray(direction_error_name)));
  write_array(file, values_of(fields.GetArray(following_name)));
  return 0;
}

// ---- Here -------------------------------------------------------------------------------------------------

SavedSolution read_solution(const std::filesystem::path& path) {
  if (!std::ifstream(path) || std::filesystem::is_directory(path))
    throw FileError(path.string(), "cannot be opened; name the solution.vtu of an earlier run");
  const ChildOutcome child =
      run_in_child([&](std::FILE* file) { return read_to_file(path, file); }, {}, memory_to_read(path));
  const bool whole = child.signal == 0 && child.exit_code == 0;
  std::optional<SavedSolution> saved = whole ? take_solution(child.result) : std::nullopt;
  if (!saved)
    throw FileError(path.string(),
                    "is not a solution.vtu of this version, or is damaged; name that of an earlier run");
  return std::move(*saved);
}

std::string bracketed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "[" : ", [") + name + "]";
  return text;
}

std::string quoted_path(const InputFile& file) { return "\"" + file.path.string() + "\""; }

/// Of the method of the case: photons add histories to histories, sweeps go on from moments.
void check_method(const InputFile& file, const Case& input, const SavedSolution& saved) {
  if (input.photons && saved.result.state.photons.empty())
    throw InputError(
        fault_at(file.origin, quoted_path(file),
                 "is not a solution by photons (histories are added to those of an earlier run); "
                 "start from one, or without"));
  if (!input.photons && !saved.result.state.photons.empty())
    throw InputError(fault_at(file.origin, quoted_path(file),
                              "is a solution by photons, and sweeps cannot go on from it; start from one by "
                              "ordinates, or without"));
}

SavedSolution read_of_case(const InputFile& file, const Case& input) {
  SavedSolution saved = read_solution(file.path);
  check_method(file, input, saved);
  const std::vector<std::string> different = different_parts(saved.case_parts, case_parts(input));
  if (different.empty()) return saved;
  throw InputError(fault_at(file.origin, quoted_path(file),
                            "is a solution of another case (" + bracketed(different) +
                                " differ); only the title, [mesh] if it gives the same cells, "
                                "space.positivity, photometric units, [solve], [[probe]], "
                                "[[camera]], [[sensor]] and [output] may, so start without or undo that"));
}

}  // namespace

void write_solution(const Case& input, const Problem& problem, const SavedState& state,
                    std::span<const double> direction_error, const std::filesystem::path& path,
                    const std::filesystem::path& shown) {
  const TetrahedralMesh& mesh = problem.mesh();
  const vtkSmartPointer<vtkUnstructuredGrid> grid = joined_cells(mesh);
  vtkFieldData& fields = *grid->GetFieldData();
  add_names(fields, "format", {solution_format});
  add_names(fields, "mesh_hash", {mesh_hash(mesh)});
  add_names(fields, "case_parts", lines_of(case_parts(input)));
  add_bands(fields, problem.bands());
  add_named_cells(*grid, "region", mesh.cell_regions(), mesh.region_names());
  grid->GetCellData()->AddArray(vtk_array(
      {"collided_fluence", {}, {}},
      static_cast<int>(state.fluence.size() / static_cast<std::size_t>(mesh.cell_count())), state.fluence));
  if (!direction_error.empty())
    grid->GetCellData()->AddArray(vtk_array({direction_error_name, {}, {}}, state.bands, direction_error));
  for (const StatePart& part : state_parts) {
    const std::vector<double>& values = state.*part.values;
    if (!values.empty()) fields.AddArray(vtk_array({part.name, {}, {}}, state.bands, values));
  }
  if (!state.following.empty()) fields.AddArray(vtk_array({following_name, {}, {}}, 1, state.following));
  write_vtk(*grid, {path, shown, input.output.encoding, input.title, input.units.length});
}

void check_initial(const InputFile& file, const Case& input) { read_of_case(file, input); }

SavedState read_initial(const InputFile& file, const Case& input, const TetrahedralMesh& mesh) {
  return std::move(read_result(file, input, mesh).state);
}

SavedResult read_result(const InputFile& file, const Case& input, const TetrahedralMesh& mesh) {
  SavedSolution saved = read_of_case(file, input);
  if (saved.mesh != mesh_hash(mesh) || saved.cells != mesh.cell_count())
    throw InputError(fault_at(
        file.origin, quoted_path(file),
        fmt::format("is a solution on another mesh (of {} cells; here are {}); start from a result of the "
                    "same mesh, or without",
                    saved.cells, mesh.cell_count())));
  return std::move(saved.result);
}

void write_checkpoint(const Case& input, const Problem& problem, const SavedState& state) {
  const std::filesystem::path& directory = input.output.directory;
  OutputFolder folder(directory);
  write_solution(input, problem, state, {}, folder.add(file_name), directory / file_name);
  folder.lock();
  folder.publish(files_of_earlier_run(directory));
}

}  // namespace etendue
