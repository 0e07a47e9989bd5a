// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/response.h"

#include "base/field_view.h"
#include "base/vector_sums.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

/// The uncollided part of each kind of response.
struct UncollidedPartOf {
  const LightSetup& lights;
  const UncollidedField& field;

  std::vector<double> operator()(const PointFluence& point) const {
    return lights.at(point_of(lights.problem().mesh(), point.cells), std::nullopt).fluence;
  }

  std::vector<double> operator()(const MeanIrradiance& mean) const {
    std::vector<double> sum(lights.paths().bands(), 0);
    for (const auto& cells : mean.points)
      add_to(sum, lights.at(point_of(lights.problem().mesh(), cells), mean.normal).irradiance,
             1 / static_cast<double>(mean.points.size()));
    return sum;
  }

  std::vector<double> operator()(const ArrivingPower& at) const {
    const TetrahedralMesh& mesh = lights.problem().mesh();
    std::vector<double> power(lights.paths().bands(), 0);
    const ConstFaceField irradiance(field.irradiance, power.size());
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      for (std::size_t b = 0; b < power.size() && mesh.wall(FaceIndex(f)) == at.wall; ++b)
        power[b] += mesh.area(FaceIndex(f)) * irradiance.mean(FaceIndex(f), b);
    return power;
  }

  std::vector<double> operator()(const AbsorbedPower& in) const {
    const TetrahedralMesh& mesh = lights.problem().mesh();
    std::vector<double> power(lights.paths().bands(), 0);
    const ConstCellField fluence(field.fluence, power.size());
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
      for (std::size_t b = 0; b < power.size() && mesh.region(CellIndex(c)) == in.region; ++b)
        power[b] += mesh.volume(CellIndex(c)) *
                    (field.absorbed.empty()
                         ? absorbed_share(lights.problem(), in, CellIndex(c), static_cast<int>(b)) *
                               fluence.mean(CellIndex(c), b)
                         : ConstBandTable(field.absorbed, power.size())(CellIndex(c), b));
    return power;
  }
};

}  // namespace

PointInCell point_of(const TetrahedralMesh& mesh, const std::vector<CellPoint>& cells) {
  const CellPoint& place = cells.front();
  Vec3 position = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) position += place.barycentric[k] * corner_of(mesh, place.cell, k);
  return {place.cell, position};
}

double absorbed_share(const Problem& problem, const AbsorbedPower& response, CellIndex cell, int band) {
  return problem.mesh().region(cell) == response.region ? problem.absorption(cell, band) : 0;
}

std::vector<double> uncollided_response(const Response& response, const LightSetup& lights,
                                        const UncollidedField& field) {
  return std::visit(UncollidedPartOf{lights, field}, response);
}

}  // namespace etendue
