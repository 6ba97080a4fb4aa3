// One picture for each scene and device: what every stage made, where it is wrong, and what it cost.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/verdict.h"
#include "image/byte_image.h"
#include "image/image.h"
#include "image/ray_record.h"
#include "image/text_painter.h"
#include "report/run_report.h"

namespace ssrkit {

// Nothing is owned. Images, record and verdicts have the lit image's size (checked).
struct SheetStage {
  std::string stage;
  const RayRecord* record = nullptr;      // always there
  const TraceSummary* summary = nullptr;  // of the record and verdicts; always there
  const Image* composite = nullptr;       // linear light; null: no such picture was made
  std::span<const Verdict> verdicts;      // empty: there was no oracle
  std::optional<double> cpu_ms;           // of the trace, see traceCost
};

struct ContactSheet {
  std::string scene;
  std::string device;
  std::string thickness;       // "inf", "0.3 m"
  const Image* lit = nullptr;  // linear light; always there
  double exposure = 1.0;
  std::vector<SheetStage> stages;
};

// A column for each stage beside the lit image and the legends; rows: composite, verdicts, lookups.
[[nodiscard]] ByteImage drawContactSheet(const ContactSheet& sheet, TextPainter& painter);

[[nodiscard]] Expected<void> writeContactSheet(const std::filesystem::path& path, const ContactSheet& sheet,
                                               TextPainter& painter);

}  // namespace ssrkit
