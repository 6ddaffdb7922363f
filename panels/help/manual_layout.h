#pragma once
// A page of the manual in a column: where each run of words stands. Made when the page or the column changes,
// so that a frame only draws what is in sight.
#include <string_view>
#include <vector>

#include <imgui.h>

#include "gui/surface/ui.h"
#include "panels/help/manual_text.h"

namespace hw::panels {

/// Words of one kind on one line; pixels from the top left of the page.
struct ManualRun {
  float x, y, width;
  gui::Face face;
  gui::Tone tone;
  std::string_view text;  ///< of the ManualText
  int link = -1;          ///< which of ManualLayout::links
  bool begins = false;    ///< the first of its link
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
  std::vector<std::string_view> links;  ///< their targets
  float width = 0, scale = 0, height = 0;
};

/// `text` must outlive what is returned.
ManualLayout lay_out_manual(const gui::Ui& ui, const ManualText& text, float width_px);

}  // namespace hw::panels
