#include "panels/position_words.h"

#include "gui/axis_look.h"
#include "gui/tab.h"
#include "gui/ui.h"
#include "gui/widgets/touch.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

Caption about_number(Frame& f, AxisId axis) {
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit steps{f.catalog.step_word, 1, 0, false};
  Caption said;
  const bool lost = f.now.link.state == LinkState::lost;
  const bool old = lost || (a.position_known && is_old(f.now, axis.index, f.clock));
  if (old && a.seen_at != Instant{}) {
    said.words.append(format_duration(seconds(f.clock - a.seen_at)).view());
    said.words.append(" old");
    said.tone = Tone::warn;
    f.ui.wake_in(1);
  } else if (!a.position_known) {
    said.words.append("not known: home it, or set it");
    said.tone = Tone::warn;
  } else if (a.position_doubtful) {
    said.words.append("doubtful: steps may be lost");
    said.tone = Tone::warn;
  } else if (f.tab.unit(axis).real) {
    said.words = format_with_unit(a.position, steps);
  }
  return said;
}

// A held jog has no target that the hand means.
NumberText where_to(const Frame& f, AxisId axis, bool whole) {
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit& unit = f.tab.unit(axis);
  const State state = state_of(f.now, axis.index, f.clock);
  NumberText words;
  if (state == State::limit_plus || state == State::limit_minus)
    words.append(state == State::limit_plus ? "can only move \u2212" : "can only move +");
  if (!is_motion(state)) return words;
  const bool target = a.has_target && a.activity != Activity::jogging, speed = a.speed.value > 0;
  if (target && whole) {
    words.append("to ");
    words.append(format_with_unit(a.target, unit).view());
  }
  if (speed) {
    words.append(target && whole ? " at " : "");
    words.append(format_speed(a.speed, unit).view());
  }
  return words;
}

DigitsState digits_state(const Snapshot& now, std::size_t axis, Instant clock) {
  const AxisState& a = now.axes[axis];
  const State state = state_of(now, static_cast<int>(axis), clock);
  if (!a.position_known || a.position_doubtful) return DigitsState::untrusted;
  if (state == State::lost || state == State::stale || state == State::connecting) return DigitsState::stale;
  return state == State::off ? DigitsState::off : DigitsState::good;
}

NumberText shown_position(const AxisState& a, const DisplayUnit& unit) {
  if (a.position_known || a.seen_at != Instant{}) return format_position(a.position, unit);
  NumberText nothing;
  nothing.append("-");
  return nothing;
}

void show_steps(Frame& f, AxisId axis, const Rect& where) {
  const DisplayUnit steps{f.catalog.step_word, 1, 0, false};
  const NumberText in_steps = format_with_unit(f.now.axes[axis.index].position, steps);
  show(f.ui,
       {Path("dro/{}/steps", f.catalog.axes[axis.index].name), Kind::text, "Steps", in_steps, {}, false, {}},
       where);
}

}  // namespace hw::panels
