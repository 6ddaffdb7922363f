// Handles the keys that work wherever the caret is: stop, held jogs, next controller, size, help.
#include "gui/input/keyboard.h"
#include "gui/model/stop_words.h"
#include "gui/model/tap_size.h"
#include "gui/shell/console.h"
#include "gui/surface/ui.h"

namespace hw::gui {

void Console::attach(Keyboard& keyboard) {
  keyboard.on_edge = [this](const CommandEdge& edge) { on_edge(edge); };
  keyboard.on_focus_lost = [this](double) { let_go(); };
}

namespace {

constexpr std::uint8_t the_chosen = 255;
struct JogKey {
  Command command;
  std::uint8_t axis;
  Sign sign;
};
constexpr JogKey jog_keys[] = {
    {Command::jog_left, 0, Sign::minus},
    {Command::jog_right, 0, Sign::plus},
    {Command::jog_down, 1, Sign::minus},
    {Command::jog_up, 1, Sign::plus},
    {Command::jog_page_down, 2, Sign::minus},
    {Command::jog_page_up, 2, Sign::plus},
    {Command::jog_fourth_minus, 3, Sign::minus},
    {Command::jog_fourth_plus, 3, Sign::plus},
    {Command::jog_chosen_minus, the_chosen, Sign::minus},
    {Command::jog_chosen_plus, the_chosen, Sign::plus},
};

}  // namespace

void Console::on_edge(const CommandEdge& edge) {
  if (edge.command == Command::stop_all) {
    if (!edge.down) return;
    stop_all(edge.by_pad ? StoppedBy::button : StoppedBy::key);
    if (list_open_ && !tabs_.empty()) toast(Severity::plain, words_of_esc(tabs_));
  } else if (edge.command == Command::stop_at_once) {
    if (edge.down) stop_all(StoppedBy::key);  // a second press in a row stops at once
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
    jog_key(*tab, edge);
  }
}

void Console::jog_key(Tab& tab, const CommandEdge& edge) {
  for (const JogKey& key : jog_keys) {
    if (key.command != edge.command) continue;
    const auto held = tab.jog.control();
    const bool lets_go =
        !edge.down && held && held->source == JogHold::Source::gamepad && held->sign == key.sign;
    const AxisId chosen =
        lets_go ? held->axis : tab.view.chosen_axis;  // the chosen axis may have changed since
    const AxisId axis = key.axis == the_chosen ? chosen : AxisId{key.axis};
    if (axis.index >= tab.catalog().axes.size()) continue;
    const JogHold::Control control{edge.by_pad ? JogHold::Source::gamepad : JogHold::Source::keyboard, axis,
                                   key.sign};
    if (!edge.down && edge.cut_off) return tab.jog.take_away(control.source);
    if (!edge.down) return tab.jog.release(control, edge.at_s);
    if (const std::string_view why = tab.why_not_move(axis); !why.empty())
      return toast(Severity::warn, std::string(why));
    // A stick that snaps back overshoots its centre, which must not count as a tap.
    const bool taps = !edge.by_pad || key.axis == the_chosen;
    tab.jog.press(control, {taps ? tap_of(tab, axis) : Steps(), tab.settings.jog_speed(axis)}, edge.at_s);
  }
}

void Console::confirm_held_key(Ui& ui) {
  if (std::string why = ui.gamepad.take_words(); !why.empty()) toast(Severity::warn, std::move(why));
  Tab* tab = active();
  auto held = tab ? tab->jog.control() : std::nullopt;
  // No motion may begin or continue behind an open dialog or list.
  if (held && held->source != JogHold::Source::mouse && ui.registry.top_layer() > 0) held.reset();
  const bool by_pad = held && held->source == JogHold::Source::gamepad;
  if (by_pad && ui.gamepad.holds()) tab->jog.confirm(*held);
  if (!by_pad && ui.gamepad.holds()) ui.gamepad.rest_first();  // the hold was ended by other means
  if (!held || held->source != JogHold::Source::keyboard) return;
  for (const JogKey& key : jog_keys)
    if (key.axis == held->axis.index && key.sign == held->sign && ui.keyboard.held(key.command))
      tab->jog.confirm(*held);
}

}  // namespace hw::gui
