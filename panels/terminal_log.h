#pragma once
// Draws the visible rows of traffic. Rows can be selected with the mouse and copied as text.
#include <cstdint>
#include <optional>
#include <string>

#include "gui/model/traffic_log.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

class TerminalLog {
 public:
  /// Fills the remaining width and `height` pixels.
  void draw(gui::Ui& ui, gui::TrafficLog& log, float height);
  /// The selected rows as text; without a selection, all rows shown.
  [[nodiscard]] std::string copied(gui::TrafficLog& log) const;
  void to_the_end() { follow_ = true; }
  void choose_none() { anchor_ = caret_ = none; }

 private:
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  struct Span {
    std::size_t begin, end;
  };
  void draw_rows(gui::Ui& ui, gui::TrafficLog& log, float row_height);
  void draw_row(gui::Ui& ui, gui::TrafficLog& log, const gui::TrafficLog::Row& row, const gui::Rect& place);
  void draw_fold(gui::Ui& ui, gui::TrafficLog& log, const gui::TrafficLog::Row& row, const gui::Rect& place);
  void choose(gui::Ui& ui, gui::TrafficLog& log, float row_height);
  void register_text(gui::Ui& ui, gui::TrafficLog& log, Span visible);
  [[nodiscard]] bool chosen(const gui::TrafficLog::Row& row) const;

  bool follow_ = true;  ///< keep the newest row visible
  // Record numbers, because rows come and go at both ends, while records keep their numbers.
  std::uint64_t anchor_ = none, caret_ = none;
  bool dragging_ = false, active_ = false;  ///< active: the last click was in the rows
  std::optional<gui::TrafficLog::Row> to_toggle_;
  std::string shown_text_;  ///< for scripts
  std::uint64_t shown_version_ = 0;
  std::size_t shown_begin_ = 0;
  ImVec2 size_{};
};

}  // namespace hw::panels
