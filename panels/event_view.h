#pragma once
// Shows the events of the controller, newest first: ends of motions and programs, losses, messages.
#include <cstdint>
#include <string>

#include "gui/model/event_log.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"

namespace hw::panels {

class EventView {
 public:
  /// Fills the remaining width and `height` pixels.
  void draw(gui::Frame& frame, float height);
  /// Draws the filter and Copy, from `left`, in pixels. Returns their right end.
  float draw_tools(gui::Frame& frame, float left, float top);

 private:
  void draw_rows(gui::Frame& frame, const gui::EventLog& log);
  void register_text(gui::Frame& frame, const gui::EventLog& log);

  gui::EventFilter filter_ = gui::EventFilter::all;
  std::string shown_text_;  ///< for scripts and Copy
  std::uint64_t shown_version_ = ~std::uint64_t{0};
  gui::EventFilter shown_filter_ = gui::EventFilter::all;
};

}  // namespace hw::panels
