#pragma once
// The console's own few questions. One at a time, over everything but STOP ALL and Esc.
#include <optional>
#include <string>
#include <vector>

#include "gui/model/tab.h"

namespace hw::gui {

class Console;
class Ui;

class Dialogs {
 public:
  /// Names of the controller and its axes.
  void names(Tab& tab);
  /// Closes the controller. Asks first when something moves, a program runs or a panel holds unsaved data; a
  /// second call meanwhile stops the controller and closes.
  void close_controller(Console& console, Tab& tab);
  /// The same for the window. False: a question is shown first, and Console::ended() gives the answer.
  bool may_end(Console& console);
  /// The controller whose closing is being asked about; null: none.
  [[nodiscard]] Tab* closing() const;
  void reset(Tab& tab);
  /// Asks which of `slots` may be emptied, as a move needs an empty program and there is none. False, and
  /// nothing is asked, while another question is open.
  bool make_room(Tab& tab, std::vector<int> slots);
  /// Asks about a servo axis whose loop is about to close far from its command. False as make_room().
  bool closing(Tab& tab, Tab::Question question);
  [[nodiscard]] bool open() const { return kind_ != Kind::none; }
  void close() { kind_ = Kind::none; }
  void draw(Ui& ui, Console& console);

 private:
  enum class Kind { none, names, close_controller, end, reset, make_room, closing };
  void begin(Kind kind, Tab& tab);
  void draw_names(Ui& ui, Console& console);
  bool ask_to_close(Console& console, Kind kind, Tab* tab, std::vector<Tab*> closed);
  void leave(Console& console, bool stopped);
  [[nodiscard]] std::string why_asked() const;
  void draw_close(Ui& ui, Console& console);
  void draw_reset(Ui& ui);
  void draw_make_room(Ui& ui, Console& console);
  void draw_closing(Ui& ui);

  Kind kind_ = Kind::none;
  bool just_opened_ = false;
  bool goes_on_ = false;      ///< the closed controllers are active, or were when the question was asked
  std::string unkept_;        ///< what would be lost
  std::vector<Tab*> closed_;  ///< closed by the pending answer
  float words_height_ = 0;    ///< height of the reasons so far, in pixels
  Tab* tab_ = nullptr;
  std::string name_;
  std::vector<std::string> axis_names_;
  std::vector<int> slots_;
  std::optional<Tab::Question> question_;
};

}  // namespace hw::gui
