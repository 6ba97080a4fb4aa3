#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "../temporary_folder.h"
#include "base/atomic_file.h"
#include "hand_made_exr.h"
#include "image/exr.h"

namespace ssrkit {
namespace {

using test::TemporaryFolder;
using testing::HandMadeExr;
using testing::PixelType;

HandMadeExr twoByOne() {
  HandMadeExr exr{.width = 2, .height = 1, .channels = {}};
  exr.channels = {{"B", PixelType::kFloat, {0, 0}}, {"G", PixelType::kFloat, {0, 0}}};
  return exr;
}

// The whole sentence about a file with these bytes, empty when it was read.
std::string complaintAbout(const std::string& bytes, const ExrExpectation& expected = {}) {
  const TemporaryFolder folder;
  EXPECT_TRUE(writeFileAtomically(folder / "f.exr", bytes));
  const Expected<Image> image = readExr(folder / "f.exr", expected);
  if (image) {
    return {};
  }
  EXPECT_EQ(exitCode(image.error()), 2);
  EXPECT_NE(sentence(image.error()).find("f.exr"), std::string::npos);
  return sentence(image.error());
}

void expectMentions(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in '" << text << "'";
}

TEST(ReadExr, TakesTheUntouchedFileOfTheseTests) {
  EXPECT_EQ(complaintAbout(twoByOne().bytes()), "");
}

TEST(ReadExr, NamesTheMissingChannelAndTheOnesThatAreThere) {
  const std::string text = complaintAbout(twoByOne().bytes(), {.channels = {"B", "R"}, .size = {}});
  expectMentions(text, "the channel 'R' is missing; it holds B and G; write the channels B and R");
}

TEST(ReadExr, NamesBothSizesWhenTheyDiffer) {
  const std::string text = complaintAbout(twoByOne().bytes(), {.channels = {}, .size = Size{640, 360}});
  expectMentions(text, "it is 2 x 1 texels, and 640 x 360 are expected");
}

TEST(ReadExr, RefusesIntegerAndSubsampledChannels) {
  HandMadeExr exr = twoByOne();
  exr.channels[0].type = PixelType::kUint;
  expectMentions(complaintAbout(exr.bytes()), "the channel 'B' holds integers");
  exr = twoByOne();
  exr.channels[1].sampling = 2;
  expectMentions(complaintAbout(exr.bytes()), "fewer samples than the image has texels");
}

TEST(ReadExr, RefusesACrop) {
  HandMadeExr exr = twoByOne();
  exr.display_width = 4;
  expectMentions(complaintAbout(exr.bytes()), "its data window is not the whole image");
}

TEST(ReadExr, RefusesDeepAndMultiPartFiles) {
  HandMadeExr exr = twoByOne();
  exr.version = 2 | 0x800;
  expectMentions(complaintAbout(exr.bytes()), "deep data");
  exr.version = 2 | 0x1000;
  expectMentions(complaintAbout(exr.bytes()), "several parts");
}

// These would be gigabytes if the header were believed.
TEST(ReadExr, RefusesHugeAndNegativeSizesBeforeAllocating) {
  HandMadeExr exr = twoByOne();
  exr.channels = {{"Y", PixelType::kFloat, {}}};
  for (const std::int32_t side : {16385, 2147483647, 0, -5}) {
    exr.height = 0;  // no rows are made
    exr.width = side;
    std::string bytes = exr.bytes();
    expectMentions(complaintAbout(bytes), "it claims");
  }
}

TEST(ReadExr, RefusesWhatIsNoExr) {
  expectMentions(complaintAbout(""), "it is not an EXR file");
  expectMentions(complaintAbout("P6 1 1 255 abc and more"), "it is not an EXR file");
  expectMentions(complaintAbout(twoByOne().bytes().substr(0, 60)), "its header is damaged");
}

// Every cut and 800 random bytes changed, of a compressed and an uncompressed file: read or refused.
TEST(ReadExr, SurvivesEveryCutAndRandomDamage) {
  const TemporaryFolder folder;
  Image image({37, 21}, {"px.x", "px.y", "steps"});
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = static_cast<float>(i % 97);
  }
  ASSERT_TRUE(writeExr(folder / "whole.exr", image));
  std::mt19937 random(20260101);
  for (const std::string& whole : {readFile(folder / "whole.exr").value(), twoByOne().bytes()}) {
    for (std::size_t length = 0; length + 1 < whole.size(); length += 1 + whole.size() / 150) {
      static_cast<void>(writeFileAtomically(folder / "cut.exr", whole.substr(0, length)));
      EXPECT_FALSE(readExr(folder / "cut.exr")) << length << " of " << whole.size() << " bytes";
    }
    for (int i = 0; i < 400; ++i) {
      std::string damaged = whole;
      damaged[random() % damaged.size()] = static_cast<char>(random());
      static_cast<void>(writeFileAtomically(folder / "damaged.exr", damaged));
      static_cast<void>(readExr(folder / "damaged.exr"));
    }
  }
}

}  // namespace
}  // namespace ssrkit
