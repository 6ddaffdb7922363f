#pragma once
#include "gui/shell/panel_entry.h"

namespace hw::panels {

/// The map of the keyboard.
class Help final : public gui::Page {
 public:
  void draw(gui::PageFrame& frame) override;
  gui::StatusSentence status(gui::Console& console) override;
};

}  // namespace hw::panels
