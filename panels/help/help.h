#pragma once
#include "gui/shell/panel_entry.h"
#include "panels/help/manual_reader.h"

namespace hw::panels {

/// The help: a sheet beside the panels, with the keyboard map and the manual.
class Help final : public gui::Sheet {
 public:
  void draw(gui::PageFrame& frame) override;

 private:
  void draw_head(gui::PageFrame& frame);

  ManualReader manual_;
  bool shows_manual_ = false;
};

}  // namespace hw::panels
