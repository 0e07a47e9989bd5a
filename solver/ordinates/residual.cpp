// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/residual.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Sums of squares of a difference and of the field itself, per band.
class Norms {
 public:
  explicit Norms(int bands) : difference_(static_cast<std::size_t>(bands), 0), field_(difference_) {}

  void add(const double* last, const double* next, std::size_t nodes, std::size_t stride, double weight) {
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t b = 0; b < field_.size(); ++b) {
        const double value = next[i * stride + b];
        const double change = value - last[i * stride + b];
        difference_[b] += weight * change * change;
        field_[b] += weight * value * value;
      }
  }

  double relative(std::size_t band) const {
    // Only where the field is exactly dark there is nothing to compare with; NaN must not look like that.
    return field_[band] == 0 ? 0 : std::sqrt(difference_[band] / field_[band]);
  }

 private:
  std::vector<double> difference_;
  std::vector<double> field_;
};

}  // namespace

std::vector<double> relative_residual(const TetrahedralMesh& mesh, const TransportSweep& sweep,
                                      const TransportState& last, const TransportState& next) {
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto face_nodes = static_cast<std::size_t>(sweep.cells().face_nodes());
  Norms volume(sweep.cells().bands());
  for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c) {
    const std::size_t at = c * nodes * stride;
    volume.add(&last.fluence()[at], &next.fluence()[at], nodes, stride, mesh.volumes()[c]);
  }
  Norms walls(sweep.cells().bands());
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (!sweep.walls().reflects(face)) continue;
    const std::size_t at = face.at() * face_nodes * stride;
    walls.add(&last.irradiance()[at], &next.irradiance()[at], face_nodes, stride, mesh.area(face));
  }
  std::vector<double> result;
  for (std::size_t b = 0; b < static_cast<std::size_t>(sweep.cells().bands()); ++b)
    result.push_back(std::max(volume.relative(b), walls.relative(b)));
  return result;
}

}  // namespace etendue
