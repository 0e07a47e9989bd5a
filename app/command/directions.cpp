// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/command/commands.h"
#include "app/command/text_table.h"
#include "app/write/output_folder.h"
#include "app/write/vtk_files.h"
#include "mesh/base/errors.h"
#include "solver/angle/direction_set.h"

namespace etendue {
namespace {

constexpr int rows_of_a_set = 5;

std::string half_range_error(const DirectionSetReport& report) {
  const auto& errors = report.axis_half_range_error;
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return fmt::format("{:.1e}", *std::max_element(errors.begin(), errors.end(), larger));
}

void add_set(TextTable& table, const std::string& name, int order) {
  const DirectionSetReport report = report_directions(make_directions(name, order));
  table.add_row({name, std::to_string(order), std::to_string(report.count), std::to_string(report.degree),
                 fmt::format("{:.3f} to {:.3f}", report.smallest_weight, report.largest_weight),
                 half_range_error(report), fmt::format("{:.1e}", report.half_range_error_rms),
                 fmt::format("{:.1e}", report.kernel_row_error)});
}

TextTable table_of_sets() {
  return TextTable({"set", "order", "directions", "degree", "weights", "axis walls", "any walls", "kernel"},
                   {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right,
                    Align::right, Align::right});
}

const char* const legend = R"(
degree      highest up to which all polynomials are integrated exactly
weights     smallest and largest, relative to the mean
axis walls  relative error of the half range (pi) of a wall along x, y or z, the worst
any walls   the same, root mean square over 2,000 walls in any direction
kernel      worst error of the normalisation of Henyey-Greenstein scattering with g = 0.8, before correction
)";

std::string overview() {
  TextTable table = table_of_sets();
  for (const std::string& name : direction_set_names()) {
    for (const int order : sample_orders(name, rows_of_a_set)) add_set(table, name, order);
  }
  return table.text() + legend;
}

std::string in_full(const std::string& name, int order) {
  const DirectionSet set = make_directions(name, order);
  TextTable table = table_of_sets();
  add_set(table, name, order);
  std::string text = table.text() + legend + "\nordinate,x,y,z,weight\n";
  for (int m = 0; m < set.count(); ++m) {
    const Vec3& direction = set.direction(OrdinateIndex(m));
    text += fmt::format("{},{},{},{},{}\n", m, direction.x(), direction.y(), direction.z(),
                        set.weight(OrdinateIndex(m)));
  }
  return text;
}

void write_set(const DirectionsRequest& request) {
  const std::filesystem::path& output = *request.output;
  if (output.extension() != ".vtp")
    throw InputError("command line: directions: --output = " + output.string() +
                     ": not a name that directions are written to; use a name that ends in .vtp");
  const DirectionSet set = make_directions(*request.set, *request.order);
  const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
  check_output_directory(folder);
  make_output_directory(folder);
  write_directions(set, output);
}

}  // namespace

ExitCode show_directions(const DirectionsRequest& request, std::ostream& out) {
  if (request.output) write_set(request);
  out << (request.set ? in_full(*request.set, *request.order) : overview());
  return ExitCode::done;
}

}  // namespace etendue
