// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/random/drawn_numbers.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/sampling/angle_table.h"
#include "solver/photons/solve/photon_mesh.h"
#include "solver/problem/lights/tangent_cone.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Counterclockwise seen from where it shines to.
struct EmittingTriangle {
  std::array<Vec3, 3> corner;
};

/// Everything that sends light in one band, and where and in which direction histories begin. All histories
/// begin with the same weight; how many begin where is stratified over the power, in the order of the cells:
/// neighbours in number are neighbours in space.
class PhotonSources {
 public:
  /// The arguments must outlive it.
  PhotonSources(const Problem& problem, const PhotonMesh& mesh, const CellLocator& locator, int band);

  double power() const { return cumulative_.empty() ? 0 : cumulative_.back(); }

  /// The histories of a batch, by number.
  struct Batch {
    std::uint64_t first;
    std::size_t count;
  };
  /// The starts of `count` histories of a batch from number `from` on; all weigh 1.
  std::vector<PhotonStart> starts(std::uint64_t seed, const Batch& batch, std::size_t from,
                                  std::size_t count) const;

 private:
  enum class Kind : std::int32_t {
    cell,
    cell_vertex,
    face,
    point,
    beam,
    beam_piece,
    triangle,
    cell_corner,
    face_corner
  };
  struct Source {
    Kind kind;
    std::int32_t index;  ///< of a cell, a face or a light
    std::int32_t
        part;  ///< the face or the piece by which a beam comes in, the triangle of a light, the corner
  };
  /// A part of a face that a beam with a profile lights.
  struct BeamPiece {
    std::int32_t face;
    EmittingTriangle triangle;
    double largest;  ///< bound of the relative irradiance on it
  };
  void add(Source source, double power);
  void add_media();
  void add_walls();
  void add_lights();
  void add_beam_pieces(const BeamLight& beam, std::int32_t light, std::int32_t face);
  PhotonStart start_of(const Source& source, DrawnNumbers& random) const;
  PhotonStart started(const Vec3& point, const Vec3& direction) const;
  PhotonStart from_cell(std::int32_t cell, DrawnNumbers& random) const;
  /// From a vertex's part of a cell whose emission is linear.
  PhotonStart from_cell_vertex(std::int32_t cell, std::size_t vertex, DrawnNumbers& random) const;
  /// A point of a cell as likely as its barycentric coordinate of the vertex is large.
  Vec3 point_towards_vertex(std::int32_t cell, std::size_t vertex, DrawnNumbers& random) const;
  /// In the direction of a beam, or without one as Lambert says.
  PhotonStart from_face(std::int32_t face, const Vec3* beam, DrawnNumbers& random) const;
  PhotonStart from_beam_piece(const BeamLight& beam, const BeamPiece& piece, DrawnNumbers& random) const;
  /// From a corner's part of a cell or face that emits by a formula.
  PhotonStart from_cell_corner(std::int32_t cell, std::size_t corner, DrawnNumbers& random) const;
  PhotonStart from_face_corner(std::int32_t face, std::size_t corner, DrawnNumbers& random) const;
  Vec3 refracted_in(const PhotonFace& face, DrawnNumbers& random) const;
  PhotonStart from_point(std::int32_t light, DrawnNumbers& random) const;
  Vec3 direction_of(const PointLight& light, const AngleTable& angles, DrawnNumbers& random) const;
  PhotonStart from_surface(const EmittingTriangle& triangle, DrawnNumbers& random) const;
  void start_inside(const Vec3& point, const Vec3& direction, PhotonStart& start) const;
  Vec3 isotropic(DrawnNumbers& random) const;
  Vec3 lambert(const Vec3& normal, const Vec3& tangent, DrawnNumbers& random) const;

  const Problem& problem_;
  const PhotonMesh& mesh_;
  const CellLocator& locator_;
  std::size_t band_;
  bool in_plane_;
  std::vector<Source> sources_;
  std::vector<double> cumulative_;  ///< [source] power of it and of all before it
  std::vector<BeamPiece> beam_pieces_;
  std::vector<AngleTable> angles_;  ///< [light] of a point light
  std::vector<TangentCone> cones_;  ///< [light] of a point light; of others of the whole sphere
};

}  // namespace etendue
