// Records, images and answers made by hand, for tests of what is held against them.
#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

#include "check/evaluate.h"
#include "check/read_expectations.h"
#include "check/subject.h"

namespace ssrkit {

inline constexpr Size kMadeSize{8, 8};  // of records in which a few rays or texels are changed

inline RayHit hitAt(int x, int y, std::uint32_t lookups = 10) {
  RayHit hit;
  hit.ray_class = RayClass::kHit;
  hit.texel_x = x;
  hit.texel_y = y;
  hit.px_x = static_cast<float>(x) + 0.5F;
  hit.px_y = static_cast<float>(y) + 0.5F;
  hit.t_m = 1.0F;
  hit.lookups = lookups;
  hit.steps = lookups;
  return hit;
}

inline RayHit without(RayClass ray_class, std::uint32_t lookups = 10) {
  RayHit hit;
  hit.ray_class = ray_class;
  const bool no_ray = ray_class == RayClass::kMasked || ray_class == RayClass::kBackground;
  hit.lookups = no_ray ? 0 : lookups;
  return hit;
}

// Every pixel (x, y) hits (x, (y + height / 2) % height): never its own texel in an image of at least 2 rows.
inline RayRecord shiftedRecord(Size size) {
  RayRecord record{size, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      record.rays.push_back(hitAt(x, (y + size.height / 2) % size.height));
    }
  }
  return record;
}

// A level camera of 90 degrees.
inline Camera squareCamera(Size size) {
  Camera camera;
  camera.size = size;
  constexpr double kRightAngle = 1.5707963267948966;
  constexpr double kNear = 0.1;
  constexpr double kFar = 100.0;
  camera.clip_from_view =
      perspective(kRightAngle, static_cast<double>(size.width) / size.height, kNear, kFar);
  camera.near_m = kNear;
  camera.far_m = kFar;
  return camera;
}

// Owns what answers point at.
struct Bench {
  std::deque<RayRecord> records;
  std::deque<Image> images;
  std::deque<OracleResult> oracles;
  std::deque<GeometryResult> geometries;
  std::deque<OracleInput> inputs;
  std::deque<Camera> cameras;
  std::vector<Answer> answers;

  Answer& add(const std::string& stage, RayRecord record, const std::string& device = "gl-osmesa",
              const std::string& case_name = "") {
    records.push_back(std::move(record));
    Answer answer;
    answer.stage = stage;
    answer.device = device;
    answer.case_name = case_name;
    answer.size = records.back().size;
    answer.record = &records.back();
    return answers.emplace_back(std::move(answer));
  }

  // Gives the answer an oracle that says `record`, without ties.
  OracleResult& setOracle(Answer& answer, RayRecord record) {
    OracleResult result;
    result.ambiguity.assign(record.rays.size(), Ambiguity::kNone);
    result.record = std::move(record);
    oracles.push_back(std::move(result));
    answer.oracle = &oracles.back();
    return oracles.back();
  }

  // Gives the answer a world: a wall at `dist_view` everywhere, seen by mirrors that face the camera.
  OracleInput& setWorld(Answer& answer, float dist_view) {
    cameras.push_back(squareCamera(answer.size));
    Image& depth = images.emplace_back(answer.size, std::vector<std::string>{"dist_view"});
    std::ranges::fill(depth.data, dist_view);
    Image& normals = images.emplace_back(answer.size, std::vector<std::string>{"x", "y", "z"});
    for (std::size_t i = 2; i < normals.data.size(); i += 3) {
      normals.data[i] = 1.0F;
    }
    OracleInput input;
    input.camera = &cameras.back();
    input.dist_view = &depth;
    input.normal_view = &normals;
    inputs.push_back(input);
    answer.oracle_input = &inputs.back();
    return inputs.back();
  }

  // Gives the answer, which must have a world, rays that all meet the wall in the middle of their own texel.
  GeometryResult& setGeometry(Answer& answer) {
    GeometryResult& geometry = geometries.emplace_back(answer.size);
    const float dist_view = answer.oracle_input->dist_view->data.front();
    for (int y = 0; y < answer.size.height; ++y) {
      std::vector<TrueRay> row;
      for (int x = 0; x < answer.size.width; ++x) {
        TrueRay& ray = row.emplace_back();
        ray.true_class = TrueClass::kVisible;
        ray.t_m = 2.0;
        ray.dist_view = dist_view;
        ray.plane.px = {x + 0.5, y + 0.5};
        ray.plane.inv_dist = 1.0 / dist_view;
      }
      geometry.setRow(y, row);
    }
    answer.geometry = &geometry;
    return geometry;
  }

  Image& setImage(Answer& answer, const std::string& buffer, float value) {
    Image& image = images.emplace_back(answer.size, std::vector<std::string>{"v"});
    std::ranges::fill(image.data, value);
    answer.images[buffer] = &image;
    return image;
  }

  [[nodiscard]] CheckResult check(const Expectation& expectation, std::size_t self = 0,
                                  const std::string& scene = "made") const {
    return evaluate(expectation, Subject{"test", scene, &answers.at(self), answers, "./ssrkit run"});
  }
};

// The one expectation of a file whose [[expect]] section is `section`.
inline Expectation expectation(const std::string& section, const std::string& cases = "") {
  const std::string file =
      "[test]\nid = \"t\"\nabout = \"a\"\nscenes = [\"all\"]\nstages = [\"hiz\", \"walk\"]\n"
      "rounds = 15\nsizes = [\"8x8\", \"16x16\"]\n" +
      cases + "[[expect]]\n" + section;
  const Expected<TestFile> test = readExpectations(file, "made.toml");
  if (!test) {
    ADD_FAILURE() << sentence(test.error());
    return {};
  }
  return test->expectations.front();
}

inline std::string outcomeName(const CheckResult& result) {
  return name(result.outcome);
}

}  // namespace ssrkit
