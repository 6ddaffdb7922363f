#pragma once
// The few questions that the console itself asks. One at a time, over everything but STOP ALL and Esc.
#include <optional>
#include <string>
#include <vector>

#include "gui/tab.h"

namespace hw::gui {

class Console;
class Ui;

class Dialogs {
 public:
  /// Names of the controller and its axes.
  void names(Tab& tab);
  /// Closes it, after asking when something moves or a program runs, or a panel holds what is kept nowhere
  /// else.
  void close_controller(Console& console, Tab& tab);
  /// Whether the window may close. False: it is asked first, for the same reason; see Console::ended().
  bool may_end(Console& console);
  void reset(Tab& tab);
  /// A move needs an empty program and there is none: which of `slots` may be emptied? False, and nothing is
  /// asked, while another question is open.
  bool make_room(Tab& tab, std::vector<int> slots);
  /// What becomes of a servo axis whose loop is about to close far from its command. False as make_room().
  bool closing(Tab& tab, Tab::Question question);
  [[nodiscard]] bool open() const { return kind_ != Kind::none; }
  void close() { kind_ = Kind::none; }
  void draw(Ui& ui, Console& console);

 private:
  enum class Kind { none, names, close_controller, end, reset, make_room, closing };
  void begin(Kind kind, Tab& tab);
  void draw_names(Ui& ui, Console& console);
  void draw_close(Ui& ui, Console& console);
  void draw_end(Ui& ui, Console& console);
  int ask_about_unkept(Ui& ui);
  void draw_reset(Ui& ui);
  void draw_make_room(Ui& ui, Console& console);
  void draw_closing(Ui& ui);

  Kind kind_ = Kind::none;
  bool just_opened_ = false;
  bool goes_on_ = false;  ///< what closes moves, or its program runs
  std::string unkept_;    ///< what would be lost
  Tab* tab_ = nullptr;
  std::string name_;
  std::vector<std::string> axis_names_;
  std::vector<int> slots_;
  std::optional<Tab::Question> question_;
};

}  // namespace hw::gui
