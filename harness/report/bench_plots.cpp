#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/bench_svg.h"
#include "report/drawing_width.h"
#include "report/html_text.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr double kHeight = 380.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 560.0;  // beyond it stands the legend
constexpr double kTop = 30.0;
constexpr double kBottom = 335.0;
constexpr std::array<const char*, 7> kCurveColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#e69f00", "#56b4e9", "#000000"};

using ScalingGroup = std::vector<const BenchScaling*>;

// One logarithmic axis: values to places on the drawing.
struct LogScale {
  double low = 1.0;
  double high = 10.0;
  double from = 0.0;
  double to = 1.0;

  [[nodiscard]] double at(double value) const {
    return from + (to - from) * std::log(value / low) / std::log(high / low);
  }
};

LogScale logScaleOf(const ScalingGroup& group, double BenchScalingPoint::*value, double from, double to) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (const BenchScaling* scaling : group) {
    for (const BenchScalingPoint& point : scaling->points) {
      if (point.*value > 0.0) {
        low = std::min(low, point.*value);
        high = std::max(high, point.*value);
      }
    }
  }
  if (high == 0.0) {
    return {.low = 1.0, .high = 10.0, .from = from, .to = to};
  }
  constexpr double kRoom = 1.15;
  return {.low = low / kRoom, .high = high * kRoom, .from = from, .to = to};
}

// The decades and their 2 and 5 that lie on the axis.
std::vector<double> ticksOf(const LogScale& scale) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(scale.low)));
  const int last = static_cast<int>(std::ceil(std::log10(scale.high)));
  for (int decade = first; decade <= last; ++decade) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double tick = digit * std::pow(10.0, decade);
      if (tick >= scale.low && tick <= scale.high) {
        ticks.push_back(tick);
      }
    }
  }
  return ticks;
}

std::string gridOf(const LogScale& x, const LogScale& y) {
  std::string text;
  for (const double tick : ticksOf(x)) {
    text += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4:g}</text>",
        x.at(tick), kTop, kBottom, kBottom + 15, tick);
  }
  for (const double tick : ticksOf(y)) {
    text += fmt::format(
        "<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:g}</text>",
        kLeft, y.at(tick), kRight, kLeft - 6, y.at(tick) + 4, tick);
  }
  return text + "\n";
}

std::string curveOf(const BenchScaling& scaling, const char* colour, const LogScale& x, const LogScale& y) {
  std::string text;
  for (const BenchScalingPoint& point : scaling.points) {
    if (point.x > 0.0 && point.ns_per_ray > 0.0) {
      text += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"><title>{}: {} ns a ray</title></circle>",
          x.at(point.x), y.at(point.ns_per_ray), colour, htmlText(point.label),
          measureText(point.ns_per_ray));
    }
  }
  if (scaling.time) {
    const auto [low, high] = std::ranges::minmax(scaling.points, {}, &BenchScalingPoint::x);
    const auto fitted = [&](double value) {
      return scaling.time->factor * std::pow(value, scaling.time->exponent);
    };
    text += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-dasharray=\"5 4\" fill=\"none\"/>",
        x.at(low.x), y.at(fitted(low.x)), x.at(high.x), y.at(fitted(high.x)), colour);
  }
  return text + "\n";
}

std::string curveLegend(const ScalingGroup& group) {
  std::string text;
  double y = kTop + 12;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const BenchScaling& scaling = *group[i];
    const std::string law = scaling.time ? fmt::format("exponent {:.2f} +- {:.2f}", scaling.time->exponent,
                                                       scaling.time->standard_error)
                                         : "no fit";
    text += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text>",
                        kRight + 20, y - 4, kCurveColours.at(i % kCurveColours.size()), kRight + 30, y,
                        htmlText(fmt::format("{}: {}", scaling.stage, law)));
    y += 18;
  }
  return text;
}

std::string curvesDrawing(const ScalingGroup& group) {
  const LogScale x = logScaleOf(group, &BenchScalingPoint::x, kLeft, kRight);
  const LogScale y = logScaleOf(group, &BenchScalingPoint::ns_per_ray, kBottom, kTop);
  const BenchScaling& first = *group.front();
  std::string text = fmt::format("<text x=\"0\" y=\"15\" font-weight=\"bold\">{}</text>\n",
                                 htmlText(fmt::format("{} of {} on {}: {} ns a ray over {}", first.axis,
                                                      first.scene, first.device, first.clock, first.x_unit)));
  text += gridOf(x, y);
  for (std::size_t i = 0; i < group.size(); ++i) {
    text += curveOf(*group[i], kCurveColours.at(i % kCurveColours.size()), x, y);
  }
  text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", (kLeft + kRight) / 2,
                      kBottom + 34, htmlText(first.x_unit));
  return fmt::format("<svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\">{}{}</svg>\n", kDrawingWidth,
                     kHeight, kDrawingWidth, text, curveLegend(group));
}

}  // namespace

std::vector<std::string> benchPlots(const BenchReport& report) {
  std::vector<ScalingGroup> groups;
  for (const BenchScaling& scaling : report.scalings) {
    const auto group = std::ranges::find_if(groups, [&](const ScalingGroup& known) {
      const BenchScaling& first = *known.front();
      return first.axis == scaling.axis && first.scene == scaling.scene && first.device == scaling.device;
    });
    if (group == groups.end()) {
      groups.push_back({&scaling});
    } else {
      group->push_back(&scaling);
    }
  }
  std::vector<std::string> drawings;
  std::ranges::transform(groups, std::back_inserter(drawings), curvesDrawing);
  return drawings;
}

}  // namespace ssrkit
