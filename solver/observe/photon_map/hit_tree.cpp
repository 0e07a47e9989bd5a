// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/hit_tree.h"

#include <cmath>
#include <nanoflann.hpp>

namespace etendue {
namespace {

constexpr std::size_t leaf_size = 16;

/// Hits as nanoflann reads them.
struct Positions {
  std::span<const PhotonHit> hits;
  std::size_t kdtree_get_point_count() const { return hits.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return hits[i].position[axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using HitIndex = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Positions>,
                                                     Positions, 3, std::uint32_t>;

}  // namespace

struct HitTree::Tree {
  Positions positions;
  HitIndex index;
  explicit Tree(std::span<const PhotonHit> hits)
      : positions{hits}, index(3, positions, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {}
};

HitTree::HitTree(std::span<const PhotonHit> hits) : tree_(std::make_unique<Tree>(hits)) {}
HitTree::~HitTree() = default;
HitTree::HitTree(HitTree&&) noexcept = default;
HitTree& HitTree::operator=(HitTree&&) noexcept = default;

void HitTree::nearest(const Vec3& point, std::size_t count, NearHits& found) const {
  thread_local std::vector<double> squares;
  found.number.resize(count);
  squares.resize(count);
  tree_->index.knnSearch(point.data(), count, found.number.data(), squares.data());
  found.radius = std::sqrt(squares.back());
  found.number.pop_back();
}

}  // namespace etendue
