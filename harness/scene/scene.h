// A scene as plain data: world-space triangles, materials, textures, lights, cameras. No API, no file format.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/environment_choice.h"
#include "spaces/camera.h"

namespace ssrkit {

// Triangles are not indexed: three vertices each, so that face_normal is constant over a triangle and no
// API's provoking-vertex rule matters. The layout is what shaders/gbuffer.vert reads.
struct Vertex {
  glm::vec3 p_world;
  glm::vec3 normal_world;   // unit, shading
  glm::vec4 tangent_world;  // unit, w = handedness (+1/-1); (1,0,0,1) where there is no normal map
  glm::vec2 uv;
  glm::vec3 face_normal_world;  // unit, geometric, by the triangle's winding (counter-clockwise is outside)
  float material_index;         // row of Scene::materials
  glm::vec3 p_previous_world;   // of the same point in the previous frame
};
static_assert(sizeof(Vertex) == 19 * sizeof(float));

enum class Wrap { kRepeat, kClamp, kMirror };

// 8-bit RGBA, row 0 on top, as glTF images are. sRGB-encoded or linear by the material's use of it.
struct Texture {
  std::string name;
  Size size;
  std::vector<std::uint8_t> rgba;
  Wrap wrap_u = Wrap::kRepeat;
  Wrap wrap_v = Wrap::kRepeat;
};

enum class AlphaMode { kOpaque, kMask, kBlend };  // kBlend is drawn as kMask with cutoff 0.5

struct Material {
  std::string name;
  glm::vec4 base_colour{1.0F};  // linear
  float metallic = 1.0F;
  float roughness = 1.0F;
  glm::vec3 emissive{0.0F};  // linear, emissive strength multiplied in
  float normal_scale = 1.0F;
  float alpha_cutoff = 0.5F;
  AlphaMode alpha_mode = AlphaMode::kOpaque;
  bool double_sided = false;
  bool mirror = false;                  // rays are traced from its pixels
  int base_colour_texture = -1;         // indices into Scene::textures, -1 none; sRGB
  int metallic_roughness_texture = -1;  // linear; G roughness, B metallic
  int normal_texture = -1;              // linear, tangent space
  int emissive_texture = -1;            // sRGB
};

inline constexpr std::size_t kMaxLightsOfAKind = 8;  // as in shaders/light.frag and light_ggx.frag

struct DirectionalLight {
  glm::dvec3 direction_world{0.0, -1.0, 0.0};  // the way the light travels, unit
  glm::vec3 radiance{1.0F};                    // colour times intensity
  int tree_node = -1;                          // of the scene's motion, -1: it stands still
};

struct PointLight {  // point and spot lights of KHR_lights_punctual
  glm::dvec3 p_world{0.0};
  glm::dvec3 direction_world{0.0, 0.0, -1.0};
  glm::vec3 intensity{1.0F};
  float range_m = 0.0F;  // 0: unlimited
  float inner_cone_cos = 1.0F;
  float outer_cone_cos = -1.0F;  // -1: a point light
  int tree_node = -1;            // of the scene's motion, -1: it stands still
};

struct SceneCamera {
  std::string name;
  glm::dmat4 view_from_world{1.0};
  glm::dmat4 previous_view_from_world{1.0};  // of the previous frame
  double fov_y_rad = 0.8;
  std::optional<double> aspect;  // as authored; rendering uses the image's own aspect ratio
  double near_m = 0.1;
  double far_m = 1000.0;
  bool far_follows_scene = false;  // the file says none, so far_m depends on the pose
  int tree_node = -1;              // of the scene's motion, -1: it stands still
};

// The triangles that share one set of textures, in one run of vertices: all of opaque materials, or all of
// materials with an alpha cutoff. `material_index` is one of them.
struct DrawRange {
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  int material_index = 0;
};

struct SceneMotion;  // scene/motion.h

struct Scene {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<DrawRange> ranges;
  std::vector<Material> materials;  // never empty
  std::vector<Texture> textures;
  // At most kMaxLightsOfAKind each. Of directional ones there is one at least: a default light is added.
  std::vector<DirectionalLight> directional_lights;
  std::vector<PointLight> point_lights;
  std::vector<SceneCamera> cameras;            // never empty: a camera is framed when the file has none
  glm::vec3 sky_horizon{0.55F, 0.65F, 0.75F};  // linear colours of the background gradient
  glm::vec3 sky_zenith{0.18F, 0.30F, 0.55F};
  EnvironmentChoice environment;              // in the gradient's place, where it names one
  std::shared_ptr<const SceneMotion> motion;  // null: nothing moves
  std::vector<std::string> notes;             // what was defaulted or left out, one sentence each, shown once
};

// The camera for an image of `size`: the projection takes the image's aspect ratio and the camera's vertical
// field of view.
[[nodiscard]] Camera cameraFor(const SceneCamera& scene_camera, Size size);

}  // namespace ssrkit
