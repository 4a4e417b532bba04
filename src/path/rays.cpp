// Embree 3, one ray at a time. The hierarchy is built by all cores, whatever the number of threads that follow paths: what a ray meets does not
// depend on who asks.
#include "path/rays.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "parallel/parallel_for.hpp"
#include "reference/face.hpp"

#ifdef LUSTRO_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

namespace lustro {
namespace {

float largest_coordinate(const Vec3f& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

PlacedTriangle placed_triangle(const PreparedScene& scene, std::uint32_t instance, std::uint32_t triangle) {
  const Instance& i = scene.instances[instance];
  const Face face{scene, i, scene.materials[i.material_of(triangle)], i.mesh->triangles[triangle], 1};
  PlacedTriangle placed{face.position(0), face.position(1), face.position(2), face.face_normal()};
  constexpr float kRounding = 0x1p-20F;
  placed.offset = kRounding * std::max({largest_coordinate(placed.a), largest_coordinate(placed.b), largest_coordinate(placed.c)});
  return placed;
}

#ifdef LUSTRO_HAS_EMBREE

namespace {

constexpr std::size_t kPart = 4096;  // triangles that one thread looks at

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, SceneRelease>;

void set_ray(RTCRay& to, const Ray& ray) {
  to.org_x = ray.origin.x;
  to.org_y = ray.origin.y;
  to.org_z = ray.origin.z;
  to.tnear = ray.nearest;
  to.dir_x = ray.direction.x;
  to.dir_y = ray.direction.y;
  to.dir_z = ray.direction.z;
  to.time = 0;
  to.tfar = ray.farthest;
  to.mask = 0xFFFFFFFFU;
  to.id = 0;
  to.flags = 0;
}

}  // namespace

struct RayScene::State {
  // Of one instance: what is asked of a triangle at every hit, beside the vertices, which the hierarchy keeps.
  struct Triangle {
    Vec3f normal;
    float offset = 0;
  };
  struct Table {
    const Mesh* mesh = nullptr;
    const Vec3f* positions = nullptr;
    std::vector<Triangle> triangles;
  };
  Device device;
  EmbreeScene scene;
  std::vector<Table> tables;
};

Result<RayScene> RayScene::make(const PreparedScene& scene) {
  auto state = std::make_unique<State>();
  state->device.reset(rtcNewDevice(nullptr));
  const auto failed = [] { return fail(ErrorKind::limit, "", "Embree finds no memory for the scene's triangles"); };
  if (state->device == nullptr) {
    return fail(ErrorKind::unsupported, "--engine path", "Embree does not run on this machine");
  }
  state->scene.reset(rtcNewScene(state->device.get()));
  rtcSetSceneFlags(state->scene.get(), RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  state->tables.resize(scene.instances.size());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = *instance.mesh;
    if (mesh.triangles.empty()) {
      continue;
    }
    RTCGeometry geometry = rtcNewGeometry(state->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions = static_cast<Vec3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.positions.size()));
    if (positions == nullptr) {
      rtcReleaseGeometry(geometry);
      return failed();
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      positions[v] = instance.relative_from_object(mesh.positions[v]);
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                               mesh.triangles.size());
    State::Table& table = state->tables[i];
    table.mesh = &mesh;
    table.positions = positions;
    table.triangles.resize(mesh.triangles.size());
    parallel_for((mesh.triangles.size() + kPart - 1) / kPart, 0, [&](std::size_t part) {
      for (std::size_t t = part * kPart; t < std::min((part + 1) * kPart, mesh.triangles.size()); ++t) {
        const PlacedTriangle placed = placed_triangle(scene, i, static_cast<std::uint32_t>(t));
        table.triangles[t] = {placed.normal, placed.offset};
      }
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(state->scene.get(), geometry, i);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(state->scene.get());
  if (rtcGetDeviceError(state->device.get()) != RTC_ERROR_NONE) {
    return failed();
  }
  return RayScene(std::move(state));
}

bool RayScene::closest(const Ray& ray, RayHit& hit) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  set_ray(query.ray, ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(state_->scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return false;
  }
  hit = {query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v};
  return true;
}

bool RayScene::is_blocked(const Ray& ray) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRay query{};
  set_ray(query, ray);
  rtcOccluded1(state_->scene.get(), &context, &query);
  return query.tfar < 0;
}

PlacedTriangle RayScene::met(const RayHit& hit) const {
  const State::Table& table = state_->tables[hit.instance];
  const auto& [a, b, c] = table.mesh->triangles[hit.triangle];
  const State::Triangle& triangle = table.triangles[hit.triangle];
  return {table.positions[a], table.positions[b], table.positions[c], triangle.normal, triangle.offset};
}

#else

struct RayScene::State {};

Result<RayScene> RayScene::make(const PreparedScene& /*scene*/) {
  return fail(ErrorKind::unsupported, "--engine path", "this build follows no paths: it was made without Embree");
}

// NOLINTBEGIN(readability-convert-member-functions-to-static): with Embree they are not
bool RayScene::closest(const Ray& /*ray*/, RayHit& /*hit*/) const {
  return false;
}

bool RayScene::is_blocked(const Ray& /*ray*/) const {
  return false;
}

PlacedTriangle RayScene::met(const RayHit& /*hit*/) const {
  return {};
}
// NOLINTEND(readability-convert-member-functions-to-static)

#endif

RayScene::RayScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

}  // namespace lustro
