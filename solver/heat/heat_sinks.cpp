// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_sinks.h"

#include <fmt/format.h>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/heat/heat_balance.h"

namespace etendue {
namespace {

/// Cells that are joined by faces and by sheets that transmit.
class Volume {
 public:
  Volume(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
      : problem_(problem),
        heat_(heat),
        space_(space),
        behind_(faces_behind(problem.mesh())),
        is_seen_(static_cast<std::size_t>(problem.mesh().cell_count()), 0) {}

  bool is_seen(CellIndex cell) const { return is_seen_[cell.at()] != 0; }

  /// Walks through the volume of a cell. Throws where a temperature follows and heat has no way out.
  void check(CellIndex first) {
    waiting_ = {first};
    is_seen_[first.at()] = 1;
    has_sink_ = false;
    following_.reset();
    while (!waiting_.empty()) {
      const CellIndex cell = waiting_.back();
      waiting_.pop_back();
      visit(cell);
    }
    if (!following_ || has_sink_) return;
    const Vec3 place = problem_.mesh().centroid(first);
    throw InputError(fault_at(
        *following_, "",
        fmt::format("its temperature follows from heat, which has no way out of the volume about "
                    "({:.6g}, {:.6g}, {:.6g}): give a wall there a temperature, or convection with h above 0",
                    place.x(), place.y(), place.z())));
  }

 private:
  void visit(CellIndex cell) {
    const TetrahedralMesh& mesh = problem_.mesh();
    if (space_.has(cell))
      following_ = problem_.medium(mesh.region(cell)).origin;
    else
      has_sink_ = has_sink_ || absorption_of_all_bands(problem_, cell) > 0;
    for (const std::int32_t f : mesh.faces(cell)) {
      const FaceIndex face(f);
      if (f < mesh.boundary_face_count())
        visit_wall(cell, face);
      else
        enter(mesh.owner(face) == cell ? mesh.neighbour(face) : mesh.owner(face));
    }
  }

  void visit_wall(CellIndex cell, FaceIndex face) {
    const auto number = static_cast<std::size_t>(problem_.mesh().wall(face));
    const Wall& wall = problem_.walls()[number];
    if (const auto& following = heat_.walls[number]) {
      following_ = wall.origin;
      has_sink_ = has_sink_ || following->heat_transfer_coefficient > 0;
    } else {
      has_sink_ = has_sink_ || wall.refractive_index != 1 ||
                  (space_.conducts(cell) && heat_.wall_temperatures[number]);
      for (std::size_t band = 0; band < wall.diffuse.size(); ++band)
        has_sink_ = has_sink_ || wall.absorptivity(band) > 0;
    }
    if (wall.transmits() && behind_[face.at()] >= 0)
      enter(problem_.mesh().owner(FaceIndex(behind_[face.at()])));
  }

  void enter(CellIndex cell) {
    if (is_seen_[cell.at()] != 0) return;
    is_seen_[cell.at()] = 1;
    waiting_.push_back(cell);
  }

  const Problem& problem_;
  const HeatProblem& heat_;
  const TemperatureSpace& space_;
  std::vector<std::int32_t> behind_;
  std::vector<char> is_seen_;  ///< [cell]
  std::vector<CellIndex> waiting_;
  std::optional<Origin> following_;  ///< of something in the volume whose temperature follows
  bool has_sink_ = false;
};

}  // namespace

void check_heat_sinks(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space) {
  Volume volume(problem, heat, space);
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    if (!volume.is_seen(CellIndex(c))) volume.check(CellIndex(c));
}

}  // namespace etendue
