#include "check/metric_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ssrkit {
namespace {

TEST(MetricTable, EveryMetricHasOneRowWithANameAndAFunction) {
  std::set<Metric> metrics;
  std::set<std::string> names;
  for (const MetricRow& one : metricRows()) {
    EXPECT_TRUE(metrics.insert(one.metric).second) << one.name;
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(&row(one.metric), &one);
    EXPECT_EQ(findMetric(one.name), &one);
    EXPECT_NE(one.measure, nullptr) << one.name;
    EXPECT_FALSE(one.truths.empty()) << one.name;
  }
  EXPECT_EQ(metrics.size(), static_cast<std::size_t>(Metric::kClassConsistent) + 1);
}

TEST(MetricTable, AMetricTakesTheKeysThatItNeedsOrHasADefaultFor) {
  for (const MetricRow& one : metricRows()) {
    for (const std::string& key : one.needed_keys) {
      EXPECT_TRUE(takesKey(one, key)) << one.name << " " << key;
      EXPECT_TRUE(needsKey(one, key));
    }
    EXPECT_TRUE(one.default_passes.empty() || (takesKey(one, "passes") && !needsKey(one, "passes")))
        << one.name;
  }
}

}  // namespace
}  // namespace ssrkit
