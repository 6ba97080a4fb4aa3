// The keys of [[expect]] that only some metrics take.
#pragma once

#include "check/expectation.h"
#include "check/field_reader.h"
#include "check/metric_table.h"

namespace ssrkit {

void readMetricKeys(FieldReader& fields, const MetricRow& metric_row, const TestFile& test,
                    Expectation& expectation);

}  // namespace ssrkit
