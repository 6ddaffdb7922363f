#pragma once
// Shows the program's log, newest first: why a command or reply was dropped, refused, lost or given up.
// Chooses which lines are shown and how much is logged from now on.
#include <cstdint>
#include <string>
#include <vector>

#include "gui/model/log_lines.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

class LogView {
 public:
  LogView();
  /// Fills the remaining width and `height` pixels.
  void draw(gui::PageFrame& frame, float height);
  /// Draws the tools from `left` to `right`, in pixels, as far as they fit. Returns their end.
  float draw_tools(gui::PageFrame& frame, float left, float right, float top);
  /// Copies all lines that are shown to the clipboard.
  static void copy(gui::PageFrame& frame);

 private:
  struct Rows {
    std::size_t begin, end;
  };
  void draw_family(gui::PageFrame& frame, float width);
  void draw_least(gui::PageFrame& frame, float width);
  void draw_level(gui::PageFrame& frame, float width);
  [[nodiscard]] Rows draw_rows(gui::PageFrame& frame);
  static float draw_lost(const gui::Ui& ui, std::uint64_t lost, float top);
  static void draw_row(const gui::Ui& ui, const hw::log::Line& line, const gui::Rect& place, float words_at);
  void register_text(gui::PageFrame& frame, Rows visible);

  std::vector<std::string_view> families_;  ///< families to choose from; the first means all
  gui::LogLines::View wanted_;
  std::size_t family_ = 0;                           ///< index into families_
  float subject_width_ = 0;                          ///< width of the longest subject shown, in pixels
  std::string shown_text_;                           ///< the visible text, for scripts
  std::uint64_t shown_version_ = ~std::uint64_t{0};  ///< version of the log to which both belong
  Rows shown_rows_{0, 0};
};

}  // namespace hw::panels
