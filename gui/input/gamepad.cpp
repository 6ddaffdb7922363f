#include "gui/input/gamepad.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "gui/model/gui_log.h"

namespace hw::gui {
namespace {

constexpr int dead_man = GLFW_GAMEPAD_BUTTON_LEFT_BUMPER;

struct StickCommand {
  Command minus, plus;
};
/// Indexed by GLFW's axis. Stick values grow downwards; up is plus, as on the jog pad of the screen.
constexpr StickCommand stick_commands[] = {{Command::jog_left, Command::jog_right},
                                           {Command::jog_up, Command::jog_down},
                                           {Command::jog_page_down, Command::jog_page_up},
                                           {Command::jog_fourth_plus, Command::jog_fourth_minus}};
struct PadButton {
  int button;
  Command command;
};
constexpr PadButton d_pad[] = {{GLFW_GAMEPAD_BUTTON_DPAD_LEFT, Command::jog_chosen_minus},
                               {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, Command::jog_chosen_minus},
                               {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, Command::jog_chosen_plus},
                               {GLFW_GAMEPAD_BUTTON_DPAD_UP, Command::jog_chosen_plus}};

constexpr PadControl controls[] = {
    {"LB", "Held: sticks may jog. Released: the jog stops"},
    {"Left stick", "Across jogs axis 1, up and down axis 2"},
    {"Right stick", "Across jogs axis 3, up and down axis 4"},
    {"D-pad", "Jogs the chosen axis; a tap moves one step"},
    {"B", "Stop all controllers; again: at once"},
};

}  // namespace

std::span<const PadControl> gamepad_map() { return controls; }

void Gamepad::arm(double now_s) {
  if (!present()) return;
  armed_ = must_rest_ = true;
  sticks_.fill(0);
  buttons_.fill(false);
  answered_at_s_ = changed_at_s_ = now_s;
}

void Gamepad::disarm(std::string_view why, double now_s) {
  if (!armed_) return;
  armed_ = false;
  gui_log().debug("the gamepad does not jog any more: {}", why);
  words_ = why;
  end(now_s, true);
}

void Gamepad::rest_first() {
  must_rest_ = true;
  held_.reset();
}

std::string Gamepad::take_words() { return std::exchange(words_, {}); }

// ---- deflection

/// The command of the largest deflection. A held command stays until its stick is released, or until another
/// is clearly larger.
std::optional<Command> Gamepad::of_sticks() const {
  std::optional<Command> best;
  float most = 0;
  for (std::size_t i = 0; i < sticks_.size(); ++i) {
    const float way = std::fabs(sticks_[i]);
    const Command command = sticks_[i] < 0 ? stick_commands[i].minus : stick_commands[i].plus;
    const bool is_held = held_ == command;
    const float counts = way + (is_held ? stronger_by : 0);
    if (way < (is_held ? ends_at : begins_at) || counts <= most) continue;
    most = counts;
    best = command;
  }
  return best;
}

std::optional<Command> Gamepad::pushed() const {
  for (const PadButton& pad : d_pad)
    if (buttons_[static_cast<std::size_t>(pad.button)]) return pad.command;
  return of_sticks();
}

// ---- actions

void Gamepad::end(double at_s, bool cut_off) {
  if (!held_) return;
  const Command command = *std::exchange(held_, std::nullopt);
  if (keyboard_.on_edge) keyboard_.on_edge({command, false, at_s, true, cut_off});
}

void Gamepad::stop(double at_s) {
  if (keyboard_.on_edge) keyboard_.on_edge({Command::stop_all, true, at_s, true});
  must_rest_ = true;
  end(at_s, true);
}

/// Whether all controls are at rest or nearly so. Without the margin a trembling hand would begin a jog.
bool Gamepad::let_go() const {
  return std::none_of(
             std::begin(d_pad), std::end(d_pad),
             [this](const PadButton& pad) { return buttons_[static_cast<std::size_t>(pad.button)]; }) &&
         std::none_of(sticks_.begin(), sticks_.end(), [](float way) { return std::fabs(way) >= ends_at; });
}

/// Ends a hold when nothing on the gamepad has changed for too long. The gamepad stays armed: the user can
/// release the stick and push again.
void Gamepad::stop_if_unchanged(double at_s) {
  if (!held_ || at_s - changed_at_s_ <= same_for_s) return;
  words_ = fmt::format(
      "Let go, then push again: nothing on the gamepad had changed for {:.0f} s, so its jog was stopped.",
      same_for_s);
  gui_log().debug("the gamepad's jog ends: nothing on it has changed for {} s", same_for_s);
  must_rest_ = true;
  end(at_s, true);
}

/// Returns true when no jog begins.
bool Gamepad::poll_pad(double at_s) {
  if (held_ && at_s - answered_at_s_ > silent_after_s) begin_frame(at_s);
  answered_at_s_ = at_s;
  const std::optional<Command> now = pushed();
  const bool may = armed_ && buttons_[dead_man];
  if (held_ && (!may || now != held_)) end(at_s, !may);
  stop_if_unchanged(at_s);
  if (let_go())
    must_rest_ = false;
  else if (!may)
    must_rest_ = true;  // otherwise the dead-man button alone would begin the motion
  return !may || !now || must_rest_ || held_;
}

bool Gamepad::on_arrival(const InputEvent& event) {
  switch (event.kind) {
    case InputKind::focus_lost:
      disarm("The gamepad was disarmed: the window has lost the keyboard.", event.at_s);
      return false;
    case InputKind::key:
      if (event.code == GLFW_KEY_ESCAPE && event.down) rest_first();
      return false;
    case InputKind::pad_stick:  // too many for a frame each
      if (armed_ && event.code >= 0 && event.code < static_cast<int>(sticks_.size()))
        sticks_[static_cast<std::size_t>(event.code)] = event.x;
      changed_at_s_ = event.at_s;
      return true;
    case InputKind::pad_button:
      changed_at_s_ = event.at_s;
      if (!armed_ || event.code < 0 || event.code >= static_cast<int>(buttons_.size())) return true;
      if (std::exchange(buttons_[static_cast<std::size_t>(event.code)], event.down) == event.down)
        return true;
      if (event.code == GLFW_GAMEPAD_BUTTON_B && event.down) stop(event.at_s);
      if (event.code == dead_man && !event.down) end(event.at_s, true);
      return false;
    case InputKind::pad_polled: {
      const bool had_words = !words_.empty();
      return poll_pad(event.at_s) &&
             words_.empty() == !had_words;  // the next frame shows why the jog has stopped
    }
    case InputKind::pad_gone:
      name_.clear();
      disarm(held_ ? "Plug the gamepad in and arm it again: it is gone, and its jog was stopped."
                   : "Plug the gamepad in and arm it again: it is gone.",
             event.at_s);
      return false;  // the next frame shows it
    default: return false;
  }
}

bool Gamepad::in_turn(const InputEvent& event) {
  if (event.kind < InputKind::pad_stick) return false;
  const std::optional<Command> now = pushed();
  if (event.kind != InputKind::pad_polled || !armed_ || !buttons_[dead_man] || !now || must_rest_ || held_)
    return true;
  must_rest_ = keyboard_.covered();  // a dialog or list is open
  if (must_rest_) return true;
  held_ = now;
  changed_at_s_ = event.at_s;
  if (keyboard_.on_edge) keyboard_.on_edge({*now, true, event.at_s, true});
  return true;
}

void Gamepad::begin_frame(double now_s) {
  if (held_ && now_s - answered_at_s_ > silent_after_s)
    disarm("Arm the gamepad again: it had not answered for 0.2 s, so its jog was stopped.", now_s);
}

}  // namespace hw::gui
