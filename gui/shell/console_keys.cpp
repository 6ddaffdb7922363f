// What keys do wherever the caret stands: stop, jog while held, change the controller, the size, the help.
#include "gui/input/keyboard.h"
#include "gui/model/stop_words.h"
#include "gui/shell/console.h"
#include "gui/surface/ui.h"

namespace hw::gui {

void Console::attach(Keyboard& keyboard) {
  keyboard.on_edge = [this](const CommandEdge& edge) { on_edge(edge); };
  keyboard.on_focus_lost = [this](double) { let_go(); };
}

namespace {

struct JogKey {
  Command command;
  std::uint8_t axis;
  Sign sign;
};
constexpr JogKey jog_keys[] = {
    {Command::jog_left, 0, Sign::minus},      {Command::jog_right, 0, Sign::plus},
    {Command::jog_down, 1, Sign::minus},      {Command::jog_up, 1, Sign::plus},
    {Command::jog_page_down, 2, Sign::minus}, {Command::jog_page_up, 2, Sign::plus},
};

}  // namespace

void Console::on_edge(const CommandEdge& edge) {
  if (edge.command == Command::stop_all) {
    if (!edge.down) return;
    stop_all(StoppedBy::key);
    if (list_open_ && !tabs_.empty()) toast(Mood::plain, words_of_esc(tabs_));
  } else if (edge.command == Command::stop_at_once) {
    if (edge.down) stop_all(StoppedBy::key);  // the second one in a row
  } else if (edge.command == Command::next_controller || edge.command == Command::previous_controller) {
    if (edge.down) activate_next(edge.command == Command::next_controller ? 1 : -1);
  } else if (edge.command == Command::show_map) {
    if (edge.down) toggle_help();
  } else if (edge.command == Command::close_controller) {
    close_asked_ = close_asked_ || edge.down;
  } else if (edge.command == Command::larger || edge.command == Command::smaller) {
    if (edge.down) step_size(edge.command == Command::larger ? 1 : -1);
  } else if (edge.command == Command::normal_size) {
    if (edge.down) step_size(0);
  } else if (Tab* tab = active()) {
    jog_key(*tab, edge.command, edge.down, edge.at_s);
  }
}

void Console::jog_key(Tab& tab, Command command, bool down, double at_s) {
  for (const JogKey& key : jog_keys) {
    if (key.command != command || key.axis >= tab.catalog().axes.size()) continue;
    const AxisId axis{key.axis};
    const JogHold::Control control{JogHold::Hand::keyboard, axis, key.sign};
    if (!down) return tab.jog.release(control, at_s);
    if (const std::string_view why = tab.why_not_move(axis); !why.empty())
      return toast(Mood::warn, std::string(why));
    tab.jog.press(control, {tab.jog_step(), tab.jog_speed()}, at_s);
  }
}

void Console::confirm_held_key(Ui& ui) {
  Tab* tab = active();
  if (!tab) return;
  const auto held = tab->jog.control();
  if (!held || held->hand != JogHold::Hand::keyboard) return;
  for (const JogKey& key : jog_keys)
    if (key.axis == held->axis.index && key.sign == held->sign && ui.keyboard.held(key.command))
      tab->jog.confirm(*held);
}

}  // namespace hw::gui
