// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/run_context.h"
#include "app/write/result/output_folder.h"
#include "app/write/vtk/vtk_files.h"
#include "mesh/files/mesh_file.h"
#include "mesh/tetrahedra/mesh_report.h"

namespace etendue {
namespace {

void check_ending(const std::filesystem::path& output) {
  if (output.extension() != ".vtu")
    throw InputError("command line: mesh: --output = " + output.string() +
                     ": not a name that meshes are written to; use a name that ends in .vtu");
}

}  // namespace

ExitCode mesh_case(const MeshRequest& request, std::ostream& out, std::ostream& err) {
  Interruption interruption;
  check_ending(request.output);
  const std::filesystem::path folder = std::filesystem::absolute(request.output).parent_path();
  const Case input = read_case(request.file, request.overrides);
  write_deprecations(input, err);
  check_output_directory(folder);
  const TetrahedralMesh mesh = mesh_visibly(input, verbose_log(request, err),
                                            {resolved_style(ProgressStyle::automatic, out), out, {}});
  interruption.note_all();
  make_output_directory(folder);
  write_mesh(request.output, mesh, mesh_file_options(input));
  out << to_string(mesh_report(mesh), mesh, input.units.length) << "written to " << request.output.string()
      << '\n';
  return interruption.noted() ? ExitCode::interrupted : ExitCode::done;
}

}  // namespace etendue
