// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>

#include "app/case/build.h"
#include "app/command/commands.h"
#include "app/command/compare_page.h"
#include "app/command/compare_table.h"
#include "app/command/verbose_log.h"
#include "app/write/output_folder.h"
#include "app/write/unit_labels.h"
#include "app/write/vtk_comparison.h"

namespace etendue {
namespace {

/// [cell][band] second - first, the error of both, and their ratio.
struct DifferenceField {
  std::vector<double> difference, error, in_errors;

  explicit DifferenceField(const Comparison& comparison) {
    const MethodAnswer &first = comparison.first, &second = comparison.second;
    for (std::size_t i = 0; i < first.cells.size(); ++i) {
      difference.push_back(second.cells[i] - first.cells[i]);
      error.push_back(std::hypot(first.cell_errors[i], second.cell_errors[i]));
      in_errors.push_back(etendue::in_errors(difference.back(), first.cell_errors[i], second.cell_errors[i]));
    }
  }
};

void write_comparison(const Comparison& comparison, const Case& input, const Problem& problem,
                      const std::string& tables, std::ostream& out) {
  const std::filesystem::path& directory = input.output.directory;
  const std::string unit = UnitLabels(input.units).flux;
  const DifferenceField field(comparison);
  OutputFolder folder(directory);
  write_cells(problem.mesh(), problem.bands().names,
              {{"fluence_" + comparison.first.method, unit, comparison.first.cells},
               {"fluence_" + comparison.second.method, unit, comparison.second.cells},
               {"difference", unit, field.difference},
               {"error", unit, field.error},
               {"difference_in_errors", "1", field.in_errors}},
              folder.add("difference.vtu"), directory / "difference.vtu");
  folder.add_text("comparison.csv", comparison_csv(comparison));
  folder.add_text(
      "comparison.html",
      comparison_page(comparison, problem, input.title.empty() ? "Comparison" : input.title, tables));
  folder.publish({});
  out << "written to " << directory.string() << ": difference.vtu comparison.csv comparison.html"
      << std::endl;
}

}  // namespace

ExitCode compare_case(const CompareRequest& request, std::ostream& out, std::ostream& err) {
  const Case input = read_case(request.run.file, request.run.overrides);
  const std::filesystem::path directory = std::filesystem::absolute(input.output.directory);
  check_output_directory(directory);
  const TetrahedralMesh mesh = build_mesh(input, verbose_log(request.run, err));
  const Problem problem = build_problem(input, mesh);
  const ComparedCase compared{request.run, directory, mesh};
  const auto answer = [&](const std::string& method) {
    out << "\nby " << method << "\n";
    return method == "photons" ? answer_by_photons(compared, out, err)
                               : answer_by_ordinates(compared, out, err);
  };
  Comparison comparison{answer(request.methods[0]), {}};
  if (comparison.first.whole) comparison.second = answer(request.methods[1]);
  if (!comparison.first.whole || !comparison.second.whole) {
    err << "interrupted: there is nothing to compare\n";
    return ExitCode::interrupted;
  }
  const auto& bands = problem.bands().names;
  const std::string tables =
      comparison_text(comparison, cell_agreement(comparison, mesh, bands.size()), bands);
  out << tables;
  write_comparison(comparison, input, problem, tables, out);
  return ExitCode::done;
}

}  // namespace etendue
