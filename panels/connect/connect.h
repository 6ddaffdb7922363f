#pragma once
#include <string>
#include <vector>

#include "core/session/recent.h"
#include "gui/shell/panel_entry.h"
#include "gui/shell/port_finder.h"
#include "panels/connect/connect_form.h"
#include "panels/connect/link_card.h"
#include "panels/connect/usual_catalogs.h"
#include "panels/log_view.h"

namespace hw::panels {

/// The connection page: finds, reopens or starts a controller. The centre lists open controllers, ports of
/// this computer, and connections used before.
class Connect final : public gui::Page {
 public:
  void draw(gui::PageFrame& frame) override;
  gui::StatusSentence status(gui::Console& console) override;

 private:
  // connect.cpp
  void draw_left(gui::PageFrame& frame, float width);
  void draw_recent(gui::PageFrame& frame, std::size_t index, float width);
  void draw_newcomer(gui::PageFrame& frame, float width);
  void draw_address(gui::PageFrame& frame, float width);
  void open(gui::PageFrame& frame, const std::string& address);
  void open_last_time(gui::PageFrame& frame);
  void look_at_recent(gui::Console& console);
  void draw_last_time_title(gui::PageFrame& frame, float width);
  // connect_found.cpp
  void draw_found(gui::PageFrame& frame, const gui::Box& area);
  void draw_found_title(gui::PageFrame& frame, float width);
  void draw_rows(gui::PageFrame& frame, float width);
  void draw_open(gui::PageFrame& frame, std::size_t index, gui::Tab& tab, float width);
  void draw_place(gui::PageFrame& frame, std::size_t index, float width);
  void draw_port(gui::PageFrame& frame, std::size_t index, const gui::FoundPort& port, float width);
  void draw_checks(gui::PageFrame& frame, std::size_t index, const gui::FoundPort& port, float left,
                   float width);
  // connect_emulators.cpp
  void draw_emulators(gui::PageFrame& frame, float width);
  void draw_emulator(gui::PageFrame& frame, const Catalog& catalog, float width);
  const std::string& draw_options(gui::PageFrame& frame, const Catalog& catalog, float width);

  // connect_log.cpp
  void draw_log(gui::PageFrame& frame);
  void draw_log_button(gui::PageFrame& frame);

  /// A connection used before. It is parsed once, not in each frame.
  struct Recent {
    RecentConnection entry;
    std::string name, place;  ///< as shown
    Address address;
    bool understood = false, last_time = false;
  };
  static void describe_place(Recent& recent);
  struct Choice {
    std::string model, key;
    int chosen = 0;
  };

  UsualCatalogs catalogs_;
  ConnectForm form_{catalogs_};
  LinkCard card_;
  std::vector<Recent> recent_;
  std::string closed_words_;  ///< when the last run ended, in words that depend on today
  Instant closed_read_at_{};  ///< time at which the words were made
  std::string address_, refused_;
  std::string opened_path_;  ///< path of the port whose test is unfolded
  bool form_shown_ = false;  ///< shown even while a card needs the space
  std::vector<Choice> choices_;
  LogView log_;
  bool log_shown_ = false;        ///< shown instead of the connections
  std::string emulator_address_;  ///< address of the emulator being drawn; a member to keep its memory
};

}  // namespace hw::panels
