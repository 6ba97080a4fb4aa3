#include "command/bench_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/text.h"

namespace ssrkit {

void addBench(CLI::App& app, BenchOptions& options, std::function<Expected<int>()>& command) {
  CLI::App* bench =
      app.add_subcommand("bench", "Time every pass in interleaved rounds, and judge what it costs");
  CLI::Option* const scene =
      bench->add_option("--scene", options.scenes, "A built-in scene or a glTF 2.0 file")
          ->capture_default_str();
  CLI::Option* const stage = bench->add_option(
      "--stage", options.stages, fmt::format("A tracer (default: {})", joinNames(options.stages)));
  bench
      ->add_option("--device", options.devices,
                   "A device of `ssrkit devices`; DEVICE@N holds a software rasteriser to N threads")
      ->capture_default_str();
  CLI::Option* const size =
      bench->add_option("--size", options.size, "WIDTHxHEIGHT in texels")->capture_default_str();
  CLI::Option* const parameter = bench->add_option(
      "--param", options.parameters, "NAME=VALUE of the tracing parameters, for example thickness_m=0.3");
  bench->add_option("--replace", options.replacements,
                    "PASS=FILE: put a shader of your own in a pass's place");
  bench
      ->add_option("--rounds", options.rounds,
                   "Timed rounds after a warm-up; 8 or more for intervals (default: 15)")
      ->check(CLI::Range(1, 1000));
  bench->add_option("--out", options.out, "The folder for bench.json, bench.csv and bench.html")
      ->capture_default_str();
  bench->add_option("--baseline", options.baseline, "An earlier bench.json: name what moved since");
  CLI::Option* const peer = bench->add_option(
      "--peer", options.peers, "A TOML file that describes somebody's shader: time it and judge it too");
  CLI::Option* const scaling = bench->add_option(
      "--scaling", options.axes, fmt::format("How the cost grows along an axis: {}", joinNames(benchAxes())));
  CLI::Option* const rooflines =
      bench->add_flag("--rooflines", options.rooflines, "Time the machine's own limits beside each trace")
          ->excludes(scaling);
  bench
      ->add_flag("--gates", options.gates,
                 "Judge the ratios of tests/gates instead, whose files say what is drawn")
      ->excludes(scene, stage, size, parameter, peer, scaling, rooflines);
  bench->add_flag("--json", options.json, "Print bench.json instead of the tables");
  bench->callback([&] { command = [&] { return benchCommand(options); }; });
}

}  // namespace ssrkit
