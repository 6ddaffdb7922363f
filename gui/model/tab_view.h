#pragma once
// The state of one tab's view, which no file keeps. GUI thread.
#include <cstdint>
#include <string>

#include "core/device/snapshot.h"

namespace hw::gui {

struct TabView {
  AxisId chosen_axis{0};         ///< on a controller of many axes: the axis for Go and Home
  bool unset_read = false;       ///< the choices to make before the first move have been read, or made
  bool banner_folded = false;    ///< the banner of a lost link is one line high
  std::string follow_to;         ///< address to reopen the tab at before the next frame; see shell/follow.h
  std::string follow_left;       ///< address that was offered for follow_to, and declined
  std::uint64_t text_turns = 0;  ///< last ProgramDesk::text_turns() seen by the console

  /// Once a frame: what has moved needs no choices any more, and a link that is back unfolds the banner.
  void follow(const Snapshot& now) {
    unset_read = unset_read || now.any_axis_moving();
    banner_folded = banner_folded && now.link.state == LinkState::lost;
  }
};

}  // namespace hw::gui
