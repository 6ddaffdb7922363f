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
  for (std::size_t i = 0; i < n; ++i) {
    numbers[i] = format_position(f.now.axes[i].position, f.tab.unit(axis_id(static_cast<int>(i))));
    views[i] = numbers[i].view();
  }
  return digits_face(f.ui, {views.data(), n}, wanted, width_px);
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
  if (f.bench.present) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(68), at.y + ui.px(12)));
    emulated_badge(ui, "dro/emulated");
  }
  const float chooser = unit_chooser_width(f);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - chooser), at.y + ui.px(6)));
  draw_unit_chooser(f);
  ImGui::SetCursorScreenPos(after);
}

void Position::draw_strip(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float column = f.area.width / 2;
  const Face face = face_for_all(f, Face::digits32, ui.px(column - 16));
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const float x = (i % 2) * column, y = static_cast<float>(i / 2) * strip_row_height;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), at.y + ui.px(y + 2)));
    draw_axis(f, axis_id(static_cast<int>(i)), column - 16, face, true);
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
      emulated_badge(ui, "dro/emulated");
    }
  }
  draw_state_right(ui, Path("dro/{}/state", info.name), ImVec2(at.x + w, at.y),
                   state_of(f.now, axis.index, f.clock));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(20)));
  draw_digits(f, axis, width, face);
  const float below = at.y + ui.px(20) + ui.line(face);
  draw_captions(f, axis, ImVec2(at.x, below), w);
  ImGui::SetCursorScreenPos(ImVec2(at.x, below + ui.line(Face::small)));
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

void Position::draw_captions(Frame& f, AxisId axis, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const AxisState& a = f.now.axes[axis.index];
  const DisplayUnit& unit = f.tab.unit(axis);
  const std::string& name = f.catalog.axes[axis.index].name;
  const float middle = at.y + ui.line(Face::small) / 2;
  const DisplayUnit steps{f.catalog.step_word, 1, 0, false};
  const NumberText in_steps = format_with_unit(a.position, steps);
  std::string_view left = unit.real ? in_steps.view() : std::string_view();
  Tone left_tone = Tone::ink2;
  const bool old = f.now.link.state == LinkState::lost || is_old(f.now, axis.index, f.clock);
  char age[48];
  if (!a.position_known) {
    left = "not known: home it, or set it";
    left_tone = Tone::warn;
  } else if (old && a.seen_at != Instant{}) {
    const auto end =
        fmt::format_to_n(age, sizeof age, "{} old", format_duration(seconds(f.clock - a.seen_at)).view());
    left = {age, std::min(end.size, sizeof age)};
    left_tone = Tone::warn;
    ui.wake_in(1);
  } else if (a.position_doubtful) {
    left = "doubtful: steps may be lost";
    left_tone = Tone::warn;
  }
  const float half = width * 0.6f;
  draw_text_line(ui, at.x, at.x + half, middle, Face::small, ui[left_tone], left);
  show(ui, {Path("dro/{}/steps", name), Kind::text, "Steps", in_steps, {}, false, {}},
       {at, ImVec2(at.x + half, at.y + ui.line(Face::small))});
  NumberText right;
  const State state = state_of(f.now, axis.index, f.clock);
  if (is_motion(state) && a.has_target) {
    right.append("to ");
    right.append(format_with_unit(a.target, unit).view());
  }
  if (is_motion(state) && a.speed.value > 0) {
    right.append(a.has_target ? " at " : "");
    right.append(format_speed(a.speed, unit).view());
  } else if (state == State::limit_plus || state == State::limit_minus) {
    right.append(state == State::limit_plus ? "can only move \u2212" : "can only move +");
  }
  const float right_width = std::ceil(text_width(ui, Face::small, right));
  draw_text(ui, ImVec2(at.x + width - right_width, at.y), Face::small, ui[Tone::ink2], right);
}

}  // namespace hw::panels
