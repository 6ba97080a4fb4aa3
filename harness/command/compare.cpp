#include "command/compare.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "base/atomic_file.h"
#include "base/text.h"
#include "check/read_claims.h"
#include "command/kit_paths.h"
#include "command/known_names.h"
#include "command/progress_line.h"
#include "command/run_rows.h"
#include "command/suite.h"
#include "report/claims_report.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// The named claims in the order of the command line, or all of them.
Expected<std::vector<Claim>> chosenClaims(const CompareOptions& options, const KitPaths& paths) {
  auto claims = loadClaims(paths.claims, knownNames(paths));
  if (!claims || options.claims.empty()) {
    return claims;
  }
  std::vector<std::string> names;
  std::ranges::transform(*claims, std::back_inserter(names), &Claim::name);
  std::vector<Claim> chosen;
  for (const std::string& wanted : options.claims) {
    const auto found = std::ranges::find(*claims, wanted, &Claim::name);
    if (found == claims->end()) {
      const auto nearest = nearestName(wanted, names);
      return inputError("compare", fmt::format("there is no claim '{}'", wanted), "--claim",
                        nearest ? fmt::format("did you mean '{}'?", *nearest)
                                : fmt::format("the claims are {}", joinNames(names)));
    }
    if (std::ranges::find(chosen, wanted, &Claim::name) == chosen.end()) {
      chosen.push_back(*found);
    }
  }
  return chosen;
}

Expected<std::unique_ptr<Suite>> makeSuite(const CompareOptions& options, const KitPaths& paths,
                                           ProgressLine& progress) {
  return Suite::create({.shader_root = paths.shaders,
                        .scenes_root = paths.scenes,
                        .devices = options.devices,
                        .size = {640, 360},
                        .mirror_material = "",
                        .replacements = {},
                        .limits = {},
                        .always_oracle = false,
                        .command = "",
                        .progress = [&](const std::string& text) { progress.show(text); }});
}

std::string againText(const Claim& claim, const CompareOptions& options) {
  std::string text = "./ssrkit compare --claim " + claim.name;
  if (options.devices != CompareOptions{}.devices) {
    for (const std::string& device : options.devices) {
      text += " --device " + device;
    }
  }
  return text;
}

Expected<ClaimReport> measureClaim(Suite& suite, const Claim& claim, const CompareOptions& options,
                                   const KitPaths& paths) {
  ClaimReport report{
      .claim = claim, .result = {}, .frames = {}, .rows = {}, .again = againText(claim, options)};
  const bool all = claim.test.scenes == std::vector<std::string>{"all"};
  std::vector<CheckResult> checks;
  for (const std::string& scene : all ? builtInScenes(paths.scenes) : claim.test.scenes) {
    const auto source = Suite::source(scene, paths.scenes);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    const SceneRun run = suite.run(claim.test, *source);
    checks.insert(checks.end(), run.checks.begin(), run.checks.end());
    if (claim.test.rounds > 0) {
      const std::vector<RunRow> rows = runRows(run);
      report.rows.insert(report.rows.end(), rows.begin(), rows.end());
      for (const CellRun& cell : run.cells) {
        if (cell.result) {
          report.frames.push_back({source->name, cell.device, cell.size, cell.result->frame_passes});
        }
      }
    }
  }
  report.result = judgeClaim(claim, checks);
  return report;
}

// One outcome a claim: that it was measured is what passes.
std::vector<Outcome> outcomesOf(const ClaimsReport& report) {
  std::vector<Outcome> outcomes;
  for (const ClaimReport& claim : report.claims) {
    const ClaimVerdict verdict = claim.result.verdict;
    outcomes.push_back(verdict == ClaimVerdict::kNotMeasured    ? Outcome::kError
                       : verdict == ClaimVerdict::kInconclusive ? Outcome::kInconclusive
                                                                : Outcome::kPass);
  }
  return outcomes;
}

Expected<void> measureAll(Suite& suite, const std::vector<Claim>& claims, const CompareOptions& options,
                          ProgressLine& progress, ClaimsReport& report) {
  const auto infos = suite.devices();
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  for (const auto& [id, info] : *infos) {
    report.devices.push_back({info.identity, info.traits});
  }
  const TableStyle style{.colour = wantsColour(STDOUT_FILENO), .width = 100};
  for (const Claim& claim : claims) {
    auto measured = measureClaim(suite, claim, options, kitPaths());
    progress.clear();
    if (!measured) {
      return tl::make_unexpected(measured.error());
    }
    if (!options.json) {
      fmt::print("{}\n", claimText(*measured, style));
      std::fflush(stdout);
    }
    report.claims.push_back(std::move(*measured));
  }
  return {};
}

void printList(const std::vector<Claim>& claims) {
  for (const Claim& claim : claims) {
    fmt::print("{:<24}{} ({})\n", claim.name, claim.says, claim.source);
  }
}

}  // namespace

Expected<int> compareCommand(const CompareOptions& options) {
  const KitPaths paths = kitPaths();
  const auto claims = chosenClaims(options, paths);
  if (!claims) {
    return tl::make_unexpected(claims.error());
  }
  if (options.list) {
    printList(*claims);
    return 0;
  }
  ProgressLine progress;
  auto suite = makeSuite(options, paths, progress);
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  ClaimsReport report{.kit_version = SSRKIT_VERSION,
                      .started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now)),
                      .command = options.command,
                      .devices = {},
                      .claims = {}};
  auto done =
      suite ? measureAll(**suite, *claims, options, progress, report) : tl::make_unexpected(suite.error());
  const std::string json = claimsJson(report);
  done = done ? writeFileAtomically(options.out / "claims.json", json) : done;
  done = done ? writeFileAtomically(options.out / "report.html", claimsHtml(report)) : done;
  if (!done) {
    return tl::make_unexpected(done.error());
  }
  std::vector<Outcome> outcomes = outcomesOf(report);
  const int code = exitCode(outcomes);
  if (options.json) {
    fmt::print("{}", json);
    return code;
  }
  std::erase(outcomes, Outcome::kInconclusive);  // among the verdicts; the closing line is read by programs
  fmt::print("{}\nwritten to {}\n{}\n", verdictCounts(report), options.out.string(), closingLine(outcomes));
  return code;
}

}  // namespace ssrkit
