// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/mesh_faults.h"

#include <cstdio>

#include "base/position.h"

namespace etendue {
namespace {

constexpr std::size_t kMostFaults = 5;

}  // namespace

std::string to_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string to_text(const Vec3& point) {
  return "(" + to_text(point.x()) + ", " + to_text(point.y()) + ", " + to_text(point.z()) + ")";
}

std::string MeshFaults::point_name(int point) const {
  return std::to_string(raw_.point_numbers.empty() ? point : raw_.point_numbers[position(point)]);
}

std::string MeshFaults::cell_name(int cell) const {
  return std::to_string(raw_.cell_numbers.empty() ? cell : raw_.cell_numbers[position(cell)]);
}

int MeshFaults::line_of(int cell) const {
  return raw_.cell_lines.empty() ? 0 : raw_.cell_lines[position(cell)];
}

void MeshFaults::add_cell(int cell, const std::string& problem, const std::string& advice) {
  std::string names;
  Vec3 sum = Vec3::Zero();
  for (const int point : raw_.cells[position(cell)]) {
    names += " " + point_name(point);
    sum += raw_.points[position(point)];
  }
  add_at_line(line_of(cell), "cell " + cell_name(cell) + ": " + problem + " (vertices" + names +
                                 ", centroid " + to_text(Vec3(sum / 4)) + "); " + advice);
}

void MeshFaults::add_face(const std::array<std::int32_t, 3>& points, const std::vector<int>& cells,
                          const std::string& problem, const std::string& advice) {
  std::string names;
  Vec3 sum = Vec3::Zero();
  for (const int point : points) {
    names += " " + point_name(point);
    sum += raw_.points[position(point)];
  }
  std::string cell_names;
  for (const int cell : cells) cell_names += " " + cell_name(cell);
  add_at_line(cells.empty() ? 0 : line_of(cells.front()),
              "face of vertices" + names + " at " + to_text(Vec3(sum / 3)) +
                  (cells.size() > 1 ? ", cells" : (cells.empty() ? "" : ", cell")) + cell_names + ": " +
                  problem + "; " + advice);
}

void MeshFaults::add_at_line(int line, const std::string& text) {
  if (faults_.size() < kMostFaults)
    faults_.push_back({raw_.file, line, text});
  else
    ++left_out_;
}

void MeshFaults::throw_if_any() const {
  if (faults_.empty()) return;
  std::vector<Fault> faults = faults_;
  if (left_out_ > 0) faults.back().text += " (and " + std::to_string(left_out_) + " more of this kind)";
  throw InputError(faults);
}

}  // namespace etendue
