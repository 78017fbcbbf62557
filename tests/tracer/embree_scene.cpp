// SPDX-License-Identifier: BSD-3-Clause
#include "embree_scene.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <limits>
#include <stdexcept>
#include <string>

namespace tracer {
namespace {

void intersect(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
#endif
}

// A filter that belongs to the geometry works alike in both versions of Embree and needs no scene flag.
void reject_lower_side(const RTCFilterFunctionNArguments* candidate) {
  RTCRayN* ray = candidate->ray;
  const unsigned n = candidate->N;
  // Which side is which the relief says; the normal that Embree has depends on the order of corners.
  const auto& relief = *static_cast<const Relief*>(candidate->geometryUserPtr);
  const std::size_t panel = RTCHitN_primID(candidate->hit, n, 0);
  const glm::dvec2 along = relief.profile[panel + 1] - relief.profile[panel];
  if (RTCRayN_dir_z(ray, n, 0) * along.x - RTCRayN_dir_y(ray, n, 0) * along.y > 0) candidate->valid[0] = 0;
}

void check(RTCDevice device) {
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree reports error " + std::to_string(static_cast<int>(error)) +
                             ", expected none, while it was given the relief");
}

RTCGeometry make_quads(RTCDevice device, const Relief& relief) {
  const RTCGeometry quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      quads, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 2 * relief.profile.size()));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(quads, RTC_BUFFER_TYPE_INDEX, 0,
                                                               RTC_FORMAT_UINT4, 4 * sizeof(unsigned),
                                                               static_cast<std::size_t>(relief.panels())));
  check(device);
  for (const glm::dvec2 point : relief.profile) {
    for (const double x : {-relief.length / 2, relief.length / 2}) {
      *vertex++ = static_cast<float>(x);
      *vertex++ = static_cast<float>(point.x);
      *vertex++ = static_cast<float>(point.y);
    }
  }
  for (unsigned panel = 0; panel < static_cast<unsigned>(relief.panels()); ++panel) {
    // Neighbours share their vertices, so that no ray slips through between them.
    for (const unsigned corner : {0U, 1U, 3U, 2U}) *index++ = 2 * panel + corner;
  }
  rtcSetGeometryUserData(quads, const_cast<Relief*>(&relief));
  rtcSetGeometryIntersectFilterFunction(quads, reject_lower_side);
  rtcCommitGeometry(quads);
  return quads;
}

}  // namespace

EmbreeScene::EmbreeScene(const Relief& relief) {
  const RTCDevice device = rtcNewDevice("threads=1");
  if (!device) throw std::runtime_error("Embree gives no device");
  const RTCScene scene = rtcNewScene(device);
  const auto kept_relief = std::make_shared<const Relief>(relief);
  scene_ = std::shared_ptr<void>(scene, [device, kept_relief](void* held) {
    rtcReleaseScene(static_cast<RTCScene>(held));
    rtcReleaseDevice(device);
  });
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry quads = make_quads(device, *kept_relief);
  rtcAttachGeometry(scene, quads);
  rtcReleaseGeometry(quads);
  rtcCommitScene(scene);
  check(device);
}

std::optional<int> EmbreeScene::first_panel(glm::dvec3 origin, glm::dvec3 direction) const {
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(origin.x);
  ray.ray.org_y = static_cast<float>(origin.y);
  ray.ray.org_z = static_cast<float>(origin.z);
  ray.ray.dir_x = static_cast<float>(direction.x);
  ray.ray.dir_y = static_cast<float>(direction.y);
  ray.ray.dir_z = static_cast<float>(direction.z);
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;

  intersect(static_cast<RTCScene>(scene_.get()), ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return static_cast<int>(ray.hit.primID);
}

}  // namespace tracer
