#pragma once
// Whether Run would run the text as rehearsed, from the present state of the controller.
#include <string>
#include <string_view>

#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct Rehearsed {
  bool holds = false;      ///< this text, from here, without findings
  std::string_view words;  ///< else the change since then, or the outcome
};
/// The chosen text, as Run would start it.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame);
/// The contents of the controller, for a run that starts a stored program and loads nothing.
[[nodiscard]] Rehearsed rehearsed_thread(const gui::Frame& frame, int program);
/// `text`: what would be run; `outcome`: null if there is none.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame, const gui::Rehearsals::Outcome* outcome,
                                  const std::string& text);

}  // namespace hw::panels
