#include "oracle/true_surfaces.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/drawn_triangles.h"

namespace ssrkit {

namespace {

constexpr const char* kAttemptedSearch = "find what the reflected rays truly meet";

struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using GeometryHandle = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

tl::unexpected<Error> embreeError(RTCError code) {
  const bool is_memory = code == RTC_ERROR_OUT_OF_MEMORY;
  return setupError(kAttemptedSearch,
                    is_memory ? "there is not enough memory for the triangles' hierarchy"
                              : fmt::format("Embree failed with error {}", static_cast<int>(code)),
                    "", is_memory ? "" : "check the installation of the package libembree3-3");
}

struct Query : RTCIntersectContext {
  const SurfaceRay* ray = nullptr;
};

}  // namespace

struct TrueSurfaces::Impl {
  struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  };
  struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  DrawnTriangles triangles;
  // In this order: handles are released in the opposite one.
  std::unique_ptr<RTCDeviceTy, ReleaseDevice> device;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene;

  explicit Impl(DrawnTriangles drawn) : triangles(std::move(drawn)) {}
  Expected<void> commit();
  Expected<void> attachTriangles();
  static void filter(const RTCFilterFunctionNArguments* arguments);
};

Expected<void> TrueSurfaces::Impl::attachTriangles() {
  const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  const std::size_t count = triangles.count();
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* const indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  if (vertices == nullptr || indices == nullptr) {
    return embreeError(rtcGetDeviceError(device.get()));
  }
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    const auto corners = triangles.corners(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 p_view(corners.at(i));
      std::copy_n(&p_view.x, 3, vertices + 3 * (3 * triangle + i));
      indices[3 * triangle + i] = static_cast<unsigned>(3 * triangle + i);
    }
  }
  rtcSetGeometryUserData(geometry.get(), this);
  rtcSetGeometryIntersectFilterFunction(geometry.get(), &filter);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  return {};
}

Expected<void> TrueSurfaces::Impl::commit() {
  // One thread: the same triangles then give the same hierarchy, and equal hits the same triangle.
  device.reset(rtcNewDevice("threads=1"));
  if (device == nullptr) {
    return embreeError(rtcGetDeviceError(nullptr));
  }
  scene.reset(rtcNewScene(device.get()));
  if (triangles.count() > 0) {
    if (const auto attached = attachTriangles(); !attached) {
      return attached;
    }
  }
  // Without the flag rays slip through the edges between triangles.
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene.get());
  const RTCError error = rtcGetDeviceError(device.get());
  return error == RTC_ERROR_NONE ? Expected<void>{} : embreeError(error);
}

void TrueSurfaces::Impl::filter(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) {
    return;
  }
  const DrawnTriangles& triangles = static_cast<const Impl*>(arguments->geometryUserPtr)->triangles;
  const SurfaceRay& ray = *static_cast<const Query*>(arguments->context)->ray;
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const float u = RTCHitN_u(arguments->hit, arguments->N, 0);
  const float v = RTCHitN_v(arguments->hit, arguments->N, 0);
  const auto corner = triangles.corners(triangle);
  const glm::dvec3 cross = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double area = glm::length(cross);
  const bool is_hit = area > 0.0 && triangles.isThere(triangle, cross, ray.dir_view, u, v) &&
                      !triangles.isLeftBy(ray, corner, cross / area);
  arguments->valid[0] = is_hit ? -1 : 0;
}

TrueSurfaces::TrueSurfaces(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TrueSurfaces::~TrueSurfaces() = default;
TrueSurfaces::TrueSurfaces(TrueSurfaces&&) noexcept = default;
TrueSurfaces& TrueSurfaces::operator=(TrueSurfaces&&) noexcept = default;

Expected<TrueSurfaces> TrueSurfaces::build(const Scene& scene, const glm::dmat4& view_from_world) {
  auto impl = std::make_unique<Impl>(DrawnTriangles(scene, view_from_world));
  if (const auto committed = impl->commit(); !committed) {
    return tl::make_unexpected(committed.error());
  }
  return TrueSurfaces(std::move(impl));
}

std::optional<SurfaceHit> TrueSurfaces::firstHit(const SurfaceRay& ray) const {
  RTCRayHit found{};
  const glm::vec3 origin(ray.origin_view);
  const glm::vec3 dir(ray.dir_view);
  found.ray.org_x = origin.x;
  found.ray.org_y = origin.y;
  found.ray.org_z = origin.z;
  found.ray.dir_x = dir.x;
  found.ray.dir_y = dir.y;
  found.ray.dir_z = dir.z;
  found.ray.tnear = static_cast<float>(ray.min_t_m);
  found.ray.tfar = static_cast<float>(ray.max_t_m);
  found.ray.mask = ~0U;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query;
  rtcInitIntersectContext(&query);
  query.ray = &ray;
  rtcIntersect1(impl_->scene.get(), &query, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return std::nullopt;
  }
  const auto corner = impl_->triangles.corners(found.hit.primID);
  const glm::dvec3 normal = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
  const double approach = glm::dot(normal, ray.dir_view);
  const double t_m = glm::dot(normal, corner[0] - ray.origin_view) / approach;
  // A ray within rounding of the plane meets it nowhere in particular: single precision then says where.
  constexpr double kInPlane = 1e-9;
  return SurfaceHit{.t_m = std::abs(approach) > kInPlane ? std::max(t_m, ray.min_t_m) : found.ray.tfar,
                    .normal_view = approach > 0.0 ? -normal : normal,
                    .triangle = found.hit.primID};
}

const glm::dmat4& TrueSurfaces::viewFromWorld() const {
  return impl_->triangles.viewFromWorld();
}

}  // namespace ssrkit
