// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "solver/materials/phase/phase_sampler.h"
#include "solver/photons/kernel/photon_scene.h"
#include "solver/photons/sampling/directional_medium.h"
#include "solver/photons/sampling/formula_emission.h"
#include "solver/problem/phase_list.h"
#include "solver/problem/problem.h"

namespace etendue {

/// What of a problem depends on the direction.
struct DirectionalInput {
  /// The problem must outlive it.
  explicit DirectionalInput(const Problem& problem) : media(problem), emission(problem) {}
  bool empty() const { return media.empty() && emission.empty(); }

  DirectionalMedia media;
  FormulaEmission emission;
};

/// One band of a problem as photons see it. Coefficients are the means of cells, as everywhere.
class PhotonMesh {
 public:
  /// The arguments must outlive it.
  PhotonMesh(const Problem& problem, const DirectionalInput& input, int band);
  PhotonMesh(const PhotonMesh&) = delete;
  PhotonMesh& operator=(const PhotonMesh&) = delete;

  PhotonSceneView view() const {
    return {cells_.data(), faces_.data(), deflections_.data(), in_plane_, by_direction_};
  }
  const std::vector<PhotonCell>& cells() const { return cells_; }
  const std::vector<PhotonFace>& faces() const { return faces_; }
  /// Of a region that emits by a formula; null: it does not.
  const FormulaEmitter* emitter(int region) const {
    return deflections_[static_cast<std::size_t>(region)].emitter;
  }
  /// How far a ray goes in a cell; below zero where it starts outside.
  double distance_through(CellIndex cell, const Vec3& point, const Vec3& direction) const;

 private:
  void add_cells(const Problem& problem, int band);
  void add_faces(const Problem& problem, const FormulaEmission& emission, int band);
  void add_deflections(const Problem& problem, const DirectionalInput& input, int band);

  bool in_plane_;
  bool by_direction_;
  std::vector<PhotonCell> cells_;
  std::vector<PhotonFace> faces_;  ///< [boundary face]
  std::vector<std::unique_ptr<PhaseSampler>> samplers_;
  std::vector<Deflection> deflections_;  ///< [region]
};

/// What photons do not know in a problem: kernels as matrices. Throws InputError that names each.
void refuse_for_photons(const Problem& problem);

}  // namespace etendue
