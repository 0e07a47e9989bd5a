// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/random/random_stream.h"
#include "solver/problem/problem.h"
#include "solver/radiosity/form_factors/ray_scene.h"
#include "solver/radiosity/patches/wall_patches.h"

namespace etendue {

/// Walls from which light continues without becoming diffuse.
enum class Redirection { mirrors_and_lobes, mirrors_alone };

/// What a wall redirects, as a mirror or by its reflectance f_r, of light that meets it at `cosine` > 0 to
/// the normal.
double redirected_part(const Wall& wall, std::size_t band, double cosine, Redirection by);
/// The same of light that is the same from all directions.
double redirected_part_of_isotropic(const Wall& wall, std::size_t band, Redirection by);
/// Returns whether it redirects anything in some band.
bool redirects(const Wall& wall, Redirection by);

/// The random numbers of a path: for its first turn from a sequence that is even over many paths, then its
/// own.
class PathNumbers {
 public:
  PathNumbers(std::uint64_t path, const std::array<double, 3>& first)
      : stream_(0, path, RandomUse::path), next_(first) {}
  /// Three of [0, 1).
  std::array<double, 3> next();

 private:
  RandomStream stream_;
  std::array<double, 3> next_;
  bool begun_ = false;
};

/// Follows rays from wall to wall over mirrors and glossy walls, up to where all that is left is diffuse: the
/// paths of extended form factors (Sillion and Puech 1989).
class ExtendedPaths {
 public:
  /// The arguments must outlive it.
  ExtendedPaths(const Problem& problem, const WallPatches& patches, Redirection by, int threads);

  /// A patch on the path.
  struct Meeting {
    std::size_t patch;
    bool first;                         ///< straight from where the path began
    double cosine;                      ///< of the ray to the patch's normal
    const std::vector<double>& weight;  ///< [band] of what was sent, or seen backwards
  };
  /// Calls look(Meeting) at each patch that the ray meets. By reciprocity a path is light that goes along it,
  /// and light that comes back along it. `weight` is room to work in.
  template <class Look>
  void follow(Vec3 from, Vec3 towards, PathNumbers numbers, std::vector<double>& weight, Look look) const {
    weight.assign(bands_, 1);
    for (int turn = 0; turn < most_turns; ++turn) {
      const auto hit = scene_.first_hit(from, towards);
      if (!hit) return;  // between the triangles of an edge, by rounding
      const std::size_t patch = patch_of_[hit->triangle];
      look(Meeting{patch, turn == 0, std::min(1.0, -towards.dot(patches_.patches[patch].normal())), weight});
      from += hit->distance * towards;
      if (!turn_on(patch, numbers, towards, weight)) return;
    }
  }

  std::size_t bands() const { return bands_; }
  Redirection by() const { return by_; }

 private:
  // Between perfect mirrors a path has no end: there what is farther away is left out.
  static constexpr int most_turns = 1000;

  bool turn_on(std::size_t patch, PathNumbers& numbers, Vec3& towards, std::vector<double>& weight) const;
  bool turn_by_lobe(std::size_t wall, const Vec3& normal, double u, double v, Vec3& towards,
                    std::vector<double>& weight) const;

  /// The lobes of a wall by shape: directions drawn from one hardly show one of another shape.
  struct Lobes {
    std::vector<const Reflectance*> drawn;  ///< one of each shape
    std::vector<std::size_t> shape;         ///< [band] of its lobe: its place among these
  };
  static Lobes lobes_of(const Wall& wall, std::size_t bands);

  const Problem& problem_;
  const WallPatches& patches_;
  Redirection by_;
  std::size_t bands_;
  std::vector<char> redirects_;        ///< [wall]
  std::vector<Lobes> lobes_;           ///< [wall]
  std::vector<std::size_t> patch_of_;  ///< [triangle of the scene]
  RayScene scene_;
};

/// A unit vector about the unit vector z, at this cosine to it and this part of a turn around it.
Vec3 direction_about(const Vec3& z, double cosine, double part_of_turn);

}  // namespace etendue
