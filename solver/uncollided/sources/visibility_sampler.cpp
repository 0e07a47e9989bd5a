// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/uncollided/sources/extended_source.h"

namespace etendue {
namespace {

/// A patch is subdivided where the fluence of its points differs, in sum, from that through a homogeneous
/// medium by more than this part of the fluence of the whole light; its parts where by the next number.
constexpr std::array<double, 1> tolerance_of_triangle = {0.01};
constexpr std::array<double, 2> tolerance_of_volume = {0.005, 0.01};
/// Its logarithm is a number.
constexpr double smallest_transmittance = std::numeric_limits<double>::min();

/// Optical depth of the path up to the light, mirrors left out.
double depth(const VisibleRaySamples& beams, std::size_t i, std::size_t band, double reflectance) {
  if (!(reflectance > 0)) return 0;
  return -std::log(
      std::max(beams.passed[i * beams.clear.bands() + band] / reflectance, smallest_transmittance));
}

/// Mean extinction along the open ones of these rays [1/length].
double mean_extinction(const VisibleRaySamples& beams, std::size_t first, std::size_t last, std::size_t band,
                       double reflectance) {
  double depths = 0, lengths = 0;
  for (std::size_t i = first; i < last; ++i) {
    if (!beams.is_open(i) || !(beams.clear.interval(i).distance > 0)) continue;
    depths += beams.clear.fluence(i)[band] * depth(beams, i, band, reflectance);
    lengths += beams.clear.fluence(i)[band] * beams.clear.interval(i).distance;
  }
  return lengths > 0 ? depths / lengths : 0;
}

/// Fluence of these points through a homogeneous medium of their mean extinction, in sum, and the sum of the
/// differences of each from the sampled fluence.
struct HomogeneousEstimate {
  double extinction = 0;  ///< of that medium [1/length]
  double arriving = 0;
  double difference = 0;

  HomogeneousEstimate(const VisibleRaySamples& beams, std::size_t first, std::size_t last, std::size_t band,
                      double reflectance)
      : extinction(mean_extinction(beams, first, last, band, reflectance)) {
    for (std::size_t i = first; i < last; ++i) {
      if (!beams.is_open(i)) continue;
      const double arrives = beams.arriving[i * beams.clear.bands() + band];
      const double distance = beams.clear.interval(i).distance;
      const double homogeneous =
          distance > 0 ? arrives * std::exp(depth(beams, i, band, reflectance) - extinction * distance)
                       : arrives;
      arriving += homogeneous;
      difference += std::abs(arrives - homogeneous);
    }
  }
};

}  // namespace

void VisibleRaySamples::append(const VisibleRaySamples& other, std::size_t first, std::size_t last) {
  const std::size_t bands = clear.bands();
  for (std::size_t i = first; i < last; ++i)
    std::ranges::copy(other.clear.fluence(i),
                      clear.add(other.clear.direction(i), other.clear.interval(i)).begin());
  const auto add = [&](const std::vector<double>& from, std::vector<double>& to) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first * bands),
              from.begin() + static_cast<std::ptrdiff_t>(last * bands));
  };
  add(other.passed, passed);
  add(other.arriving, arriving);
}

/// Samples patches from one point.
class ExtendedSource::VisibilitySampler {
 public:
  VisibilitySampler(const ExtendedSource& source, const PointInCell& at, VisibleRaySamples& beams)
      : source_(source), at_(at), beams_(beams), whole_(beams.clear.bands(), 0) {
    if (source.tree_.shape() == EmitterShape::triangles)
      tolerances_ = tolerance_of_triangle;
    else
      tolerances_ = tolerance_of_volume;
  }

  void add(std::span<const EmitterPatch> patches) {
    VisibleRaySamples first_samples(beams_.clear.bands());
    std::vector<std::size_t> ends;
    for (const EmitterPatch& patch : patches) {
      sample(patch, first_samples);
      ends.push_back(first_samples.clear.size());
    }
    for (std::size_t i = 0; i < first_samples.arriving.size(); ++i)
      whole_[i % whole_.size()] += first_samples.arriving[i];
    for (std::size_t i = 0; i < patches.size(); ++i)
      keep_or_cut(patches[i], first_samples, i == 0 ? 0 : ends[i - 1], ends[i], tolerances_);
  }

 private:
  double reflectance(const EmitterPatch& patch, std::size_t band) const {
    return source_.paths_.mirrors().reflectance(patch.view.mirrors, band);
  }

  void sample(const EmitterPatch& patch, VisibleRaySamples& beams) const {
    source_.add_clear(patch, beams.clear);
    const std::size_t bands = beams.clear.bands();
    for (const LightPoint& point : source_.points_of(patch)) {
      const Vec3 direction = source_.paths_.mirrors().image_direction(patch.view.mirrors, point.looking);
      beams.passed.resize(beams.passed.size() + bands);
      const std::span<double> passed = std::span(beams.passed).last(bands);
      const bool open = source_.pass(at_, patch, point, direction, passed);
      beams.arriving.insert(beams.arriving.end(), passed.begin(), passed.end());
      const std::span<double> arriving = std::span(beams.arriving).last(bands);
      if (open) {
        source_.scale(patch, point, arriving);
      } else {
        std::ranges::fill(passed, -1.0);
        std::ranges::fill(arriving, 0.0);
      }
    }
  }

  void keep_or_cut(const EmitterPatch& patch, const VisibleRaySamples& samples, std::size_t first,
                   std::size_t last, std::span<const double> tolerances) {
    bool is_close = true;
    for (std::size_t b = 0; b < whole_.size() && !tolerances.empty(); ++b)
      is_close = is_close && HomogeneousEstimate(samples, first, last, b, reflectance(patch, b)).difference <=
                                 tolerances[0] * whole_[b];
    if (is_close) return keep(patch, samples, first, last);
    for (const EmitterPatch& part : source_.parts_of(patch)) {
      VisibleRaySamples closer(whole_.size());
      sample(part, closer);
      keep_or_cut(part, closer, 0, closer.clear.size(), tolerances.subspan(1));
    }
  }

  // The self-absorption of a thick volume needs no rays, and so is integrated with more points, behind a
  // homogeneous medium with the mean extinction of the rays.
  void keep(const EmitterPatch& patch, const VisibleRaySamples& samples, std::size_t first,
            std::size_t last) {
    bool open = true;
    for (std::size_t i = first; i < last; ++i) open = open && samples.is_open(i);
    if (!open || patch.group >= 0 || patch.rule != TriangleRule::three_points ||
        source_.tree_.shape() == EmitterShape::triangles)
      return beams_.append(samples, first, last);
    const std::size_t bands = whole_.size();
    std::vector<double> extinction(bands), left(bands);
    for (std::size_t b = 0; b < bands; ++b) {
      const HomogeneousEstimate homogeneous(samples, first, last, b, reflectance(patch, b));
      double arriving = 0;
      for (std::size_t i = first; i < last; ++i) arriving += samples.arriving[i * bands + b];
      extinction[b] = homogeneous.extinction;
      left[b] = reflectance(patch, b) * (homogeneous.arriving > 0 ? arriving / homogeneous.arriving : 1);
    }
    EmitterPatch finer = patch;
    finer.rule = TriangleRule::seven_points;
    source_.add_clear(finer, beams_.clear);
    for (const LightPoint& point : source_.points_of(finer)) {
      for (std::size_t b = 0; b < bands; ++b)
        beams_.passed.push_back(left[b] * std::exp(-extinction[b] * point.distance));
      const std::span<const double> passed = std::span(beams_.passed).last(bands);
      beams_.arriving.insert(beams_.arriving.end(), passed.begin(), passed.end());
      source_.scale(finer, point, std::span(beams_.arriving).last(bands));
    }
  }

  const ExtendedSource& source_;
  const PointInCell& at_;
  VisibleRaySamples& beams_;
  std::vector<double> whole_;           ///< [band] fluence of the first samples
  std::span<const double> tolerances_;  ///< [cut]
};

void ExtendedSource::sample(const PointInCell& at, LightDetail detail, VisibleRaySamples& beams) const {
  VisibilitySampler(*this, at, beams).add(cut(at.position, detail));
}

std::vector<EmitterPatch> ExtendedSource::parts_of(const EmitterPatch& patch) const {
  std::vector<EmitterPatch> parts;
  if (patch.group < 0) {
    for (const SphericalTriangle& directions : quarters(patch.wedge.directions)) {
      parts.push_back(patch);
      parts.back().wedge.directions = directions;
    }
    return parts;
  }
  const EmitterTree::Node& node = tree_.node(patch.group);
  if (node.part < 0) {
    LightDetail detail = coarse_light;
    detail.single = 0;
    for (const int child : node.children) cut_node(patch.view, detail, child, parts);
  } else if (tree_.shape() == EmitterShape::triangles) {
    cut_triangle(patch.view, coarse_light, tree_.part(node.part), {}, parts);
  } else {
    cut_tetrahedron(patch.view, coarse_light, tree_.part(node.part), parts);
  }
  return parts;
}

}  // namespace etendue
