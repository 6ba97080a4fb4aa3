#include "report/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/check.h"
#include "image/png.h"
#include "report/canvas.h"
#include "report/heat_scale.h"
#include "report/sheet_layout.h"
#include "report/sheet_pictures.h"
#include "report/table_text.h"
#include "report/verdict_colours.h"

namespace ssrkit {

namespace {

constexpr Rgb8 kPaper = {255, 255, 255};
constexpr Rgb8 kInk = {25, 25, 30};
constexpr Rgb8 kPaleInk = {95, 95, 105};
constexpr TextStyle kTitle{.height_px = 26, .colour = kInk, .weight = TextWeight::kBold};
constexpr TextStyle kHeading{.height_px = 18, .colour = kInk, .weight = TextWeight::kBold};
constexpr TextStyle kPlain{.height_px = 15, .colour = kInk};
constexpr TextStyle kPale{.height_px = 13, .colour = kPaleInk};
constexpr int kSwatch = 13;

HeatScale heatOf(const ContactSheet& sheet) {
  std::vector<const RayRecord*> records;
  for (const SheetStage& stage : sheet.stages) {
    records.push_back(stage.record);
  }
  return HeatScale(records);
}

// Draws one sheet. Kept together because every part needs the canvas, the painter and the layout.
class SheetDrawing {
 public:
  SheetDrawing(const ContactSheet& sheet, TextPainter& painter)
      : sheet_(sheet),
        painter_(painter),
        scale_(cellScaleFor(sheet.lit->size)),
        heat_(heatOf(sheet)),
        layout_{scale_.cell(), static_cast<int>(sheet.stages.size())},
        canvas_(layout_.sheet(), 3) {
    std::ranges::fill(canvas_.data, kPaper[0]);
  }

  ByteImage draw() {
    const ByteImage lit = lightPicture(*sheet_.lit, scale_, sheet_.exposure);
    backdrop_ = dimmed(lit);
    drawTitle();
    caption(0, 0, "lit", "before reflections are added");
    picture(0, 0, lit);
    drawVerdictLegend();
    drawHeatLegend();
    for (std::size_t i = 0; i < sheet_.stages.size(); ++i) {
      drawStage(static_cast<int>(i) + 1, sheet_.stages[i]);
    }
    return std::move(canvas_);
  }

 private:
  void text(int x, int y, std::string_view words, const TextStyle& style) {
    painter_.draw(canvas_, x, y, words, style);
  }

  // The heading's width is limited to the column's.
  void caption(int column, int row, std::string_view heading, std::string_view detail) {
    const int x = layout_.columnX(column);
    const int y = layout_.pictureY(row);
    std::size_t characters = columnsOf(heading);
    while (characters > 4 &&
           painter_.widthOf(cellText(heading, characters), kHeading) > layout_.columnWidth()) {
      --characters;
    }
    text(x, y - 27, cellText(heading, characters), kHeading);
    text(x, y - 8, detail, kPlain);
  }

  void picture(int column, int row, const ByteImage& image) {
    paste(canvas_, layout_.columnX(column), layout_.pictureY(row), image, scale_.grow);
  }

  // A sheet of one stage is narrow: the title is then smaller.
  void drawTitle() {
    const int y = SheetLayout::kMargin + 26;
    const std::string words =
        fmt::format("{}   {} x {}   {}   thickness {}", cellText(sheet_.scene, 48), sheet_.lit->size.width,
                    sheet_.lit->size.height, sheet_.device, sheet_.thickness);
    const int room = canvas_.size.width - 2 * SheetLayout::kMargin;
    TextStyle style = kTitle;
    while (style.height_px > kPale.height_px && painter_.widthOf(words, style) > room) {
      --style.height_px;
    }
    text(SheetLayout::kMargin, y, words, style);
    fillRect(canvas_, {SheetLayout::kMargin, y + 12, {room, 2}}, kInk);
  }

  void swatch(int x, int baseline_y, Rgb8 colour) {
    fillRect(canvas_, {x, baseline_y - kSwatch + 2, {kSwatch, kSwatch}}, colour);
  }

  void drawVerdictLegend() {
    caption(0, 1, "verdicts",
            scale_.shrink == 1 ? std::string("each ray against Oracle A")
                               : fmt::format("against Oracle A, worst of {0} x {0} px", scale_.shrink));
    constexpr int kLine = 23;
    int y = layout_.pictureY(1) + kSwatch;
    for (const Verdict verdict : kWorstFirst) {
      if (verdict == Verdict::kNone) {
        continue;
      }
      const int x = layout_.columnX(0);
      swatch(x, y, colourOf(verdict));
      text(x + kSwatch + 8, y, shortName(verdict), kPlain);
      text(x + kSwatch + 84, y, meaningOf(verdict), kPale);
      y += kLine;
    }
    text(layout_.columnX(0), y, "grey: not reflective, or background", kPale);
  }

  static std::string_view shortName(Verdict verdict) {
    static constexpr std::array<std::string_view, kVerdictCount> kShort = {"none",  "SAME",   "NEAR", "WRONG",
                                                                           "FALSE", "MISSED", "LEAK", "TIE"};
    return kShort.at(static_cast<std::size_t>(verdict));
  }

  void drawHeatLegend() {
    caption(0, 2, "depth lookups a ray", "one logarithmic scale for all stages");
    const int x = layout_.columnX(0);
    const int y = layout_.pictureY(2) + 6;
    const int width = layout_.columnWidth() - 30;
    constexpr int kBarHeight = 26;
    for (int i = 0; i < width; ++i) {
      const double place = static_cast<double>(i) / (width - 1);
      fillRect(canvas_, {x + i, y, {1, kBarHeight}}, sequentialColourAt(place));
    }
    int free_x = x - 1;
    for (const double tick : heat_.ticks()) {
      const int tick_x = x + static_cast<int>(heat_.placeOf(tick) * (width - 1));
      const std::string label = fmt::format("{:.0f}", tick);
      const int label_x = std::max(x, tick_x - painter_.widthOf(label, kPlain) / 2);
      fillRect(canvas_, {tick_x, y + kBarHeight, {1, 6}}, kInk);
      if (label_x > free_x) {
        text(label_x, y + kBarHeight + 21, label, kPlain);
        free_x = label_x + painter_.widthOf(label, kPlain) + 6;
      }
    }
  }

  Rgb8 sequentialColourAt(double place) const {
    return heat_.colourOf(heat_.low() * std::pow(heat_.high() / heat_.low(), place));
  }

  void drawStage(int column, const SheetStage& stage) {
    SSRKIT_CHECK(stage.record->size == sheet_.lit->size);
    const TraceSummary& summary = *stage.summary;
    const std::string cost = stage.cpu_ms ? measureText(*stage.cpu_ms) + " ms CPU" : "";
    caption(column, 0, stage.stage, cost.empty() ? "CPU time not measured" : cost);
    if (stage.composite != nullptr) {
      SSRKIT_CHECK(stage.composite->size == sheet_.lit->size);
      picture(column, 0, lightPicture(*stage.composite, scale_, sheet_.exposure));
    } else {
      placeholder(column, 0, "no composite was made");
    }
    drawVerdicts(column, stage, summary);
    caption(column, 2, fmt::format("{} lookups a ray", measureText(summary.lookups.mean)),
            fmt::format("median {:.0f}, p95 {:.0f}, most {:.0f}", summary.lookups.p50, summary.lookups.p95,
                        summary.lookups.max));
    picture(column, 2, heatPicture(*stage.record, scale_, heat_, backdrop_));
  }

  void placeholder(int column, int row, std::string_view words) {
    picture(column, row, backdrop_);
    text(layout_.columnX(column) + 8, layout_.pictureY(row) + 22, words, {.height_px = 15, .colour = kPaper});
  }

  void drawVerdicts(int column, const SheetStage& stage, const TraceSummary& summary) {
    if (!summary.verdicts) {
      caption(column, 1, "no oracle", "");
      placeholder(column, 1, "there is nothing to compare with");
      return;
    }
    const VerdictCounts& counts = *summary.verdicts;
    const auto same = sameFraction(counts);
    const std::size_t compared = stage.verdicts.size() - counts.at(static_cast<std::size_t>(Verdict::kNone));
    caption(column, 1, same ? fmt::format("SAME {} %", percentText(*same, 2)) : "no rays",
            fmt::format("of {} rays", compared));
    picture(column, 1, verdictPicture(stage.verdicts, stage.record->size, scale_, backdrop_));
    drawCounts(column, counts);
  }

  // Three lines of two below the map.
  void drawCounts(int column, const VerdictCounts& counts) {
    constexpr std::array<Verdict, 6> kCounted = {Verdict::kNear,      Verdict::kWrong, Verdict::kFalseHit,
                                                 Verdict::kMissedHit, Verdict::kLeak,  Verdict::kAmbiguous};
    const int half = layout_.columnWidth() / 2;
    for (std::size_t i = 0; i < kCounted.size(); ++i) {
      const Verdict verdict = kCounted[i];
      const int x = layout_.columnX(column) + static_cast<int>(i / 3) * half;
      const int y = layout_.pictureY(1) + scale_.cell().height + 19 + static_cast<int>(i % 3) * 20;
      const std::size_t count = counts.at(static_cast<std::size_t>(verdict));
      swatch(x, y, colourOf(verdict));
      text(x + kSwatch + 5, y, fmt::format("{} {}", shortName(verdict), countText(count)),
           {.height_px = 14, .colour = count == 0 ? Rgb8{150, 150, 155} : kInk});
    }
  }

  const ContactSheet& sheet_;
  TextPainter& painter_;
  CellScale scale_;
  HeatScale heat_;
  SheetLayout layout_;
  ByteImage canvas_;
  ByteImage backdrop_;
};

}  // namespace

ByteImage drawContactSheet(const ContactSheet& sheet, TextPainter& painter) {
  return SheetDrawing(sheet, painter).draw();
}

Expected<void> writeContactSheet(const std::filesystem::path& path, const ContactSheet& sheet,
                                 TextPainter& painter) {
  return writePng(path, drawContactSheet(sheet, painter));
}

}  // namespace ssrkit
