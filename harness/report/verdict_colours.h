// Colours and words of verdicts in pictures and reports.
#pragma once

#include <array>

#include "check/verdict.h"
#include "image/byte_image.h"

namespace ssrkit {

// Okabe and Ito's palette. kNone is grey: such pixels show the picture instead.
[[nodiscard]] Rgb8 colourOf(Verdict verdict);

// "hit, oracle did not": a few words for a legend.
[[nodiscard]] const char* meaningOf(Verdict verdict);

// From the worst to the most harmless. Where many pixels share one dot, the worst is shown, so that a single
// wrong ray stays visible.
inline constexpr std::array<Verdict, kVerdictCount> kWorstFirst = {
    Verdict::kFalseHit, Verdict::kMissedHit, Verdict::kWrong, Verdict::kLeak,
    Verdict::kNear,     Verdict::kAmbiguous, Verdict::kSame,  Verdict::kNone};

}  // namespace ssrkit
