#include "spaces/trace_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ssrkit {
namespace {

TEST(TraceParameters, EveryNameReadsBackWhatItWrites) {
  TraceParameters parameters;
  for (const std::string& name : parameterNames()) {
    const std::string text = parameterText(parameters, name);
    EXPECT_TRUE(setParameter(parameters, name, text, "--param").has_value()) << name << " = " << text;
  }
  EXPECT_EQ(parameters, TraceParameters{});
}

TEST(TraceParameters, TakeNumbersWordsAndInfinity) {
  TraceParameters parameters;
  EXPECT_TRUE(setParameter(parameters, "thickness_m", "0.3", "").has_value());
  EXPECT_TRUE(setParameter(parameters, "max_distance_m", "inf", "").has_value());
  EXPECT_TRUE(setParameter(parameters, "stride_px", "8", "").has_value());
  EXPECT_TRUE(setParameter(parameters, "form", "textbook", "").has_value());
  EXPECT_EQ(parameters.thickness_m, 0.3);
  EXPECT_TRUE(std::isinf(parameters.max_distance_m));
  EXPECT_EQ(parameters.stride_px, 8);
  EXPECT_EQ(parameters.form, TracerForm::kTextbook);
}

TEST(TraceParameters, AThicknessIsRelativeAloneWhereNoneInMetresIsWrittenBesideIt) {
  EXPECT_TRUE(isThicknessRelativeAlone({{"jitter", "1"}, {"thickness_rel", "0.05"}}));
  EXPECT_FALSE(isThicknessRelativeAlone({{"thickness_rel", "0.05"}, {"thickness_m", "0.3"}}));
  EXPECT_FALSE(isThicknessRelativeAlone({{"thickness_m", "inf"}, {"thickness_rel", "0.05"}}));
  EXPECT_FALSE(isThicknessRelativeAlone({{"thickness_rel", "0"}}));
  EXPECT_FALSE(isThicknessRelativeAlone({{"thickness_m", "0.3"}}));
  EXPECT_FALSE(isThicknessRelativeAlone({}));
}

struct BadValue {
  const char* name;
  const char* value;
  const char* says;
};

class TraceParametersRefuse : public testing::TestWithParam<BadValue> {};

TEST_P(TraceParametersRefuse, AndStayAsTheyWere) {
  TraceParameters parameters;
  const auto set = setParameter(parameters, GetParam().name, GetParam().value, "file.toml:3:1");
  ASSERT_FALSE(set.has_value());
  const std::string text = sentence(set.error());
  EXPECT_EQ(text.find("file.toml:3:1: could not set the parameter"), 0U) << text;
  EXPECT_NE(text.find(GetParam().says), std::string::npos) << text;
  EXPECT_EQ(parameters, TraceParameters{});
}

INSTANTIATE_TEST_SUITE_P(
    Each, TraceParametersRefuse,
    testing::Values(BadValue{"thicknes_m", "1", "did you mean 'thickness_m'?"},
                    BadValue{"zzz", "1", "the parameters are thickness_m"},
                    BadValue{"thickness_m", "nan", "'nan' is not a number from 0"},
                    BadValue{"thickness_m", "-1", "'-1' is not"},
                    BadValue{"thickness_m", "-inf", "'-inf' is not"},
                    BadValue{"thickness_m", "thick", "'thick' is not"},
                    BadValue{"thickness_m", "1m", "'1m' is not"}, BadValue{"thickness_m", "", "'' is not"},
                    BadValue{"thickness_rel", "inf", "'inf' is not a number from 0 to 1000"},
                    BadValue{"max_distance_m", "0", "'0' is not"}, BadValue{"stride_px", "0", "'0' is not"},
                    BadValue{"stride_px", "1.5", "not a whole number"},
                    BadValue{"jitter", "1.01", "'1.01' is not a number from 0 to 1"},
                    BadValue{"lookup_budget", "70000", "from 0 to 60000"},
                    BadValue{"form", "fast", "'textbook' or 'tuned'"}));

}  // namespace
}  // namespace ssrkit
