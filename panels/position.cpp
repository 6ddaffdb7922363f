#include "panels/position.h"

#include <array>

#include "gui/area.h"
#include "gui/axis_look.h"
#include "gui/popup.h"
#include "gui/tab.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/axis_extras.h"
#include "panels/path.h"
#include "panels/unit_chooser.h"

namespace hw::panels {

using namespace gui;

namespace {

AxisId axis_id(int i) { return AxisId{static_cast<std::uint8_t>(i)}; }

/// One size for all axes, so that the points stay in one column.
Face face_for_all(const Frame& f, Face wanted, float width_px) {
  std::array<NumberText, max_axes> numbers;
  std::array<std::string_view, max_axes> views;
  const std::size_t n = f.catalog.axes.size();
  std::string_view longest_unit;
  for (std::size_t i = 0; i < n; ++i) {
    const DisplayUnit& unit = f.tab.unit(axis_id(static_cast<int>(i)));
    numbers[i] = format_position(f.now.axes[i].position, unit);
    views[i] = numbers[i].view();
    if (unit.name.size() > longest_unit.size()) longest_unit = unit.name;
  }
  return digits_face(f.ui, {views.data(), n}, longest_unit, wanted, width_px);
}

Face wanted_face(const Frame& f) {
  if (f.catalog.axes.size() > 4) return Face::digits26;
  if (f.catalog.axes.size() > 2 || f.tier == Tier::narrow) return Face::digits32;
  return f.tier == Tier::wide ? Face::digits48 : Face::digits36;
}

/// Limit lamps of one axis where there is no room for the panel of limits.
void draw_small_limits(Frame& f, AxisId axis, ImVec2 at) {
  const AxisState& a = f.now.axes[axis.index];
  const std::string& name = f.catalog.axes[axis.index].name;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const bool hit = sign == Sign::minus ? a.limit_minus : a.limit_plus;
    const LampState state = !a.limits_known ? LampState::unknown : hit ? LampState::hit : LampState::off;
    const Rect r{at, ImVec2(at.x + f.ui.px(12), at.y + f.ui.px(20))};
    draw_lamp(f.ui, ImVec2(at.x + f.ui.px(6), std::floor(r.centre().y)), 10, LampShape::square, state);
    const std::string_view value = !a.limits_known ? "?" : hit ? "HIT" : "clear";
    show(f.ui, {Path("io/limit/{}/{}", name, letter(sign)), Kind::lamp, value, value, {}, false, {}}, r);
    at.x += f.ui.px(18);
  }
}

}  // namespace

void Position::draw(Frame& f) {
  if (f.tier == Tier::narrow)
    draw_strip(f);
  else
    draw_column(f);
}

void Position::draw_column(Frame& f) {
  draw_title(f);
  const float width = f.area.width;
  const Face face = face_for_all(f, wanted_face(f), f.ui.px(width));
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    group_line(f.ui, 0);
    gap(f.ui, f.catalog.axes.size() > 2 ? 4 : 8);
    draw_axis(f, axis_id(static_cast<int>(i)), width, face, false);
    gap(f.ui, f.catalog.axes.size() > 2 ? 4 : 8);
  }
  group_line(f.ui, 0);
}

void Position::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(ui, "Position", {}, 44);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const float chooser = unit_chooser_width(f);
  if (f.bench.present) {
    const float title = std::ceil(text_width(ui, Face::body_bold, "Position"));
    const float room = ui.px(f.area.width - chooser) - title;
    const float with_icon = badge_width(ui, Icon::emulated, "EMULATED");
    const bool icon = with_icon + ui.px(18) <= room;
    const float width = icon ? with_icon : badge_width(ui, Icon::none, "EMULATED");
    const float before = icon ? ui.px(10) : std::max(0.0f, std::floor((room - width) / 2));
    ImGui::SetCursorScreenPos(ImVec2(at.x + title + before, at.y + ui.px(12)));
    emulated_badge(ui, "dro/emulated", icon);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - chooser), at.y + ui.px(6)));
  draw_unit_chooser(f);
  ImGui::SetCursorScreenPos(after);
}

void Position::draw_strip(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float between = 24;
  const float column = std::floor((f.area.width - between) / 2);
  const Face face = face_for_all(f, Face::digits32, ui.px(column));
  const auto axes = f.catalog.axes.size();
  for (std::size_t i = 0; i < axes; ++i) {
    const float x = (i % 2) * (column + between), y = static_cast<float>(i / 2) * strip_row_height;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), at.y + ui.px(y + 2)));
    draw_axis(f, axis_id(static_cast<int>(i)), column, face, true);
  }
  const float rows = static_cast<float>((axes + 1) / 2), middle = at.x + ui.px(column + between / 2);
  if (axes > 1)
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(middle, at.y), ImVec2(middle + ui.hair(), at.y + ui.px(rows * strip_row_height)),
        ui[Tone::line]);
  for (float row = 1; row < rows; ++row) {
    const float y = at.y + ui.px(row * strip_row_height);
    draw_across(ui, y, y + ui.hair(), ui[Tone::line]);
  }
}

void Position::draw_axis(Frame& f, AxisId axis, float width, Face face, bool in_strip) {
  Ui& ui = f.ui;
  const AxisInfo& info = f.catalog.axes[axis.index];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float w = ui.px(width), middle = at.y + ui.px(10);
  const std::string& users = f.tab.profile.axes[axis.index].name;
  draw_text_line(ui, at.x, at.x + w, middle, Face::title_bold, ui[Tone::ink], info.name);
  float x = at.x + std::ceil(text_width(ui, Face::title_bold, info.name)) + ui.px(8);
  const std::string_view label = users.empty() ? std::string_view(info.description) : std::string_view(users);
  draw_text_line(ui, x, at.x + w - ui.px(120), middle, Face::body, ui[Tone::ink2], label);
  if (in_strip) {
    x += std::min(std::ceil(text_width(ui, Face::body, label)), w * 0.3f) + ui.px(12);
    draw_small_limits(f, axis, ImVec2(x, at.y));
    if (f.bench.present && axis.index == 0) {
      ImGui::SetCursorScreenPos(ImVec2(x + ui.px(40), at.y));
      emulated_badge(ui, "dro/emulated", width > 340);
    }
  }
  draw_state_right(ui, Path("dro/{}/state", info.name), ImVec2(at.x + w, at.y),
                   state_of(f.now, axis.index, f.clock));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(20)));
  draw_digits(f, axis, width, face);
  float below = at.y + ui.px(20) + ui.line(face);
  // Many axes with extras: what stands under the number of a few stands left of it.
  if (!in_strip && f.catalog.axes.size() > 2 && axis_extras_height(f.catalog, axis) > 0) {
    const DisplayUnit& unit = f.tab.unit(axis);
    const float taken =
        digits_width(ui, face, format_position(f.now.axes[axis.index].position, unit), unit.name);
    draw_captions_beside(f, axis, ImVec2(at.x, at.y + ui.px(20) + ui.px(4)), w - taken);
  } else {
    draw_captions(f, axis, ImVec2(at.x, below), w);
    below += ui.line(Face::small);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, below));
  if (!in_strip) draw_axis_extras(f, axis, ImGui::GetCursorScreenPos(), w);
}

void Position::draw_digits(Frame& f, AxisId axis, float width, Face face) {
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit& unit = f.tab.unit(axis);
  const std::string& name = f.catalog.axes[axis.index].name;
  DigitsOptions o;
  o.face = face;
  o.width = width;
  o.tip = "Click to copy it, to make it zero, or to say where the axis stands.";
  const State state = state_of(f.now, axis.index, f.clock);
  if (!a.position_known || a.position_doubtful)
    o.state = DigitsState::untrusted;
  else if (state == State::lost || state == State::stale || state == State::connecting)
    o.state = DigitsState::stale;
  else if (state == State::off)
    o.state = DigitsState::off;
  const bool never = a.seen_at == Instant{} && !a.position_known;
  const NumberText number = format_position(a.position, unit);
  const Touch t = digits(f.ui, Path("dro/{}/position", name), Path("Position of {}", name),
                         never ? std::string_view("-") : number.view(), unit.name, o);
  menu_.draw(f, axis, t);
}

/// About the number: steps, or what is wrong with it.
Position::Caption Position::about_number(Frame& f, AxisId axis) {
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

void Position::show_steps(Frame& f, AxisId axis, const Rect& where) {
  const DisplayUnit steps{f.catalog.step_word, 1, 0, false};
  const NumberText in_steps = format_with_unit(f.now.axes[axis.index].position, steps);
  show(f.ui,
       {Path("dro/{}/steps", f.catalog.axes[axis.index].name), Kind::text, "Steps", in_steps, {}, false, {}},
       where);
}

void Position::draw_captions(Frame& f, AxisId axis, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const float middle = at.y + ui.line(Face::small) / 2;
  const Caption left = about_number(f, axis);
  const float left_width = std::ceil(text_width(ui, Face::small, left.words));
  draw_text_line(ui, at.x, at.x + width, middle, Face::small, ui[left.tone], left.words);
  show_steps(f, axis, {at, ImVec2(at.x + width * 0.6f, at.y + ui.line(Face::small))});
  // What stands left is about the number, so it goes first: the right one is shortened, then left out.
  const float room = width - left_width - ui.px(left_width > 0 ? 12 : 0);
  for (const bool whole : {true, false}) {
    const NumberText right = where_to(f, axis, whole);
    const float right_width = std::ceil(text_width(ui, Face::small, right));
    if (right_width > room) continue;
    draw_text(ui, ImVec2(at.x + width - right_width, at.y), Face::small, ui[Tone::ink2], right);
    break;
  }
}

/// Two lines in what the number leaves at its left.
void Position::draw_captions_beside(Frame& f, AxisId axis, ImVec2 at, float room) {
  Ui& ui = f.ui;
  const float line = ui.line(Face::small), right = at.x + room - ui.px(8);
  const Caption about = about_number(f, axis);
  float y = at.y;
  if (!about.words.view().empty()) {
    draw_text_line(ui, at.x, right, y + line / 2, Face::small, ui[about.tone], about.words);
    y += line;
  }
  show_steps(f, axis, {at, ImVec2(right, at.y + line)});
  for (const bool whole : {true, false}) {
    const NumberText words = where_to(f, axis, whole);
    if (std::ceil(text_width(ui, Face::small, words)) > right - at.x) continue;
    draw_text(ui, ImVec2(at.x, y), Face::small, ui[Tone::ink2], words);
    break;
  }
}

/// At the right under the number: where it goes and how fast, or what a limit still lets it do. A held jog
/// has no target that the hand means.
NumberText Position::where_to(const Frame& f, AxisId axis, bool whole) {
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

}  // namespace hw::panels
