// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "app/case/build/build.h"
#include "app/compare/compare_page.h"
#include "app/compare/compare_table.h"
#include "app/progress/progress.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/run_context.h"
#include "app/write/result/output_folder.h"
#include "app/write/result/unit_labels.h"
#include "app/write/vtk/vtk_comparison.h"

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

/// `suffix` tells the files of several comparisons apart.
void write_comparison(const Comparison& comparison, const Case& input, const Problem& problem,
                      const std::string& tables, const std::string& suffix, std::ostream& out) {
  const std::filesystem::path& directory = input.output.directory;
  const std::string unit = UnitLabels(input.units).flux;
  const DifferenceField field(comparison);
  OutputFolder folder(directory);
  write_cells(problem.mesh(), input,
              {{"fluence_" + comparison.first.method, unit, comparison.first.cells},
               {"fluence_" + comparison.second.method, unit, comparison.second.cells},
               {"difference", unit, field.difference},
               {"error", unit, field.error},
               {"difference_in_errors", "1", field.in_errors}},
              folder.add("difference" + suffix + ".vtu"), directory / ("difference" + suffix + ".vtu"));
  folder.add_text("comparison" + suffix + ".csv", comparison_csv(comparison));
  folder.add_text(
      "comparison" + suffix + ".html",
      comparison_page(comparison, problem, input.title.empty() ? "Comparison" : input.title, tables));
  const std::vector<std::string> names = folder.names();
  folder.publish({});
  out << "written to " << directory.string() << ":";
  for (const std::string& name : names) out << " " << name;
  out << std::endl;
}

}  // namespace

ExitCode compare_case(const CompareRequest& request, std::ostream& out, std::ostream& err) {
  const Case input = read_case(request.run.file, request.run.overrides);
  write_deprecations(input, err);
  // What a method refuses is known before another one has run.
  for (const std::string& method : request.methods) {
    std::vector<std::string> overrides = request.run.overrides;
    overrides.push_back(fmt::format("solve.method=\"{}\"", method == "ordinates" ? "auto" : method));
    read_case(request.run.file, overrides);
  }
  const std::filesystem::path directory = std::filesystem::absolute(input.output.directory);
  check_output_directory(directory);
  const TetrahedralMesh mesh = mesh_visibly(input, verbose_log(request.run, err),
                                            {resolved_style(request.run.progress, out), out, {}});
  const Problem problem = build_problem(input, mesh);
  const ComparedCase compared{request.run, directory, mesh};
  Comparison comparison;
  for (std::size_t i = 0; i < request.methods.size(); ++i) {
    out << "\nby " << request.methods[i] << "\n";
    MethodAnswer& answer = i == 0 ? comparison.first : comparison.second;
    answer = answer_by(request.methods[i], compared, out, err);
    if (!answer.whole) {
      err << "interrupted: there is nothing to compare\n";
      return ExitCode::interrupted;
    }
    if (i == 0) continue;
    const auto& bands = problem.bands().names;
    const std::string tables =
        comparison_text(comparison, cell_agreement(comparison, mesh, bands.size()), bands);
    out << tables;
    const std::string suffix = request.methods.size() > 2 ? "-" + request.methods[i] : "";
    write_comparison(comparison, input, problem, tables, suffix, out);
  }
  return ExitCode::done;
}

}  // namespace etendue
