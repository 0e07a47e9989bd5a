// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>

namespace etendue {
namespace {

// The part of the path between two points that is not traced, at either end: what single precision moves
// there must not block it, nor the other side of the sheet that a path begins on.
constexpr double end_of_path = 1e-4;
// The same for rays that continue, relative to the size of the scene.
constexpr double begin_of_ray = 1e-6;

/// A hit counts where the ray comes from the front. Rays are asked for one by one.
void keep_fronts(const RTCFilterFunctionNArguments* arguments) {
  const unsigned count = arguments->N;
  const float across = RTCRayN_dir_x(arguments->ray, count, 0) * RTCHitN_Ng_x(arguments->hit, count, 0) +
                       RTCRayN_dir_y(arguments->ray, count, 0) * RTCHitN_Ng_y(arguments->hit, count, 0) +
                       RTCRayN_dir_z(arguments->ray, count, 0) * RTCHitN_Ng_z(arguments->hit, count, 0);
  if (across >= 0) arguments->valid[0] = 0;
}

RTCRay ray_from(const Vec3& from, const Vec3& direction, double begin, double end) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(from[0]);
  ray.org_y = static_cast<float>(from[1]);
  ray.org_z = static_cast<float>(from[2]);
  ray.dir_x = static_cast<float>(direction[0]);
  ray.dir_y = static_cast<float>(direction[1]);
  ray.dir_z = static_cast<float>(direction[2]);
  ray.tnear = static_cast<float>(begin);
  ray.tfar = static_cast<float>(end);
  ray.mask = std::numeric_limits<unsigned>::max();
  return ray;
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  double begin = 0;  ///< of rays [length]

  explicit Embree(int threads) : device(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
    if (device == nullptr) throw std::runtime_error("rays: Embree does not start on this machine");
    scene = rtcNewScene(device);
  }
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void add(const std::vector<TriangleCorners>& triangles) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
    Eigen::AlignedBox3d box;
    for (const TriangleCorners& triangle : triangles)
      for (const Vec3& corner : triangle) box.extend(corner);
    begin = triangles.empty() ? 0 : begin_of_ray * box.diagonal().norm();
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t x = 0; x < 3; ++x)
          corners[9 * t + 3 * i + x] = static_cast<float>(triangles[t][i][static_cast<Eigen::Index>(x)]);
        indices[3 * t + i] = static_cast<unsigned>(3 * t + i);
      }
    rtcSetGeometryIntersectFilterFunction(geometry, keep_fronts);
    rtcSetGeometryOccludedFilterFunction(geometry, keep_fronts);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
      throw std::runtime_error("rays: Embree could not build its tree");
  }
};

RayScene::RayScene(const std::vector<TriangleCorners>& triangles, int threads)
    : embree_(std::make_unique<Embree>(threads)) {
  embree_->add(triangles);
}

RayScene::~RayScene() = default;

std::optional<SceneHit> RayScene::first_hit(const Vec3& from, const Vec3& direction) const {
  RTCRayHit found{};
  found.ray = ray_from(from, direction, embree_->begin, std::numeric_limits<float>::infinity());
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return SceneHit{found.hit.primID, static_cast<double>(found.ray.tfar)};
}

bool RayScene::is_blocked(const Vec3& from, const Vec3& to) const {
  RTCRay ray = ray_from(from, to - from, end_of_path, 1 - end_of_path);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace etendue
