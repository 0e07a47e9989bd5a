// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/lights/extended_source.h"

namespace etendue {
namespace {

/// A piece is looked at in parts where what arrives from its points differs from what even matter would
/// leave, in all, by more than this part of what the whole light brings; parts of it by the next number.
constexpr std::array<double, 1> uneven_triangle = {0.01};
constexpr std::array<double, 2> uneven_volume = {0.005, 0.01};
/// Its logarithm is a number.
constexpr double least_transmittance = std::numeric_limits<double>::min();

/// By how much what arrives from these points, as far as they are seen, differs in a band from what would
/// through even matter that takes as much from them in the mean.
double unevenness(const SeenBeams& beams, std::size_t first, std::size_t last, std::size_t band) {
  const std::size_t bands = beams.clear.bands();
  const auto depth = [&](std::size_t i) {
    return -std::log(std::max(beams.passed[i * bands + band], least_transmittance));
  };
  double depths = 0, ways = 0, sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    if (!beams.is_open(i)) continue;
    depths += beams.clear.fluence(i)[band] * depth(i);
    ways += beams.clear.fluence(i)[band] * beams.clear.way(i).distance;
  }
  if (!(ways > 0)) return 0;
  for (std::size_t i = first; i < last; ++i)
    if (beams.is_open(i))
      sum += beams.arriving[i * bands + band] *
             std::abs(1 - std::exp(depth(i) - depths / ways * beams.clear.way(i).distance));
  return sum;
}

}  // namespace

void SeenBeams::append(const SeenBeams& other, std::size_t first, std::size_t last) {
  const std::size_t bands = clear.bands();
  for (std::size_t i = first; i < last; ++i)
    std::ranges::copy(other.clear.fluence(i),
                      clear.add(other.clear.direction(i), other.clear.way(i)).begin());
  const auto add = [&](const std::vector<double>& from, std::vector<double>& to) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first * bands),
              from.begin() + static_cast<std::ptrdiff_t>(last * bands));
  };
  add(other.passed, passed);
  add(other.arriving, arriving);
}

/// Looks at pieces from one place.
class ExtendedSource::Looker {
 public:
  Looker(const ExtendedSource& source, const PointInCell& at, SeenBeams& beams)
      : source_(source), at_(at), beams_(beams), whole_(beams.clear.bands(), 0) {
    if (source.tree_.shape() == EmitterShape::triangles)
      uneven_ = uneven_triangle;
    else
      uneven_ = uneven_volume;
  }

  void add(std::span<const LightPiece> pieces) {
    SeenBeams first_look(beams_.clear.bands());
    std::vector<std::size_t> ends;
    for (const LightPiece& piece : pieces) {
      look(piece, first_look);
      ends.push_back(first_look.clear.size());
    }
    for (std::size_t i = 0; i < first_look.arriving.size(); ++i)
      whole_[i % whole_.size()] += first_look.arriving[i];
    for (std::size_t i = 0; i < pieces.size(); ++i)
      keep_or_cut(pieces[i], first_look, i == 0 ? 0 : ends[i - 1], ends[i], uneven_);
  }

 private:
  /// What a volume would bring through nothing but itself, [band].
  std::vector<double> before_way(const LightPiece& piece) const {
    std::vector<double> sum(whole_.size(), 0), one(whole_.size());
    for (const LightPoint& point : source_.points_of(piece)) {
      std::ranges::fill(one, 1.0);
      const Vec3 direction = source_.paths_.mirrors().image_direction(piece.view.mirrors, point.looking);
      source_.scale(piece, point, direction, one);
      for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += one[b];
    }
    return sum;
  }

  // What a thick volume takes of its own light needs no rays, and so is integrated more finely.
  void look(const LightPiece& piece, SeenBeams& beams) const {
    const std::size_t before = beams.arriving.size();
    look_along_rays(piece, beams);
    if (piece.group >= 0 || piece.rule != TriangleRule::three_points ||
        source_.tree_.shape() == EmitterShape::triangles)
      return;
    LightPiece finer = piece;
    finer.rule = TriangleRule::seven_points;
    const std::vector<double> coarse = before_way(piece), fine = before_way(finer);
    for (std::size_t i = before; i < beams.arriving.size(); ++i)
      if (const std::size_t b = i % whole_.size(); coarse[b] > 0) beams.arriving[i] *= fine[b] / coarse[b];
  }

  void look_along_rays(const LightPiece& piece, SeenBeams& beams) const {
    source_.add_clear(piece, beams.clear);
    const std::size_t bands = beams.clear.bands();
    for (const LightPoint& point : source_.points_of(piece)) {
      const Vec3 direction = source_.paths_.mirrors().image_direction(piece.view.mirrors, point.looking);
      beams.passed.resize(beams.passed.size() + bands);
      const std::span<double> passed = std::span(beams.passed).last(bands);
      const bool open = source_.pass(at_, piece, point, direction, passed);
      beams.arriving.insert(beams.arriving.end(), passed.begin(), passed.end());
      const std::span<double> arriving = std::span(beams.arriving).last(bands);
      if (open) {
        source_.scale(piece, point, direction, arriving);
      } else {
        std::ranges::fill(passed, -1.0);
        std::ranges::fill(arriving, 0.0);
      }
    }
  }

  void keep_or_cut(const LightPiece& piece, const SeenBeams& seen, std::size_t first, std::size_t last,
                   std::span<const double> uneven) {
    bool even = true;
    for (std::size_t b = 0; b < whole_.size() && !uneven.empty(); ++b)
      even = even && unevenness(seen, first, last, b) <= uneven[0] * whole_[b];
    if (even) return beams_.append(seen, first, last);
    for (const LightPiece& part : source_.parts_of(piece)) {
      SeenBeams closer(whole_.size());
      look(part, closer);
      keep_or_cut(part, closer, 0, closer.clear.size(), uneven.subspan(1));
    }
  }

  const ExtendedSource& source_;
  const PointInCell& at_;
  SeenBeams& beams_;
  std::vector<double> whole_;       ///< [band] what arrives by the first look
  std::span<const double> uneven_;  ///< [cut]
};

void ExtendedSource::look(const PointInCell& at, LightDetail detail, SeenBeams& beams) const {
  Looker(*this, at, beams).add(cut(at.position, detail));
}

std::vector<LightPiece> ExtendedSource::parts_of(const LightPiece& piece) const {
  std::vector<LightPiece> parts;
  if (piece.group < 0) {
    for (const SphericalTriangle& directions : quarters(piece.wedge.directions)) {
      parts.push_back(piece);
      parts.back().wedge.directions = directions;
    }
    return parts;
  }
  const EmitterTree::Node& node = tree_.node(piece.group);
  if (node.part < 0) {
    for (const int child : node.children) parts.push_back({piece.view, child});
  } else if (tree_.shape() == EmitterShape::triangles) {
    cut_triangle(piece.view, coarse_light, tree_.part(node.part), {}, parts);
  } else {
    cut_tetrahedron(piece.view, coarse_light, tree_.part(node.part), parts);
  }
  return parts;
}

}  // namespace etendue
