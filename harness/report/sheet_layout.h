// Where the parts of a contact sheet go, in dots.
#pragma once

#include "base/size.h"

namespace ssrkit {

struct SheetLayout {
  static constexpr int kMargin = 24;
  static constexpr int kTitleHeight = 56;
  static constexpr int kCaptionHeight = 48;  // above each picture: a bold line and a plain one
  static constexpr int kCountsHeight = 64;   // below the verdict map
  static constexpr int kGap = 20;

  Size cell;
  int stage_count = 1;

  // Columns fit the captions, whatever the image; rows fit the legends.
  [[nodiscard]] int columnWidth() const { return cell.width < kNarrowest ? kNarrowest : cell.width; }
  [[nodiscard]] int pictureHeight() const {
    return cell.height < kLegendHeight ? kLegendHeight : cell.height;
  }

  // Column 0 holds the lit image and the legends. `row`: 0 composite, 1 verdicts, 2 lookups.
  [[nodiscard]] int columnX(int column) const { return kMargin + column * (columnWidth() + kGap); }
  [[nodiscard]] int pictureY(int row) const {
    const int rows_above = row * (kCaptionHeight + pictureHeight());
    return kMargin + kTitleHeight + rows_above + kCaptionHeight + (row == 2 ? kCountsHeight : 0);
  }
  [[nodiscard]] Size sheet() const {
    return {columnX(stage_count + 1) - kGap + kMargin, pictureY(2) + pictureHeight() + kMargin};
  }

 private:
  static constexpr int kNarrowest = 320;
  static constexpr int kLegendHeight = 180;
};

}  // namespace ssrkit
