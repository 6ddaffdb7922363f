#pragma once
// The console's own questions, one at a time. A question covers everything except STOP ALL; Esc still stops.
#include <optional>
#include <string>
#include <vector>

#include "gui/model/tab.h"

namespace hw::gui {

class Console;
class Ui;

class Dialogs {
 public:
  /// Asks for the names of the controller and its axes.
  void names(Tab& tab);
  /// Closes the controller. Asks first when an axis moves, a program runs or a panel holds unsaved data. A
  /// second call while the question is open stops the controller and closes it.
  void close_controller(Console& console, Tab& tab);
  /// Whether the window may close now. False: a question is shown first, and Console::ended() gives its
  /// answer.
  bool may_end(Console& console);
  /// The controller that the question about closing is about; null: no such question is open.
  [[nodiscard]] Tab* closing() const;
  void reset(Tab& tab);
  /// Asks which of `slots` may be emptied, because a move needs an empty program and there is none. Returns
  /// false without asking while another question is open.
  bool make_room(Tab& tab, std::vector<int> slots);
  /// Asks about a servo axis whose loop is about to close far from its commanded position. Returns false
  /// without asking while another question is open.
  bool closing(Tab& tab, FollowedIntents::Question question);
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
  bool goes_on_ = false;      ///< the controllers move or run, or did so when the question was asked
  std::string unkept_;        ///< data that would be lost
  std::vector<Tab*> closed_;  ///< controllers that the pending answer closes
  float words_height_ = 0;    ///< largest height of the reasons so far, in pixels
  Tab* tab_ = nullptr;
  std::string name_;
  std::vector<std::string> axis_names_;
  std::vector<int> slots_;
  std::optional<FollowedIntents::Question> question_;
};

}  // namespace hw::gui
