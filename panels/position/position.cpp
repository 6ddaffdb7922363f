#include "panels/position/position.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/column.h"
#include "panels/position/axis_extras.h"
#include "panels/position/axis_line.h"
#include "panels/position/position_strip.h"
#include "panels/position/position_words.h"
#include "panels/position/travel_bar.h"
#include "panels/position/unit_chooser.h"
#include "panels/position/what_fits.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float between_strip_columns = 24;
/// Width left of a number for an encoder position, so that numbers take smaller type before the encoder is
/// cut.
constexpr float room_beside = 80;

AxisId axis_id(std::size_t i) { return AxisId{static_cast<std::uint8_t>(i)}; }

bool in_strip(const Frame& f) { return f.tier == Tier::narrow; }
/// Whether each axis has a row with jog buttons.
bool as_lines(const Frame& f) { return f.catalog.axes.size() > 4; }
/// Whether captions are beside the number, not below it.
bool captions_beside(const Frame& f) {
  return in_strip(f) || (f.catalog.axes.size() > 2 && f.tier != Tier::wide);
}
/// Whether power is beside the name, because it has no line of its own.
bool power_in_head(const Frame& f) { return in_strip(f) || f.catalog.axes.size() > 2; }
/// Below the number the encoder is at the right, the caption at the left.
constexpr float encoder_slot = 112;

/// The unit beside a number. A unit common to all axes is in the title of the column if it is a word, because
/// many numbers need the width.
std::string_view unit_beside(const Frame& f, AxisId axis) {
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const bool text =
      (!in_strip(f) || as_lines(f)) && !unit.real && f.catalog.axes.size() > 2 && unit.name == shown_unit(f);
  return text ? std::string_view() : std::string_view(unit.name);
}

/// The same face for all axes, so that their decimal points are aligned.
Face face_for_all(const Frame& f, Face wanted, float width) {
  std::array<NumberText, max_axes> numbers;
  std::array<std::string_view, max_axes> views;
  const std::size_t n = f.catalog.axes.size();
  std::string_view longest_unit;
  for (std::size_t i = 0; i < n; ++i) {
    numbers[i] = format_position(f.now.axes[i].position, f.tab.settings.unit(axis_id(i)));
    views[i] = numbers[i].view();
    const std::string_view unit = unit_beside(f, axis_id(i));
    if (unit.size() > longest_unit.size()) longest_unit = unit;
  }
  const float room = f.ui.px(captions_beside(f) ? width - room_beside : width);
  return digits_face(f.ui, {views.data(), n}, longest_unit, wanted, room);
}

/// The width of the widest number of all axes, in pixels.
float widest_number(const Frame& f, Face face) {
  float widest = 0;
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i)
    widest = std::max(widest,
                      digits_width(f.ui, face, shown_position(f.now.axes[i], f.tab.settings.unit(axis_id(i))),
                                   unit_beside(f, axis_id(i))));
  return widest;
}

Face wanted_face(const Frame& f) {
  if (f.catalog.axes.size() > 2) return Face::digits32;
  return f.tier == Tier::wide ? Face::digits48 : Face::digits36;
}

}  // namespace

void Position::draw(Frame& f) {
  if (in_strip(f))
    draw_strip(f);
  else
    draw_column(f);
}

void Position::draw_column(Frame& f) {
  draw_title(f);
  if (as_lines(f)) return draw_lines(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const LeftColumn column = column_of(f);
  const Face face = face_for_all(f, wanted_face(f), f.area.width);
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const float top = at.y + f.ui.px(column.block() * static_cast<float>(i));
    ImGui::SetCursorScreenPos(ImVec2(at.x, top));
    group_line(f.ui, 0);
    ImGui::SetCursorScreenPos(ImVec2(at.x, top + f.ui.px(column.above)));
    draw_axis(f, axis_id(i), f.area.width, face, column);
    if (column.travel == 0)
      draw_travel_line(f.ui, f.tab, axis_id(i), ImVec2(at.x, top + f.ui.px(column.block() - 2)),
                       f.ui.px(f.area.width));
  }
  const float end = at.y + f.ui.px(column.block() * static_cast<float>(f.catalog.axes.size()));
  ImGui::SetCursorScreenPos(ImVec2(at.x, end));
  group_line(f.ui, 0);
}

void Position::draw_lines(Frame& f) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Face face = axis_line_face(f.ui, widest_number(f, Face::digits26), f.area.width);
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const AxisId axis = axis_id(i);
    const std::string& name = f.catalog.axes[i].name;
    const Path row_id("axis/{}", name);
    AxisLine line;
    line.id = row_id;
    line.name = name;
    line.label = f.tab.settings.profile.axes[i].name;
    line.state = state_of(f.now, static_cast<int>(i), f.clock);
    line.chosen = f.tab.view.chosen_axis == axis;
    line.face = face;
    line.tip =
        line.chosen ? "Click to copy the position, to set it to zero, or to set it." : "Click to choose it.";
    AxisLineTouch touched = draw_axis_line(f.ui, f.tab, axis, line, f.area.width);
    if (touched.pressed || touched.number.clicked) f.tab.view.chosen_axis = axis;
    if (!line.chosen) touched.number.clicked = false;  // the first press only chooses the row
    const Rect& aside = touched.aside;
    show_steps(f, axis, touched.number.rect);
    show_phase(f, axis, aside);
    const ImVec2 beside(aside.min.x, std::floor(aside.centre().y - f.ui.line(Face::small) / 2));
    const float mark = f.ui.px(16);
    const float text = draw_at_work(f, axis, ImVec2(beside.x + mark, beside.y), aside.width() - mark, true);
    const bool alone = text == 0 && !f.catalog.axes[i].encoder;
    draw_about_number(f, axis, beside, alone ? aside.width() : mark);
    if (text == 0 && aside.width() > f.ui.px(48)) draw_encoder(f, axis, aside.min, aside.width(), true);
    menu_.draw(f, axis, touched.number);
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + f.ui.px(axis_line_height) * static_cast<float>(i + 1)));
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
    const EmulatedForm form = emulated_form(ui, room - ui.px(18));
    const float before = form == EmulatedForm::whole
                             ? ui.px(10)
                             : std::max(0.0f, std::floor((room - emulated_width(ui, form)) / 2));
    ImGui::SetCursorScreenPos(ImVec2(at.x + title + before, at.y + ui.px(12)));
    emulated_badge(ui, "dro/emulated", form);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - chooser), at.y + ui.px(6)));
  chooser_.draw(f);
  ImGui::SetCursorScreenPos(after);
}

void Position::draw_strip(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto axes = f.catalog.axes.size();
  const float row_height = strip_row_height(axes);
  const float column = std::floor((f.area.width - between_strip_columns) / 2);
  const Face face = as_lines(f) ? Face::digits26 : face_for_all(f, Face::digits32, column);
  const LeftColumn measures = column_of(f);
  const float widest = widest_number(f, face);  // so that items beside a number keep their place
  for (std::size_t i = 0; i < axes; ++i) {
    const float x = (i % 2) * (column + between_strip_columns), y = static_cast<float>(i / 2) * row_height;
    const ImVec2 corner(at.x + ui.px(x), at.y + ui.px(y));
    draw_travel_line(ui, f.tab, axis_id(i), ImVec2(corner.x, corner.y + ui.px(row_height - 3)),
                     ui.px(column));
    if (as_lines(f)) {
      const float x_of_number = corner.x + ui.px(column) - widest;
      draw_beside_strip_number(f, axis_id(i),
                               {corner, ImVec2(x_of_number - ui.px(8), corner.y + ui.px(row_height))});
      ImGui::SetCursorScreenPos(ImVec2(x_of_number, corner.y + ui.px(4)));
      draw_digits(f, axis_id(i), widest / ui.scale, face);
      continue;
    }
    ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + ui.px(4)));
    draw_axis(f, axis_id(i), column, face, measures);
  }
  const float rows = static_cast<float>((axes + 1) / 2);
  const float middle = at.x + ui.px(column + between_strip_columns / 2);
  if (axes > 1)
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(middle, at.y), ImVec2(middle + ui.hair(), at.y + ui.px(rows * row_height)), ui[Tone::line]);
  for (float row = 1; row < rows; ++row) {
    const float y = at.y + ui.px(row * row_height);
    draw_across(ui, y, y + ui.hair(), ui[Tone::line]);
  }
}

void Position::draw_axis(Frame& f, AxisId axis, float width, Face face, const LeftColumn& column) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float w = ui.px(width), below_head = at.y + ui.px(column.head);
  const float slot = captions_beside(f) ? 36 : column.digits, below_digits = below_head + ui.px(slot);
  draw_head(f, axis, at, w, column.head);
  const float drop = std::max(0.0f, std::floor((ui.px(slot) - ui.line(face)) / 2));
  ImGui::SetCursorScreenPos(ImVec2(at.x, below_head + drop));
  draw_digits(f, axis, width, face);
  if (captions_beside(f)) {
    const NumberText number = shown_position(f.now.axes[axis.index], f.tab.settings.unit(axis));
    const float taken = digits_width(ui, face, number, unit_beside(f, axis));
    return draw_captions_beside(f, axis, ImVec2(at.x, below_head), w - taken - ui.px(8));
  }
  const float above_bar = below_digits + ui.px(column.caption + column.extras);
  if (column.travel > 0) draw_travel_bar(f, axis, ImVec2(at.x, above_bar), w);
  if (power_in_head(f)) return draw_provenance(f, axis, ImVec2(at.x, below_digits), w);
  draw_captions(f, axis, ImVec2(at.x, below_digits), w);
  draw_axis_extras(f, axis, ImVec2(at.x, below_digits + ui.line(Face::small)), w);
}

/// Draws name, user's name and state; in close rows power too, in the strip the limits. The user's name gets
/// the remaining width.
void Position::draw_head(Frame& f, AxisId axis, ImVec2 at, float w, float height) {
  Ui& ui = f.ui;
  const AxisInfo& info = f.catalog.axes[axis.index];
  const State state = state_of(f.now, axis.index, f.clock);
  const float middle = at.y + ui.px(height / 2), line = middle - std::floor(ui.line(Face::title_bold) / 2);
  draw_text_line(ui, at.x, at.x + w, middle, Face::title_bold, ui[Tone::ink], info.name);
  float left = at.x + std::ceil(text_width(ui, Face::title_bold, info.name)) + ui.px(8);
  // In a window below the smallest supported one, the state alone shows a limit.
  const bool has_room = left + ui.px(strip_limits_width + 16) <= at.x + w;
  const float limits = in_strip(f) && has_room ? ui.px(strip_limits_width) : 0;
  draw_state_right(ui, Path("dro/{}/state", info.name), ImVec2(at.x + w, line), state, Face::title_bold,
                   at.x + w - left - limits);
  // Buttons stay in place while the state word changes.
  const State longest = info.servo ? State::open_loop : State::moving_plus;
  const float widest = std::max(state_word_width(ui, state, Face::title_bold),
                                info.switchable ? state_word_width(ui, longest, Face::title_bold) : 0);
  float right = at.x + w - widest - ui.px(12);
  if (in_strip(f) && f.bench.present && axis.index == 0) {
    const EmulatedForm form = emulated_form(ui, right - left - limits - ui.px(48));
    const float width = emulated_width(ui, form);
    if (right - width >= left + limits) {
      ImGui::SetCursorScreenPos(ImVec2(right - width, at.y));
      emulated_badge(ui, "dro/emulated", form);
      right -= width + ui.px(8);
    }
  }
  if (power_in_head(f) && info.switchable) {
    const bool brief = power_width(f, axis, false) + limits + ui.px(48) > right - left;
    const float width = power_width(f, axis, brief);
    if (right - width >= left + limits) {
      draw_power(f, axis, ImVec2(right - width, at.y), height, brief);
      right -= width + ui.px(4);
    }
  }
  const std::string& users = f.tab.settings.profile.axes[axis.index].name;
  const std::string_view label = users.empty() ? std::string_view(info.description) : std::string_view(users);
  const float whole = std::ceil(text_width(ui, Face::body, label));
  const float words = std::min(whole, right - left - limits);
  if (words == whole || (!users.empty() && words > ui.px(32))) {  // a part of the maker's word is useless
    draw_text_line(ui, left, left + words + 1, middle, Face::body, ui[Tone::ink2], label);
    left += words + ui.px(12);
  }
  if (limits > 0) draw_strip_limits(f, axis, ImVec2(left, at.y));
}

Touch Position::draw_digits(Frame& f, AxisId axis, float width, Face face) {
  const std::string& name = f.catalog.axes[axis.index].name;
  DigitsOptions o;
  o.face = face;
  o.width = width;
  o.state = digits_state(f.now, axis.index, f.clock);
  o.tip = "Click to copy the position, to set it to zero, or to set it.";
  const NumberText number = shown_position(f.now.axes[axis.index], f.tab.settings.unit(axis));
  const Touch t = digits(f.ui, Path("dro/{}/position", name), Path("Position of {}", name), number,
                         unit_beside(f, axis), o);
  menu_.draw(f, axis, t);
  return t;
}

void Position::draw_captions(Frame& f, AxisId axis, ImVec2 at, float width) {
  Ui& ui = f.ui;
  show_steps(f, axis, {at, ImVec2(at.x + width * 0.6f, at.y + ui.line(Face::small))});
  // The left caption is about the number, so it comes first. The right caption is shortened, then left out.
  const float left_width = draw_about_number(f, axis, at, width);
  const float room = width - left_width - ui.px(12);
  const ImVec2 right(at.x + width - room, at.y);
  if (draw_at_work(f, axis, right, room, true) > 0) return;
  const NumberText steps = steps_behind(f, axis);
  const float wide = std::ceil(text_width(ui, Face::small, steps));
  if (wide <= room) draw_text(ui, ImVec2(at.x + width - wide, at.y), Face::small, ui[Tone::ink2], steps);
}

/// Draws the fault of the number, or the activity of its axis, or (`origin_too`) the origin of the number, at
/// least its mark beside the activity.
void Position::draw_about(Frame& f, AxisId axis, ImVec2 at, float room, bool origin_too) {
  Ui& ui = f.ui;
  const Caption about = about_number(f, axis);
  const std::string_view phase = phase_of(f, axis);
  const State state = state_of(f.now, axis.index, f.clock);
  const float line = ui.line(Face::small);
  const auto draw_words = [&](Tone tone, std::string_view words) {
    draw_text_line(ui, at.x, at.x + room, at.y + line / 2, Face::small, ui[tone], words);
  };
  show_steps(f, axis, {at, ImVec2(at.x + room, at.y + line)});
  if (axis_extras_height(f.catalog, axis) > 0) show_phase(f, axis, {at, ImVec2(at.x + room, at.y + line)});
  if (about.tone == Tone::warn) return (void)draw_about_number(f, axis, at, room);
  const bool does_nothing = phase.empty() && !shows_work(f, axis);
  if (origin_too) draw_about_number(f, axis, at, does_nothing ? room : ui.px(12));
  if (does_nothing) return (void)draw_at_work(f, axis, at, room, false);  // registered for scripts
  const float mark = origin_too ? ui.px(16) : 0;
  at.x += mark, room -= mark;
  if (!is_motion(state) && !phase.empty()) return draw_words(Tone::fault, phase);
  if (is_motion(state) && !phase.empty()) {
    draw_what_fits(ui, at, room, false, [&](int brevity) {
      NumberText words;
      words.append(brevity == 0 ? phase : "");
      words.append(brevity == 0 ? ", " : "");
      const Pps speed = f.now.axes[axis.index].speed;
      const DisplayUnit& unit = f.tab.settings.unit(axis);
      words.append((brevity < 2 ? format_speed(speed, unit) : format_brief_speed(speed, unit)).view());
      return words;
    });
    return;
  }
  draw_at_work(f, axis, at, room, false);
}

/// Draws a line below the number. The encoder has a fixed place at the right, whatever the caption at the
/// left.
void Position::draw_provenance(Frame& f, AxisId axis, ImVec2 at, float width) {
  const float slot = f.catalog.axes[axis.index].encoder ? f.ui.px(encoder_slot) : 0;
  draw_about(f, axis, at, width - slot - (slot > 0 ? f.ui.px(8) : 0), true);
  if (slot > 0) draw_encoder(f, axis, ImVec2(at.x + width - slot, at.y), slot, true);
}

/// Draws two lines left of the number: its fault or the axis's activity, and below the encoder or the origin
/// of the number.
void Position::draw_captions_beside(Frame& f, AxisId axis, ImVec2 at, float room) {
  Ui& ui = f.ui;
  const float line = ui.line(Face::small);
  const ImVec2 upper(at.x, at.y + ui.px(2)), lower(at.x, upper.y + line);
  const bool encoder = f.now.axes[axis.index].has_encoder && f.catalog.axes[axis.index].encoder;
  draw_about(f, axis, upper, room, encoder);
  if (f.now.axes[axis.index].has_encoder && f.catalog.axes[axis.index].encoder)
    return draw_encoder(f, axis, lower, room, false);
  if (about_number(f, axis).tone != Tone::warn) draw_about_number(f, axis, lower, room);
}

}  // namespace hw::panels
