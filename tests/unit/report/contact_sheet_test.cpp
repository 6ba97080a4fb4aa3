#include "report/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../temporary_folder.h"
#include "base/atomic_file.h"
#include "image/png.h"
#include "report/run_report.h"
#include "report/verdict_colours.h"
#include "synthetic_run.h"

namespace ssrkit {
namespace {

using testing::SyntheticRun;
using testing::syntheticRun;

// Owns what a sheet points at.
struct SheetData {
  std::vector<SyntheticRun> runs;
  std::vector<TraceSummary> summaries;
  ContactSheet sheet;
};

SheetData dataOf(Size size, int stage_count) {
  SheetData data;
  for (int i = 0; i < stage_count; ++i) {
    data.runs.push_back(syntheticRun(size, i, 20.0 * (i + 1)));
    data.summaries.push_back(summarise(data.runs.back().record, data.runs.back().verdicts));
  }
  data.sheet.scene = "clutter";
  data.sheet.device = "gl-osmesa";
  data.sheet.thickness = "inf";
  data.sheet.lit = &data.runs.front().lit;
  for (std::size_t i = 0; i < data.runs.size(); ++i) {
    data.sheet.stages.push_back({.stage = "stage " + std::to_string(i),
                                 .record = &data.runs[i].record,
                                 .summary = &data.summaries[i],
                                 .composite = &data.runs[i].composite,
                                 .verdicts = data.runs[i].verdicts,
                                 .cpu_ms = 1.5});
  }
  return data;
}

std::size_t dotsOf(const ByteImage& picture, Rgb8 colour) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.data.size(); i += 3) {
    count += std::equal(colour.begin(), colour.end(), picture.data.begin() + static_cast<std::ptrdiff_t>(i))
                 ? 1
                 : 0;
  }
  return count;
}

TextPainter painterForTests() {
  Expected<TextPainter> painter = TextPainter::load();
  if (!painter) {
    throw std::runtime_error(sentence(painter.error()));
  }
  return std::move(*painter);
}

TEST(ContactSheet, HasAColumnForEachStageBesideTheLitImage) {
  TextPainter painter = painterForTests();
  const int one = drawContactSheet(dataOf({320, 180}, 1).sheet, painter).size.width;
  const int two = drawContactSheet(dataOf({320, 180}, 2).sheet, painter).size.width;
  const int six = drawContactSheet(dataOf({320, 180}, 6).sheet, painter).size.width;
  EXPECT_EQ(two - one, 340);
  EXPECT_EQ(six - one, 5 * 340);
}

// Without errors only the legend and the two counts' swatches have an error's colour; with them the map adds
// more.
TEST(ContactSheet, ShowsErrorColoursOnlyWhereThereAreErrors) {
  TextPainter painter = painterForTests();
  SheetData data = dataOf({320, 180}, 2);
  const std::size_t with_errors = dotsOf(drawContactSheet(data.sheet, painter), colourOf(Verdict::kLeak));
  data.sheet.stages[1].verdicts = data.runs[0].verdicts;
  const std::size_t without = dotsOf(drawContactSheet(data.sheet, painter), colourOf(Verdict::kLeak));
  EXPECT_EQ(without, 3U * 13U * 13U);
  EXPECT_EQ(with_errors - without,
            static_cast<std::size_t>(std::ranges::count(data.runs[1].verdicts, Verdict::kLeak)));
}

TEST(ContactSheet, TheTitleEndsBeforeTheMarginOfANarrowSheetToo) {
  TextPainter painter = painterForTests();
  SheetData data = dataOf({320, 180}, 1);
  data.sheet.scene = "a scene of a longer name";
  data.sheet.thickness = "0.5 m + 5 %";
  const ByteImage picture = drawContactSheet(data.sheet, painter);
  constexpr int kMargin = 24;
  constexpr int kTitleRows = 60;
  for (int y = 0; y < kTitleRows; ++y) {
    for (int x = picture.size.width - kMargin; x < picture.size.width; ++x) {
      ASSERT_EQ(picture.data[picture.index(x, y)], 255) << x << " " << y;
    }
  }
}

TEST(ContactSheet, TakesEverySizeAndWhatIsNotThere) {
  TextPainter painter = painterForTests();
  for (const Size size : {Size{1, 1}, Size{3, 200}, Size{1000, 7}, Size{641, 359}}) {
    SheetData data = dataOf(size, 2);
    data.sheet.scene = std::string(300, 'w') + "\n\xff";
    data.sheet.stages[0].composite = nullptr;
    data.sheet.stages[0].cpu_ms.reset();
    data.sheet.stages[1].verdicts = {};
    data.summaries[1].verdicts.reset();
    const ByteImage picture = drawContactSheet(data.sheet, painter);
    EXPECT_GT(picture.size.width, 900);
    EXPECT_LT(picture.size.height, 1600);
  }
}

TEST(ContactSheet, IsWrittenAsPng) {
  TextPainter painter = painterForTests();
  const test::TemporaryFolder folder;
  const SheetData data = dataOf({64, 48}, 4);
  ASSERT_TRUE(writeContactSheet(folder / "sheet.png", data.sheet, painter));
  ASSERT_TRUE(writePng(folder / "drawn.png", drawContactSheet(data.sheet, painter)));
  const std::string written = readFile(folder / "sheet.png").value();
  EXPECT_TRUE(written.starts_with("\x89PNG"));
  EXPECT_EQ(written, readFile(folder / "drawn.png").value());
}

}  // namespace
}  // namespace ssrkit
