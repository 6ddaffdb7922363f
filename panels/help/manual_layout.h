#pragma once
// Lays out a manual page in a column: the position of each run of words. It is done when the page or the
// column changes, so that a frame only draws the visible runs.
#include <string_view>
#include <vector>

#include <imgui.h>

#include "gui/surface/ui.h"
#include "panels/help/manual_text.h"

namespace hw::panels {

/// Words of the same style on a line; pixels from the top left of the page.
struct ManualRun {
  float x, y, width;
  gui::Face face;
  gui::Tone tone;
  std::string_view text;  ///< in the ManualText
  int link = -1;          ///< index into ManualLayout::links
  bool begins = false;    ///< first run of its link
};

struct ManualMark {  ///< a heading
  std::string_view anchor, words;
  float y;
};

struct ManualLayout {
  std::vector<ManualRun> runs;   ///< by y
  std::vector<gui::Rect> wells;  ///< behind code
  std::vector<float> hairlines;  ///< y, across the column
  std::vector<ManualMark> marks;
  std::vector<std::string_view> links;  ///< targets
  float width = 0, scale = 0, height = 0;
};

/// `text` must outlive the result.
ManualLayout lay_out_manual(const gui::Ui& ui, const ManualText& text, float width_px);

}  // namespace hw::panels
