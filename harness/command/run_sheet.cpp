#include "command/run_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <vector>

#include "command/run_rows.h"
#include "image/text_painter.h"
#include "report/contact_sheet.h"

namespace ssrkit {

namespace {

std::string thicknessText(const TraceParameters& parameters) {
  if (parameters.thickness_rel > 0.0) {
    return fmt::format("{:g} m + {:g} %", parameters.thickness_m, 100.0 * parameters.thickness_rel);
  }
  return fmt::format("{:g} m", parameters.thickness_m);
}

}  // namespace

Expected<void> writeSheet(const std::filesystem::path& file, const CellRun& cell, const std::string& scene,
                          const std::vector<RunRow>& rows) {
  // Its glyphs are made once, a tenth of a second, and it serves one sheet at a time.
  static std::mutex painter_mutex;
  static Expected<TextPainter> painter = TextPainter::load();
  if (!painter) {
    return tl::make_unexpected(painter.error());
  }
  std::vector<std::vector<Verdict>> verdicts;
  std::vector<TraceSummary> summaries;
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    verdicts.push_back(verdictsOf(cell, i));
    summaries.push_back(summarise(cell.result->traces[i].record, verdicts.back()));
  }
  ContactSheet sheet{.scene = scene,
                     .device = cell.device,
                     .thickness = thicknessText(cell.result->traces.front().parameters),
                     .lit = &cell.result->images.at("lit"),
                     .exposure = 1.0,
                     .stages = {}};
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceResult& trace = cell.result->traces[i];
    const auto composite = trace.images.find("composite");
    const std::string& technique = cell.case_of_trace[i];
    SheetStage stage{.stage = technique.empty() ? trace.stage : trace.stage + " " + technique,
                     .record = &trace.record,
                     .summary = &summaries[i],
                     .composite = composite == trace.images.end() ? nullptr : &composite->second,
                     .verdicts = verdicts[i],
                     .cpu_ms = std::nullopt};
    const auto row = std::ranges::find_if(rows, [&](const RunRow& candidate) {
      return candidate.device == cell.device && candidate.stage == trace.stage &&
             candidate.case_name == technique;
    });
    if (row != rows.end()) {
      if (const auto cost = traceCost(row->passes)) {
        stage.cpu_ms = cost->cpu_ms;
      }
    }
    sheet.stages.push_back(stage);
  }
  const std::lock_guard lock(painter_mutex);
  return writeContactSheet(file, sheet, *painter);
}

}  // namespace ssrkit
