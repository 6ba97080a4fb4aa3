#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "base/size.h"
#include "command/bench_work.h"
#include "command/run_rows.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// How one axis varies a test, and where an answer stands on it.
struct Axis {
  std::string name;
  std::string x_unit;
  bool is_wall = false;      // threads save no CPU time
  bool over_scenes = false;  // the scenes are its points
  std::function<void(TestFile&, const BenchWork&)> vary;
  std::function<double(const RunRow&, const CellRun&)> x_of;
  std::function<std::string(const RunRow&)> label_of;
};

void varyParameter(TestFile& test, const std::string& parameter, const std::vector<std::string>& values) {
  const TestCase base = test.cases.front();
  test.cases.clear();
  for (const std::string& value : values) {
    TestCase varied = base;
    varied.name = value;
    std::erase_if(varied.parameters, [&](const auto& given) { return given.first == parameter; });
    varied.parameters.emplace_back(parameter, value);
    test.cases.push_back(std::move(varied));
  }
}

void varySize(TestFile& test, const BenchWork& work) {
  for (const double factor : {0.5, 0.7, 1.0, 1.4, 2.0}) {
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(factor * side))); };
    test.sizes.push_back({scaled(work.request.size.width), scaled(work.request.size.height)});
  }
}

void varyThreads(TestFile& test, const BenchWork& work) {
  const int most = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  for (const std::string& device : work.request.devices) {
    for (int threads = 1; threads <= most; threads *= 2) {
      test.devices.push_back(fmt::format("{}@{}", device, threads));
    }
  }
}

int threadsOf(const std::string& device) {
  return std::stoi(device.substr(device.find('@') + 1));
}

// How broken the depth image is: of 1000 pairs of neighbouring texels, those whose distances differ by more
// than a twentieth.
double depthEdges(const CellRun& cell) {
  constexpr double kEdge = 0.05;
  const Image& depths = cell.result->images.at("dist_view");
  std::size_t edges = 0;
  std::size_t pairs = 0;
  const auto look = [&](float a, float b) {
    ++pairs;
    const bool both = std::isfinite(a) && std::isfinite(b);
    edges +=
        (both ? std::abs(a - b) > kEdge * std::min(a, b) : std::isfinite(a) != std::isfinite(b)) ? 1U : 0U;
  };
  for (int y = 0; y < depths.size.height; ++y) {
    for (int x = 0; x < depths.size.width; ++x) {
      if (x + 1 < depths.size.width) {
        look(depths.at(x, y), depths.at(x + 1, y));
      }
      if (y + 1 < depths.size.height) {
        look(depths.at(x, y), depths.at(x, y + 1));
      }
    }
  }
  return 1000.0 * static_cast<double>(edges) / std::max(1.0, static_cast<double>(pairs));
}

const std::vector<Axis>& axes() {
  const auto of_case = [](const RunRow& row, const CellRun&) { return std::stod(row.case_name); };
  const auto metres = [](const RunRow& row) { return row.case_name + " m"; };
  static const std::vector<Axis> rows = {
      {.name = "resolution",
       .x_unit = "texels across",
       .vary = varySize,
       .x_of = [](const RunRow& row, const CellRun&) { return static_cast<double>(row.size.width); },
       .label_of = [](const RunRow& row) { return sizeText(row.size); }},
      {.name = "ray_length",
       .x_unit = "max_distance_m",
       .vary =
           [](TestFile& test, const BenchWork&) {
             varyParameter(test, "max_distance_m", {"0.5", "1", "2", "4", "8", "16", "32"});
           },
       .x_of = of_case,
       .label_of = metres},
      {.name = "thickness",
       .x_unit = "thickness_m",
       .vary =
           [](TestFile& test, const BenchWork&) {
             varyParameter(test, "thickness_m", {"0.01", "0.03", "0.1", "0.3", "1", "3", "10"});
           },
       .x_of = of_case,
       .label_of = metres},
      {.name = "threads",
       .x_unit = "threads",
       .is_wall = true,
       .vary = varyThreads,
       .x_of = [](const RunRow& row, const CellRun&) { return static_cast<double>(threadsOf(row.device)); },
       .label_of = [](const RunRow& row) { return fmt::format("{} threads", threadsOf(row.device)); }},
      {.name = "depth",
       .x_unit = "depth edges per 1000 pairs of texels",
       .over_scenes = true,
       .vary = [](TestFile&, const BenchWork&) {},
       .x_of = [](const RunRow&, const CellRun& cell) { return depthEdges(cell); },
       .label_of = [](const RunRow& row) { return row.scene; }}};
  return rows;
}

// The scaling that a row is a point of.
BenchScaling& scalingOf(std::vector<BenchScaling>& scalings, const Axis& axis, const RunRow& row) {
  const std::string scene = axis.over_scenes ? "all" : row.scene;
  const std::string device = axis.name == "threads" ? row.device.substr(0, row.device.find('@')) : row.device;
  const auto known = std::ranges::find_if(scalings, [&](const BenchScaling& scaling) {
    return scaling.scene == scene && scaling.device == device && scaling.stage == row.stage;
  });
  return known != scalings.end() ? *known
                                 : scalings.emplace_back(BenchScaling{.axis = axis.name,
                                                                      .x_unit = axis.x_unit,
                                                                      .clock = axis.is_wall ? "wall" : "CPU",
                                                                      .scene = scene,
                                                                      .device = device,
                                                                      .stage = row.stage});
}

void addPoints(const Axis& axis, const SceneRun& run, std::vector<BenchScaling>& scalings) {
  const std::vector<RunRow> rows = runRows(run);
  auto row = rows.begin();
  for (const CellRun& cell : run.cells) {
    for (std::size_t i = 0; cell.result && i < cell.result->traces.size(); ++i, ++row) {
      const auto trace = std::ranges::find(row->passes, "trace", &PassReport::pass);
      if (trace == row->passes.end() || !row->summary || row->summary->traced_rays == 0) {
        continue;
      }
      const auto rays = static_cast<double>(row->summary->traced_rays);
      const double ns = medianNs(trace->steady, axis.is_wall ? &PassTime::wall_ns : &PassTime::cpu_ns);
      scalingOf(scalings, axis, *row)
          .points.push_back(
              {axis.label_of(*row), axis.x_of(*row, cell), ns / rays, row->summary->lookups.mean});
    }
  }
}

std::optional<PowerLaw> lawOf(const BenchScaling& scaling, double BenchScalingPoint::*value) {
  std::vector<PowerLawPoint> points;
  for (const BenchScalingPoint& point : scaling.points) {
    points.push_back({point.x, point.*value});
  }
  return fitPowerLaw(points);
}

Expected<std::vector<SceneSource>> scenesOf(const Axis& axis, const BenchWork& work) {
  if (!axis.over_scenes) {
    return work.request.scenes;
  }
  std::vector<SceneSource> scenes;
  for (const std::string& scene : builtInScenes(work.paths.scenes)) {
    auto source = Suite::source(scene, work.paths.scenes);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    scenes.push_back(std::move(*source));
  }
  return scenes;
}

}  // namespace

std::vector<std::string> benchAxes() {
  std::vector<std::string> names;
  std::ranges::transform(axes(), std::back_inserter(names), &Axis::name);
  return names;
}

Expected<std::vector<BenchScaling>> measureScaling(const BenchWork& work, const std::string& axis_name,
                                                   std::vector<CheckResult>& failures) {
  const Axis& axis = *std::ranges::find(axes(), axis_name, &Axis::name);
  TestFile test = work.request.test;
  axis.vary(test, work);
  const auto suite =
      benchSuite(work, test.devices.empty() ? work.request.devices : test.devices, kBenchParts);
  const auto scenes = suite ? scenesOf(axis, work) : tl::make_unexpected(suite.error());
  if (!scenes) {
    return tl::make_unexpected(scenes.error());
  }
  std::vector<BenchScaling> scalings;
  for (const SceneSource& scene : *scenes) {
    const SceneRun run = (*suite)->run(test, scene);
    const auto failed =
        std::ranges::find_if(run.cells, [](const CellRun& cell) { return cell.error.has_value(); });
    if (failed != run.cells.end()) {
      return tl::make_unexpected(*failed->error);
    }
    failures.insert(failures.end(), run.checks.begin(), run.checks.end());
    addPoints(axis, run, scalings);
  }
  for (BenchScaling& scaling : scalings) {
    std::ranges::sort(scaling.points, {}, &BenchScalingPoint::x);
    scaling.time = lawOf(scaling, &BenchScalingPoint::ns_per_ray);
    scaling.lookups = lawOf(scaling, &BenchScalingPoint::lookups_per_ray);
  }
  return scalings;
}

}  // namespace ssrkit
