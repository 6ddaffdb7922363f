#pragma once
#include <string>
#include <vector>

#include "gui/shell/panel_entry.h"
#include "gui/shell/port_finder.h"
#include "panels/connect/connect_form.h"

namespace hw::panels {

/// Where a controller is found, remembered or started.
class Connect final : public gui::Page {
 public:
  void draw(gui::PageFrame& frame) override;
  gui::StatusSentence status(gui::Console& console) override;

 private:
  void draw_left(gui::PageFrame& frame, float width);
  void draw_recent(gui::PageFrame& frame, float width);
  void draw_newcomer(gui::PageFrame& frame, float width);
  void draw_found(gui::PageFrame& frame, const gui::Box& area);
  void draw_ports(gui::PageFrame& frame, float width);
  void draw_port(gui::PageFrame& frame, std::size_t index, const gui::FoundPort& port, float width);
  void draw_checks(gui::PageFrame& frame, std::size_t index, const gui::FoundPort& port, float left,
                   float width);
  void draw_address(gui::PageFrame& frame, float width);
  void draw_emulators(gui::PageFrame& frame, float width);
  void open(gui::PageFrame& frame, const std::string& address);

  ConnectForm form_;
  std::string address_, refused_;
  std::string opened_path_;  ///< the port whose test is unfolded
  struct Choice {
    std::string model, key;
    int chosen = 0;
  };
  std::vector<Choice> choices_;
};

}  // namespace hw::panels
