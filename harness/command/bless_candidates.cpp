#include "command/bless_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/hash128.h"
#include "base/size.h"
#include "check/judge.h"
#include "command/golden_shelf.h"
#include "frame/stages.h"

namespace ssrkit {

namespace {

constexpr Size kLargest = {160, 90};

// Of every file that belongs to the scene: its folder holds nothing else.
Expected<std::string> sceneHash(const std::filesystem::path& scene_file) {
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(scene_file.parent_path(), failure)) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::string all;
  for (const std::filesystem::path& file : files) {
    const auto content = readFile(file);
    if (!content) {
      return tl::make_unexpected(content.error());
    }
    all += file.filename().string() + '\n' + *content;
  }
  return hashName(all);
}

// Of the SPIR-V of the passes that the kit compiles from files of their own name, and of the tracer.
Expected<std::string> spirvHash(const CellRun& cell, const Answer& answer,
                                const std::filesystem::path& shaders) {
  const auto device = findDevice(cell.device);
  if (!device) {
    return tl::make_unexpected(device.error());
  }
  std::vector<std::string> entries;
  const auto add = [&](const std::vector<PassReport>& passes) {
    for (const PassReport& pass : passes) {
      entries.push_back(pass.pass + ".frag");
    }
  };
  add(cell.result->frame_passes);
  for (const TraceResult& trace : cell.result->traces) {
    if (trace.stage == answer.stage) {
      add(trace.passes);
      const auto stage = findStage(trace.stage);
      entries.push_back(stage ? shaderOf(**stage, trace.parameters) : "");
    }
  }
  std::ranges::sort(entries);
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  std::string all;
  for (const std::string& entry : entries) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(shaders / entry, ignored)) {
      continue;
    }
    const auto module = compileShader(
        {.root = shaders, .entry = entry, .stage = ShaderStage::kFragment, .defines = {}}, (*device)->target);
    if (!module) {
      return tl::make_unexpected(module.error());
    }
    all += entry + '\n';
    all.append(reinterpret_cast<const char*>(module->spirv.data()),
               module->spirv.size() * sizeof(std::uint32_t));
  }
  return hashName(all);
}

std::string parametersHash(const Answer& answer) {
  std::string all;
  for (const std::string& parameter : parameterNames()) {
    all += fmt::format("{}={}\n", parameter, parameterText(answer.parameters, parameter));
  }
  return hashName(all);
}

// What the run's checks measured of this answer.
std::map<std::string, std::string> metricsOf(const SceneRun& run, const Answer& answer) {
  std::map<std::string, std::string> metrics;
  for (const CheckResult& check : run.checks) {
    const bool concerns = check.device == answer.device && check.size == answer.size &&
                          check.stage == answer.stage && check.case_name == answer.case_name;
    if (concerns && check.value && check.outcome == Outcome::kPass) {
      metrics[check.id] = fmt::format("{:.6g} {}", *check.value, check.unit);
    }
  }
  return metrics;
}

const CellRun* cellOf(const SceneRun& run, const Answer& answer) {
  const auto found = std::ranges::find_if(run.cells, [&](const CellRun& cell) {
    return cell.device == answer.device && cell.size == answer.size && cell.input == answer.input &&
           cell.result;
  });
  return found == run.cells.end() ? nullptr : &*found;
}

Expected<Golden> candidate(const TestFile& test, const SceneRun& run, const Expectation& expectation,
                           const Answer& answer, const GoldenKey& key, const Blessing& blessing,
                           const KitPaths& paths) {
  const std::string attempted = fmt::format("bless '{}' of {}", expectation.buffer, run.source->name);
  const auto image = answer.images.find(expectation.buffer);
  const bool is_record = expectation.buffer == "hit" && answer.record != nullptr;
  const CellRun* const cell = cellOf(run, answer);
  if ((!is_record && image == answer.images.end()) || cell == nullptr) {
    return inputError(attempted, fmt::format("{} left no such buffer", answer.device), expectation.where);
  }
  if (answer.size.width > kLargest.width || answer.size.height > kLargest.height) {
    return inputError(attempted,
                      fmt::format("{} is larger than {}", sizeText(answer.size), sizeText(kLargest)),
                      expectation.where, "goldens are small: give the test smaller sizes");
  }
  const auto scene = sceneHash(run.source->file);
  const auto spirv = scene ? spirvHash(*cell, answer, paths.shaders) : tl::make_unexpected(scene.error());
  if (!spirv) {
    return tl::make_unexpected(spirv.error());
  }
  return Golden{
      .note = {.subject = goldenSubjectOf(test.id, run.source->name, expectation, answer),
               .key = key,
               .who = blessing.who,
               .when = blessing.when,
               .why = blessing.why,
               .hashes = {{"scene", *scene}, {"spirv", *spirv}, {"parameters", parametersHash(answer)}},
               .metrics = metricsOf(run, answer)},
      .image = is_record ? toImage(*answer.record) : *image->second};
}

std::string texelText(const Image& image, std::size_t texel) {
  std::string text;
  for (std::size_t channel = 0; channel < image.channelCount(); ++channel) {
    text +=
        fmt::format("{}{:.7g}", channel == 0 ? "" : " ", image.data[texel * image.channelCount() + channel]);
  }
  return text;
}

std::string differenceText(const Image& now, const Image& before) {
  if (now.channels != before.channels || now.size != before.size) {
    return "its size or channels change";
  }
  std::size_t changed = 0;
  double worst = -1.0;
  std::size_t worst_texel = 0;
  for (std::size_t texel = 0; texel < now.texelCount(); ++texel) {
    double difference = -1.0;
    for (std::size_t i = texel * now.channelCount(); i < (texel + 1) * now.channelCount(); ++i) {
      const bool is_same =
          std::bit_cast<std::uint32_t>(now.data[i]) == std::bit_cast<std::uint32_t>(before.data[i]);
      const double by = std::abs(static_cast<double>(now.data[i]) - before.data[i]);
      difference = is_same ? difference : std::max(difference, std::isfinite(by) ? by : HUGE_VAL);
    }
    changed += difference >= 0.0 ? 1 : 0;
    if (difference > worst) {
      worst = difference;
      worst_texel = texel;
    }
  }
  if (changed == 0) {
    return "the same as before";
  }
  const auto width = static_cast<std::size_t>(now.size.width);
  return fmt::format("{} of {} texels change, by at most {:.6g}, at ({}, {}): {}, was {}", changed,
                     now.texelCount(), worst, worst_texel % width, worst_texel / width,
                     texelText(now, worst_texel), texelText(before, worst_texel));
}

}  // namespace

Expected<std::vector<Golden>> blessCandidates(const TestFile& test, const SceneRun& run,
                                              const std::map<std::string, DeviceInfo>& devices,
                                              const Blessing& blessing, const KitPaths& paths) {
  std::vector<Golden> candidates;
  for (const Expectation& expectation : test.expectations) {
    for (const Answer& answer : run.answers) {
      if (expectation.truth.kind != TruthKind::kGolden || !isAskedOf(test, expectation, answer)) {
        continue;
      }
      const GoldenKey key = goldenKeyOf(devices.at(answer.device).identity);
      auto golden = candidate(test, run, expectation, answer, key, blessing, paths);
      if (!golden) {
        return tl::make_unexpected(golden.error());
      }
      const bool is_known = std::ranges::any_of(candidates, [&](const Golden& other) {
        return other.note.subject == golden->note.subject && other.note.key == golden->note.key;
      });
      if (!is_known) {
        candidates.push_back(std::move(*golden));
      }
    }
  }
  return candidates;
}

std::string changeText(const Golden& golden, std::span<const Golden> before) {
  const GoldenSubject& subject = golden.note.subject;
  std::string text = fmt::format("{} {}", subject.scene, sizeText(subject.size));
  for (const std::string* part : {&subject.stage, &subject.case_name, &subject.buffer}) {
    text += part->empty() ? "" : " " + *part;
  }
  text += fmt::format(" ({}): ", keyText(golden.note.key));
  const auto known = std::ranges::find_if(before, [&](const Golden& other) {
    return other.note.subject == subject && other.note.key == golden.note.key;
  });
  text += known == before.end() ? "new" : differenceText(golden.image, known->image);
  for (const auto& [check, value] : golden.note.metrics) {
    const bool was_known = known != before.end() && known->note.metrics.contains(check);
    text +=
        fmt::format("\n  {} = {}{}", check, value, was_known ? ", was " + known->note.metrics.at(check) : "");
  }
  return text;
}

}  // namespace ssrkit
