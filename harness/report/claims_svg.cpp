#include "report/claims_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/drawing_width.h"
#include "report/html_text.h"

namespace ssrkit {

namespace {

constexpr double kFigureLabelWidth = 330.0;
constexpr double kFigureBarWidth = 420.0;
constexpr double kFigureRowHeight = 22.0;
constexpr double kFigureHeaderHeight = 40.0;

// Okabe and Ito's colours, as in every picture of the kit.
constexpr const char* kConfirmed = "#009e73";
constexpr const char* kRefuted = "#d55e00";
constexpr const char* kShownOnly = "#56b4e9";
constexpr const char* kUndecided = "#e69f00";
constexpr std::array<const char*, 7> kClasses = {"#d55e00", "#009e73", "#cfe8f7", "#9dd0f0",
                                                 "#56b4e9", "#2a7fb8", "#0a4b78"};

const char* figureColour(const ClaimFigure& figure) {
  if (!figure.decides) {
    return kShownOnly;
  }
  return figure.verdict == ClaimVerdict::kConfirmed ? kConfirmed
         : figure.verdict == ClaimVerdict::kRefuted ? kRefuted
                                                    : kUndecided;
}

using FigureGroup = std::vector<const ClaimFigure*>;

std::vector<double> boundsOf(const ClaimFigure& figure) {
  std::vector<double> bounds;
  for (const auto& bound :
       {figure.check.min, figure.check.max, figure.refuting.above, figure.refuting.below}) {
    if (bound) {
      bounds.push_back(*bound);
    }
  }
  return bounds;
}

// The value at the right end: of every bar and bound. A figure below 0 is drawn by its size.
double figureScale(const FigureGroup& group) {
  double largest = 0.0;
  for (const ClaimFigure* figure : group) {
    const double value =
        figure->check.interval ? figure->check.interval->second : figure->check.value.value_or(0.0);
    largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
    for (const double bound : boundsOf(*figure)) {
      largest = std::max(largest, bound);
    }
  }
  return largest > 0.0 ? largest * 1.05 : 1.0;
}

std::string checkLabel(const CheckResult& check) {
  std::string text = fmt::format("{} {}x{}", check.scene, check.size.width, check.size.height);
  for (const std::string* part : {&check.stage, &check.case_name, &check.device}) {
    text += part->empty() ? "" : " " + *part;
  }
  return text;
}

std::string figureBar(const ClaimFigure& figure, double y, double scale) {
  const CheckResult& check = figure.check;
  const auto x = [&](double value) {
    return kFigureLabelWidth + kFigureBarWidth * std::clamp(std::abs(value) / scale, 0.0, 1.0);
  };
  std::string text = fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                                 kFigureLabelWidth - 8, y + 14, htmlText(checkLabel(check)));
  if (!check.value) {
    return text + fmt::format("<text x=\"{}\" y=\"{}\">not measured</text>\n", kFigureLabelWidth + 4, y + 14);
  }
  const double value = *check.value;
  text +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"14\" fill=\"{}\"/>", kFigureLabelWidth,
                  y + 3, std::max(1.0, x(value) - kFigureLabelWidth), figureColour(figure));
  if (check.interval) {
    text += fmt::format("<path d=\"M{:.1f} {}V{}M{:.1f} {}H{:.1f}M{:.1f} {}V{}\" stroke=\"#000\"/>",
                        x(check.interval->first), y + 6, y + 14, x(check.interval->first), y + 10,
                        x(check.interval->second), x(check.interval->second), y + 6, y + 14);
  }
  return text + fmt::format("<text x=\"{:.1f}\" y=\"{}\">{:.4g}</text>\n",
                            kFigureLabelWidth + kFigureBarWidth + 12, y + 14, value);
}

std::string lineAt(double value, double scale, double bottom, const char* colour, const char* word) {
  const double x = kFigureLabelWidth + kFigureBarWidth * std::clamp(value / scale, 0.0, 1.0);
  return fmt::format(
      "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"{3}\" stroke-width=\"2\" stroke-dasharray=\"4 3\">"
      "<title>{4} {5:g}</title></path>\n",
      x, kFigureHeaderHeight - 6, bottom, colour, word, value);
}

std::string headerOf(const ClaimFigure& figure, const std::string& name) {
  const std::string confirming = confirmingText(figure);
  const std::string bounds =
      confirming.empty() ? "shown only"
                         : fmt::format("confirmed at {}, refuted at {}", confirming, refutingText(figure));
  return fmt::format("<text x=\"0\" y=\"16\" font-weight=\"bold\">{}: {} ({}), {}</text>\n", htmlText(name),
                     htmlText(figure.check.metric), htmlText(figure.check.unit), htmlText(bounds));
}

// The shares of the classes side by side, of the whole bar's width.
std::string classShares(const CheckResult& check, double y) {
  double total = 0.0;
  for (const HistogramBin& bin : check.histogram) {
    total += static_cast<double>(bin.count);
  }
  std::string text;
  double x = kFigureLabelWidth;
  for (std::size_t i = 0; i < check.histogram.size() && total > 0.0; ++i) {
    const double share = static_cast<double>(check.histogram[i].count) / total;
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"10\" fill=\"{}\"><title>{}: {:.3g} "
        "%</title></rect>",
        x, y, share * kFigureBarWidth, kClasses.at(std::min(i, kClasses.size() - 1)),
        htmlText(check.histogram[i].label), 100.0 * share);
    x += share * kFigureBarWidth;
  }
  return text + fmt::format("<text x=\"{}\" y=\"{}\">samples by move</text>\n",
                            kFigureLabelWidth + kFigureBarWidth + 12, y + 10);
}

// What the colours of the classes mean.
std::string classLegend(const CheckResult& check, double y) {
  std::string text;
  double x = 0.0;
  for (std::size_t i = 0; i < check.histogram.size(); ++i) {
    text += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text>",
        x, y + 3, kClasses.at(std::min(i, kClasses.size() - 1)), x + 15, y + 12,
        htmlText(check.histogram[i].label));
    x += kDrawingWidth / static_cast<double>(kClasses.size());
  }
  return text;
}

std::string boundLines(const ClaimFigure& figure, double scale, double bottom) {
  std::string lines;
  const auto add = [&](const std::optional<double>& bound, const char* colour, const char* word) {
    lines += bound && *bound >= 0.0 ? lineAt(*bound, scale, bottom, colour, word) : "";
  };
  add(figure.check.min, kConfirmed, "confirmed from");
  add(figure.check.max, kConfirmed, "confirmed up to");
  add(figure.refuting.above, kRefuted, "refuted from");
  add(figure.refuting.below, kRefuted, "refuted up to");
  return lines;
}

std::string figureDrawing(const FigureGroup& group, const std::string& name) {
  const ClaimFigure& first = *group.front();
  const double scale = figureScale(group);
  std::string bars;
  double y = kFigureHeaderHeight;
  for (const ClaimFigure* figure : group) {
    bars += figureBar(*figure, y, scale);
    y += kFigureRowHeight;
    if (!figure->check.histogram.empty()) {
      bars += classShares(figure->check, y - 2);
      y += kFigureRowHeight - 6;
    }
  }
  bars += boundLines(first, scale, y);
  if (!first.check.histogram.empty()) {
    bars += classLegend(first.check, y);
    y += kFigureRowHeight;
  }
  return fmt::format("<svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\">{}{}</svg>\n", kDrawingWidth,
                     y + 4, kDrawingWidth, headerOf(first, name), bars);
}

}  // namespace

std::vector<std::string> figureDrawings(const ClaimReport& report) {
  std::vector<std::string> drawings;
  std::vector<std::string> drawn;
  for (const ClaimFigure& figure : report.result.figures) {
    const std::string& id = figure.check.id;
    if (std::ranges::find(drawn, id) != drawn.end()) {
      continue;
    }
    drawn.push_back(id);
    FigureGroup group;
    for (const ClaimFigure& other : report.result.figures) {
      if (other.check.id == id) {
        group.push_back(&other);
      }
    }
    drawings.push_back(figureDrawing(group, id.substr(std::min(id.size(), report.claim.test.id.size() + 1))));
  }
  return drawings;
}

}  // namespace ssrkit
