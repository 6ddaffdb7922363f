#pragma once
// Whether Run would run the text as rehearsed, from the present state of the controller.
#include <string>
#include <string_view>

#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct Rehearsed {
  bool holds = false;      ///< this text, from here, without findings
  std::string_view words;  ///< else what has changed since, or what was found
};
/// The chosen text, as Run would start it.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame);
/// What the controller holds, for a run that starts one program of it and loads nothing.
[[nodiscard]] Rehearsed rehearsed_thread(const gui::Frame& frame, int program);
/// `text`: what would be run; `outcome`: null if there is none.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame, const gui::Rehearsals::Outcome* outcome,
                                  const std::string& text);

}  // namespace hw::panels
