// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "app/case/build/build.h"
#include "app/progress/text_table.h"
#include "app/request/commands.h"
#include "app/write/result/output_folder.h"
#include "app/write/vtk/vtk_files.h"
#include "base/errors.h"
#include "solver/angular/harmonics/direction_report.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {
namespace {

constexpr int rows_of_a_set = 5;

std::string short_number(double value) { return fmt::format("{:.1e}", value); }

std::string largest_axis_error(const DirectionSetReport& report) {
  const auto& errors = report.axis_half_range_error;
  return short_number(*std::max_element(errors.begin(), errors.end()));
}

void add_set(TextTable& table, const DirectionSet& set, const DirectionSetReport& report) {
  table.add_row({set.name(), std::to_string(set.order()), std::to_string(report.count),
                 fmt::format("{:.3f} to {:.3f}", report.smallest_weight, report.largest_weight),
                 short_number(report.first_moment_error), short_number(report.second_moment_error),
                 std::to_string(report.degree), largest_axis_error(report),
                 short_number(report.half_range_error_rms), short_number(report.kernel_row_error)});
}

TextTable table_of_sets() {
  constexpr auto right = Align::right;
  return TextTable({"set", "order", "directions", "weights", "first", "second", "degree", "axis walls",
                    "any walls", "kernel"},
                   {Align::left, right, right, right, right, right, right, right, right, right});
}

const char* const legend = R"(
weights     smallest and largest, relative to the mean
first       |sum of w Omega|, which is 0 on the sphere
second      largest error in the sum of w Omega Omega, which is 4 pi/3 times the unit matrix (in the plane pi)
degree      highest up to which all polynomials are integrated exactly
axis walls  relative error of the half range (pi; in the plane 2) of a wall along x, y or z, the worst
any walls   the same, root mean square over 2,000 walls in any direction
kernel      worst error of the normalisation of Henyey-Greenstein scattering with g = 0.8, before correction
)";

/// The meaning of the order n of each set.
const std::map<std::string, const char*> order_meanings = {
    {"product", "n Gauss-Legendre levels of the cosine about z (n even), each with 2 n azimuths: 2 n^2"},
    {"triangular",
     "n Gauss-Legendre levels of the cosine about z (n even), with 4, 8, 12, ... azimuths: n (n + 2)"},
    {"double-gauss", "n >= 2 Gauss-Legendre levels on each side of z = 0, each with 4 n azimuths: 8 n^2"},
    {"ldfe-sq", "n^2 quadrilaterals on each third of an octant, with 4 directions each: 96 n^2"},
    {"level-symmetric", "n levels about each axis, S_n (n even, 2 to 16): n (n + 2)"},
    {"thurgood", "n^2 triangles in each octant, T_n: 8 n^2"},
    {"lebedev", "the degree of the rule (3, 5, 7, ... 131): about (n + 1)^2 / 3"},
    {"flatland", "n directions in the plane z = 0 (a multiple of 4)"}};

std::string overview() {
  TextTable table = table_of_sets();
  for (const std::string& name : direction_set_names())
    for (const int order : sample_orders(name, rows_of_a_set)) {
      const DirectionSet set = make_directions(name, order);
      add_set(table, set, report_directions(set));
    }
  std::string text = table.text() + legend + "\norder n and number of directions\n";
  for (const std::string& name : direction_set_names())
    text += fmt::format("  {:17}{}\n", name, order_meanings.at(name));
  return text;
}

/// The sums of w, w Omega and w Omega Omega.
std::string sums(const DirectionSet& set) {
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  double weight = 0;
  for (int m = 0; m < set.count(); ++m) {
    const Vec3& direction = set.direction(OrdinateIndex(m));
    const double w = set.weight(OrdinateIndex(m));
    weight += w;
    first += w * direction;
    second += w * direction * direction.transpose();
  }
  std::string text = fmt::format("\nsum of w              {:.15g}\n", weight);
  text += fmt::format("sum of w Omega        {:.2e} {:.2e} {:.2e}\n", first.x(), first.y(), first.z());
  for (int i = 0; i < 3; ++i)
    text += fmt::format("{:22}{:.15g} {:.15g} {:.15g}\n", i == 0 ? "sum of w Omega Omega" : "", second(i, 0),
                        second(i, 1), second(i, 2));
  return text;
}

std::string in_full(const DirectionSet& set) {
  const DirectionSetReport report = report_directions(set);
  TextTable table = table_of_sets();
  add_set(table, set, report);
  const auto& axis = report.axis_half_range_error;
  std::string text = table.text() + legend +
                     fmt::format("order n     {} directions\n",
                                 order_meanings.at(set.name().substr(set.name().rfind(' ') + 1))) +
                     sums(set);
  text += fmt::format("axis walls, x y z     {:.2e} {:.2e} {:.2e}\n", axis[0], axis[1], axis[2]);
  text += "\nordinate,x,y,z,weight\n";
  for (int m = 0; m < set.count(); ++m) {
    const Vec3& direction = set.direction(OrdinateIndex(m));
    text += fmt::format("{},{},{},{},{}\n", m, direction.x(), direction.y(), direction.z(),
                        set.weight(OrdinateIndex(m)));
  }
  return text;
}

void write_set(const DirectionSet& set, const Case& input, const std::filesystem::path& output) {
  if (output.extension() != ".vtp")
    throw InputError("command line: directions: --output = " + output.string() +
                     ": not a name that directions are written to; use a name that ends in .vtp");
  const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
  check_output_directory(folder);
  make_output_directory(folder);
  write_directions(set, input, output);
}

}  // namespace

ExitCode show_directions(const DirectionsRequest& request, std::ostream& out) {
  if (!request.set && !request.file) {
    if (request.output)
      throw InputError("command line: directions: --output = " + request.output->string() +
                       ": which set is meant (there are many); use --set and --order, or a case");
    out << overview();
    return ExitCode::done;
  }
  const Case input = request.file ? read_case(*request.file) : Case{};
  const DirectionSet set =
      request.file ? build_directions(input) : make_directions(*request.set, *request.order);
  if (request.output) write_set(set, input, *request.output);
  out << in_full(set);
  return ExitCode::done;
}

}  // namespace etendue
