#include "panels/position/position_words.h"

#include <algorithm>

#include "gui/model/axis_look.h"
#include "gui/model/provenance.h"
#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/position/what_fits.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

Caption about_number(Frame& f, AxisId axis, bool brief) {
  Caption caption;
  caption.words = provenance(f.now, axis, f.clock, f.tab.desk().records.traffic.clock(), brief);
  switch (origin_of(f.now, axis, f.clock)) {
    case Origin::stale: f.ui.wake_in(1), caption.tone = Tone::warn, caption.mark = Icon::clock; break;
    case Origin::unknown:
    case Origin::untrusted: caption.tone = Tone::warn, caption.mark = Icon::diamond; break;
    case Origin::homed: caption.tone = Tone::ok, caption.mark = Icon::house; break;
    case Origin::set: caption.mark = Icon::hand; break;
    case Origin::counted: caption.mark = Icon::tally; break;
  }
  return caption;
}

float draw_about_number(Frame& f, AxisId axis, ImVec2 at, float room) {
  Ui& ui = f.ui;
  const float mark = ui.px(12), gap = ui.px(4), line = ui.line(Face::small), middle = at.y + line / 2;
  Caption caption = about_number(f, axis);
  const NumberText whole = caption.words;
  const auto width_of = [&] { return mark + gap + std::ceil(text_width(ui, Face::small, caption.words)); };
  if (width_of() > room) caption = about_number(f, axis, true);
  const bool warns = caption.tone == Tone::warn;  // a part of a warning is better than none
  const bool with_words = width_of() <= room || (warns && room > ui.px(48));
  const float width = with_words ? std::min(width_of(), room) : mark;
  draw_icon(ImGui::GetWindowDrawList(), caption.mark, ImVec2(at.x + mark / 2, middle), mark,
            ui[caption.tone]);
  if (with_words)
    draw_text_line(ui, at.x + mark + gap, at.x + room, middle, Face::small, ui[caption.tone], caption.words);
  const Rect where{at, ImVec2(at.x + width, at.y + line)};
  const Path id("dro/{}/provenance", f.catalog.axes[axis.index].name);
  show(ui, {.id = id, .kind = Kind::text, .label = "Provenance", .value = whole}, where);
  return width;
}

NumberText steps_behind(const Frame& f, AxisId axis) {
  const DisplayUnit steps{counted_unit(f.catalog, f.now, f.catalog.step_word, axis.index), 1, 0, false};
  return f.tab.settings.unit(axis).real ? format_with_unit(f.now.axes[axis.index].position, steps)
                                        : NumberText();
}

// A held jog has no intended target, and a stopping axis will not reach its own.
NumberText where_to(const Frame& f, AxisId axis, bool whole) {
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const State state = state_of(f.now, axis.index, f.clock);
  NumberText words;
  if (state == State::limit_plus || state == State::limit_minus)
    words.append(state == State::limit_plus ? "can only move \u2212" : "can only move +");
  if (!is_motion(state)) return words;
  const bool target = a.has_target && a.activity != Activity::jogging && a.activity != Activity::stopping,
             speed = a.speed.value > 0;
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

NumberText format_brief_speed(Pps speed, const DisplayUnit& unit) {
  const NumberText whole = format_speed(speed, unit);
  const std::string_view words = whole;
  std::string_view number = words.substr(0, words.rfind(unit.name));
  while (number.ends_with(' ')) number.remove_suffix(1);
  NumberText brief;
  brief.append(number);
  brief.append("/s");
  return brief;
}

namespace {

/// Number of queue entries in use; 0: none, unknown, or no queue.
int queued(const Frame& f, AxisId axis) {
  const bool known = f.connected() && ((f.now.queue_known >> axis.index) & 1u);
  return known ? std::max(0, f.catalog.queue_depth - f.now.queue_free[axis.index]) : 0;
}

/// For a connected servo axis with a known position: its distance from the command, and in the longest form
/// the commanded position.
NumberText behind(const Frame& f, AxisId axis, int brevity) {
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const bool moves = is_motion(state_of(f.now, axis.index, f.clock));
  NumberText words;
  if (a.loop == Loop::none || !f.connected() || !a.position_known) return words;
  if (brevity == 0 && !moves) {
    words.append("sent to ");
    words.append(format_position(a.command, unit).view());
    words.append(", ");
  }
  words.append(brevity == least_words && !moves ? "off " : "error ");
  words.append(format_position(a.following_error(), unit).view());
  return words;
}

// Each level of brevity shows less. The unit of the speed goes first, because the position beside it shows
// it, then the speed. The lag of a servo axis goes last.
Path at_work(const Frame& f, AxisId axis, int brevity) {
  const Pps speed = f.now.axes[axis.index].speed;
  const bool runs = speed.value > 0 && is_motion(state_of(f.now, axis.index, f.clock));
  const int waiting = queued(f, axis);
  const NumberText error = behind(f, axis, brevity);
  const bool has_error = !error.view().empty();
  if (has_error && brevity == least_words) return Path("{}", error.view());
  NumberText does;
  if (brevity < 2)
    does = where_to(f, axis, brevity == 0);
  else if (runs && (has_error ? brevity == 2 : brevity < least_words || waiting == 0))
    does = format_brief_speed(speed, f.tab.settings.unit(axis));
  const auto comma = [](std::string_view before, bool more) { return before.empty() || !more ? "" : ", "; };
  const Path caption("{}{}{}", does.view(), comma(does, has_error), error.view());
  if (waiting == 0) return caption;
  if (brevity < 3)
    return Path("{}{}queue {} of {}", caption.view(), comma(caption, true), waiting, f.catalog.queue_depth);
  return Path("{}{}queue {}", caption.view(), comma(caption, true), waiting);
}

/// Registers `dro/X/queue` at the place of the activity.
void show_queue(Frame& f, AxisId axis, const Rect& where) {
  if (f.catalog.queue_depth <= 0) return;
  const bool known = f.connected() && ((f.now.queue_known >> axis.index) & 1u);
  const Path taken("{} of {}", queued(f, axis), f.catalog.queue_depth);
  const std::string_view value = known ? taken.view() : std::string_view("?");
  show(f.ui,
       {Path("dro/{}/queue", f.catalog.axes[axis.index].name), Kind::text, "Queue", value, {}, false, {}},
       where);
}

/// Registers `dro/X/command` and `dro/X/error` at the same place.
void show_servo(Frame& f, AxisId axis, const Rect& where) {
  const AxisState& a = f.now.axes[axis.index];
  if (a.loop == Loop::none) return;
  const std::string& name = f.catalog.axes[axis.index].name;
  const bool known = f.connected() && a.position_known;
  const NumberText command = format_position(a.command, f.tab.settings.unit(axis));
  const NumberText error = format_position(a.following_error(), f.tab.settings.unit(axis));
  const auto register_value = [&](const Path& id, std::string_view label, std::string_view value) {
    show(f.ui, {id, Kind::text, label, known ? value : "?", {}, false, {}}, where);
  };
  register_value(Path("dro/{}/command", name), "Command", command);
  register_value(Path("dro/{}/error", name), "Following error", error);
}

}  // namespace

bool shows_work(const Frame& f, AxisId axis) { return !at_work(f, axis, 0).view().empty(); }

float draw_at_work(Frame& f, AxisId axis, ImVec2 at, float room, bool right_aligned) {
  const Rect where{at, ImVec2(at.x + std::max(0.0f, room), at.y + f.ui.line(Face::small))};
  show_queue(f, axis, where);
  show_servo(f, axis, where);
  return draw_what_fits(f.ui, at, room, right_aligned,
                        [&](int brevity) { return at_work(f, axis, brevity); });
}

DigitsState digits_state(const Snapshot& now, std::size_t axis, Instant clock) {
  const AxisState& a = now.axes[axis];
  const State state = state_of(now, static_cast<int>(axis), clock);
  if (!a.position_known || a.trust.doubtful()) return DigitsState::untrusted;
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
  const DisplayUnit steps{counted_unit(f.catalog, f.now, f.catalog.step_word, axis.index), 1, 0, false};
  const NumberText in_steps = format_with_unit(f.now.axes[axis.index].position, steps);
  show(f.ui,
       {Path("dro/{}/steps", f.catalog.axes[axis.index].name), Kind::text, "Steps", in_steps, {}, false, {}},
       where);
}

}  // namespace hw::panels
