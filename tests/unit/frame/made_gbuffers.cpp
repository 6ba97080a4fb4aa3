#include "made_gbuffers.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../kit_shaders.h"

namespace ssrkit {

namespace {

Job emptyJob(Size size) {
  Job job;
  job.id = "made by formula";
  job.size = size;
  job.shader_root = kitShaders();
  job.gbuffer_camera =
      Camera{.size = size,
             .clip_from_view =
                 perspective(2.0 * std::atan(0.5), static_cast<double>(size.width) / size.height, 0.1, 100.0),
             .view_from_world = glm::dmat4(1.0),
             .near_m = 0.1,
             .far_m = 100.0};
  job.gbuffer = {{"dist_view", Image(size, {"Z"})},
                 {"normal_view", Image(size, {"R", "G", "B"})},
                 {"material", Image(size, {"R", "G", "B"})}};
  return job;
}

}  // namespace

Job randomBlocks(Size size) {
  constexpr int kBlock = 8;
  Job job = emptyJob(size);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int columns = (size.width + kBlock - 1) / kBlock;
  std::vector<glm::dvec4> blocks;  // normal, distance
  for (int i = 0; i < columns * ((size.height + kBlock - 1) / kBlock); ++i) {
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3(2.0 * unit(random) - 1.0, 2.0 * unit(random) - 1.0, 0.2 + unit(random)));
    blocks.emplace_back(
        normal, unit(random) < 0.2 ? std::numeric_limits<double>::infinity() : 2.0 + 8.0 * unit(random));
  }
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const glm::dvec4& block =
          blocks[static_cast<std::size_t>(y / kBlock) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(x / kBlock)];
      job.gbuffer.at("dist_view").at(x, y) = static_cast<float>(block.w);
      job.gbuffer.at("material").at(x, y, 2) = 1.0F;
      for (int axis = 0; axis < 3; ++axis) {
        job.gbuffer.at("normal_view").at(x, y, static_cast<std::size_t>(axis)) =
            static_cast<float>(block[axis]);
      }
    }
  }
  return job;
}

Job randomTerrain(Size size) {
  Job job = randomBlocks(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      float& dist = job.gbuffer.at("dist_view").at(x, y);
      const double hills =
          6.0 + 2.0 * std::sin(0.11 * x + 1.0) * std::cos(0.13 * y) + 0.5 * std::sin(0.31 * (x - y));
      dist = std::isinf(dist) ? dist : static_cast<float>(hills);
    }
  }
  return job;
}

Job floorAndWall(Size size, double wall_m) {
  Job job = emptyJob(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double ndc_y = 1.0 - 2.0 * (y + 0.5) / size.height;
      const double floor_m = ndc_y < 0.0 ? 2.0 / -ndc_y : std::numeric_limits<double>::infinity();
      const bool is_floor = floor_m < wall_m;
      job.gbuffer.at("dist_view").at(x, y) = static_cast<float>(is_floor ? floor_m : wall_m);
      job.gbuffer.at("normal_view").at(x, y, is_floor ? 1 : 2) = 1.0F;
      job.gbuffer.at("material").at(x, y, 2) = is_floor ? 1.0F : 0.0F;
    }
  }
  return job;
}

}  // namespace ssrkit
