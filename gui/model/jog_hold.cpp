#include "gui/model/jog_hold.h"

#include <algorithm>

#include "gui/model/gui_log.h"

namespace hw::gui {

void JogHold::press(const Control& control, const Want& want, double at_s) {
  if (held_) {
    if (held_->control == control) return;  // auto-repeat, or a doubled edge
    end(End::released);
  }
  Held held;
  held.control = control;
  held.want = want;
  held.pressed_at_s = held.seen_at_s = at_s;
  held_ = held;
}

void JogHold::release(const Control& control, double) {
  if (held_ && held_->control == control) end(End::released);
}

void JogHold::let_go() {
  if (held_) end(End::interrupted);
}

void JogHold::confirm(const Control& control) {
  if (held_ && held_->control == control) held_->confirmed = true;
}

void JogHold::end(End how) {
  const Held held = *held_;
  held_.reset();
  if (held.jogging) {
    send_(intent::JogStop{-1, how == End::released ? StoppedBy::let_go : StoppedBy::console});
  } else if (how == End::released && held.want.step.value > 0) {
    std::vector<AxisTarget> one(1, AxisTarget{held.control.axis, held.want.step});
    if (held.control.sign == Sign::minus) one[0].value = -one[0].value;
    tap_ = send_(intent::MoveBy(std::move(one), held.want.speed));
  }
}

bool JogHold::tick(double now_s) {
  if (!held_) return false;
  Held& held = *held_;
  // A late frame may be followed by the release that it delayed: never start a jog on it.
  const bool frozen = now_s - held.seen_at_s > frozen_after_s;
  const bool unseen = !held.confirmed;
  if (frozen || unseen) {
    gui_log().debug("the hold of axis {} ends: {}", held.control.axis.index + 1,
                    frozen ? "no frame for too long" : "its control is no longer seen as held");
    let_go();
    return frozen;
  }
  held.seen_at_s = now_s;
  held.confirmed = false;
  if (!held.jogging && now_s - held.pressed_at_s >= continuous_after_s) {
    held.jogging = true;
    held.kept_alive_at_s = now_s;
    held.intent = send_(intent::JogStart(held.control.axis, held.control.sign, held.want.speed));
  } else if (held.jogging) {
    held.kept_alive_at_s = now_s;
    send_(intent::JogKeepAlive());
  }
  return false;
}

std::optional<JogHold::Control> JogHold::control() const {
  if (!held_) return std::nullopt;
  return held_->control;
}

double JogHold::due_in_s(double now_s) const {
  if (!held_) return 1e9;
  const double due =
      held_->jogging ? held_->kept_alive_at_s + keep_alive_every_s : held_->pressed_at_s + continuous_after_s;
  // At least as often as a frame is required, or the hold would count as frozen.
  return std::clamp(due - now_s, 0.0, keep_alive_every_s);
}

}  // namespace hw::gui
