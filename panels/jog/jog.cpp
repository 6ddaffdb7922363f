#include "panels/jog/jog.h"

#include <algorithm>
#include <cmath>

#include "gui/model/jog_choice.h"
#include "gui/model/tab.h"
#include "gui/model/tap_size.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/text.h"
#include "panels/jog/gamepad_switch.h"
#include "panels/jog/guarantee.h"
#include "panels/jog/jog_button.h"
#include "panels/jog/jog_units.h"
#include "panels/jog/power_switch.h"
#include "panels/measures.h"
#include "panels/position/unit_chooser.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float steps_height = 32, around_words = 6;
/// Relative widths of the first and last button in a row: "1 step" is longer than the labels between, "10
/// 000" is the longest.
constexpr float first_share = 1.13f, last_share = 1.4f;

struct Cell {
  float column, row;
  Icon icon;
};
/// The first two axes form a cross; the third and fourth are columns beside it.
Cell cell_of(AxisId axis, Sign sign) {
  const bool plus = sign == Sign::plus;
  if (axis.index == 0) return {plus ? 2.0f : 0.0f, 1, plus ? Icon::play : Icon::back};
  const float column = axis.index == 1 ? 1.0f : static_cast<float>(axis.index) + 1;
  return {column, plus ? 0.0f : 2.0f, plus ? Icon::up : Icon::down};
}

/// Each device of a bus, and each of many axes, has a row with two buttons of its own.
bool jogs_in_rows(const Frame& f) {
  return f.tier == Tier::narrow ? f.tab.bus && f.catalog.axes.size() == 1
                                : f.tab.bus || f.catalog.axes.size() > 4;
}
/// A second Stop has another effect.
bool stops_now(const Frame& f) {
  bool stops = false;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    stops = stops || tab.now().axes[axis.index].activity == Activity::stopping;
  });
  return stops;
}
bool in_pairs(const Frame& f) { return f.catalog.axes.size() > 4 && !jogs_in_rows(f); }

}  // namespace

// The measures of the column place each part, so that no text or choice in a part moves the next part.
void Jog::draw(Frame& f) {
  follow_unit(f);
  const LeftColumn column = column_of(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_title(f, column);
  const bool narrow = f.tier == Tier::narrow;
  const float top = at.y + f.ui.px(column.title);
  if (!narrow)
    draw_reason(f, {ImVec2(at.x, top), ImVec2(at.x + f.ui.px(f.area.width), top + f.ui.px(column.reason))});
  origin_ = ImVec2(at.x, top + f.ui.px(narrow ? 0 : column.reason));
  const float height = jogs_in_rows(f) ? draw_stop_and_steps(f, column)
                       : in_pairs(f)   ? draw_pairs(f)
                                       : draw_cross(f, column);
  ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height)));
  if (!column.speed_in_title) speed_.draw(f, column.speed_over_slider);
  if (!narrow) group_line(f.ui, 0);
  guard_.draw(f);
  refused_tap_.draw(f, {origin_, ImVec2(origin_.x + f.ui.px(f.area.width), origin_.y + f.ui.px(height))});
}

/// Draws Stop and steps where each device or axis has its jog buttons in its own row.
float Jog::draw_stop_and_steps(Frame& f, const LeftColumn& column) {
  const float stop = column.wide_stop;
  const float for_pad = f.ui.gamepad.present() ? stop + close_between : 0;
  draw_stop(f, 0, 0, ImVec2(f.area.width - for_pad, stop));
  draw_gamepad_switch(f, ImVec2(origin_.x + f.ui.px(f.area.width - stop), origin_.y), stop);
  const float steps = stop + column.between_steps;
  draw_steps_row(f, 0, steps, f.area.width);
  return steps + steps_height + column.below_steps;
}

/// In a narrow window the unit does not fit into the strip of positions, so it is here together with the
/// reason.
void Jog::draw_title(Frame& f, const LeftColumn& column) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float title = 40;
  draw_text_line(ui, at.x, at.x + ui.px(title), at.y + ui.px(column.title / 2), Face::body_bold,
                 ui[Tone::ink], "Jog");
  if (column.speed_in_title) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(title), at.y + ui.px(2)));
    speed_.draw_line(f, f.area.width - title);
  } else if (f.tier == Tier::narrow) {
    const float right = at.x + ui.px(f.area.width - unit_chooser_width(f));
    draw_reason(f, {ImVec2(at.x + ui.px(title), at.y), ImVec2(right - ui.px(8), at.y + ui.px(column.title))});
    ImGui::SetCursorScreenPos(ImVec2(right, at.y + ui.px(4)));
    chooser_.draw(f);
  } else {
    draw_guarantee_here(f, {ImVec2(at.x + ui.px(title), at.y),
                            ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(column.title))});
  }
}

/// Draws why jogging is impossible, or how to jog. The number of lines is always the same.
void Jog::draw_reason(Frame& f, const Rect& place) {
  Ui& ui = f.ui;
  const std::string_view flaw = speed_.flaw();
  const std::uint32_t off = flaw.empty() && f.tab.why_not_move().empty() ? powerless_axes(f) : 0;
  const std::string_view why = !flaw.empty() ? flaw
                               : off != 0    ? powerless_words(f, off)
                                             : f.tab.why_not_move();
  if (!why.empty()) ui.registry.keep_clear(place);
  if (why.empty() && f.tier == Tier::narrow) return draw_guarantee_here(f, place);
  if (why.empty() && column_of(f).speed_in_title) return draw_hint_over_guarantee(f, place);
  const bool unit_shown = steps_unit_.name.empty();
  const Path hint("Hold a button to move. A tap moves the chosen step{}{}.", unit_shown ? "" : ", in ",
                  unit_shown ? std::string_view() : std::string_view(steps_unit_.name));
  const OwnUnits own(f);
  const float line = ui.line(Face::small);
  const int lines = std::max(1, static_cast<int>(place.height() / line));
  const Rect left = draw_power_switches(f, place, off);
  const float words_left = place.min.x + ui.px(20);
  // A single line beside switches is centred on them.
  const bool beside = off != 0 && text_width(ui, Face::small, why) <= left.max.x - words_left;
  const bool in_middle = beside || f.tier == Tier::narrow;
  const float shown = line * static_cast<float>(beside ? 1 : lines);
  const float top = in_middle ? std::floor(place.centre().y - shown / 2) : place.min.y;
  const bool by_pad = why.empty() && f.ui.gamepad.armed();
  draw_icon(ImGui::GetWindowDrawList(), Icon::info, ImVec2(place.min.x + ui.px(6), top + ui.px(8)), ui.px(12),
            ui[why.empty() ? Tone::ink3 : Tone::ink2]);
  const Rect words{ImVec2(words_left, top), left.max};
  const Tone tone = !flaw.empty() ? Tone::fault : why.empty() ? Tone::ink3 : Tone::ink2;
  draw_text_in_lines(ui, words, Face::small, ui[tone],
                     by_pad               ? gamepad_hint(f).view()
                     : !why.empty()       ? why
                     : own.view().empty() ? hint.view()
                                          : own.view(),
                     lines);
  if (why.empty()) show_own_units(f, own, words);
}

void Jog::show_own_units(Frame& f, const OwnUnits& own, const Rect& place) {
  if (!own.view().empty())
    show(f.ui, {"jog/own_units", Kind::text, "Tap and hold", own.view(), {}, false, own.view()}, place);
}

void Jog::draw_guarantee_here(Frame& f, const Rect& place) {
  if (draw_guarantee(f, place)) guard_.open();
}

/// Draws the hint above the guarantee, for layouts whose title shows the speed.
void Jog::draw_hint_over_guarantee(Frame& f, const Rect& place) {
  const float line = f.ui.line(Face::small), badge = place.min.y + line + f.ui.px(3);
  const OwnUnits own(f);
  draw_text_line(f.ui, place.min.x, place.max.x, place.min.y + line / 2, Face::small, f.ui[Tone::ink3],
                 f.ui.gamepad.armed() ? "Hold LB, push a stick. B stops."
                 : own.view().empty() ? "Hold to move. A tap moves one step."
                                      : own.view());
  show_own_units(f, own, {place.min, ImVec2(place.max.x, place.min.y + line)});
  draw_guarantee_here(f, {ImVec2(place.min.x, badge), ImVec2(place.max.x, badge + f.ui.px(18))});
}

/// The longest form of words with which every step fits its button.
template <class Width>
int Jog::words_that_fit(const Frame& f, const Width& width) const {
  const auto fits = [&](int room) {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (text_width(f.ui, Face::body_bold, label_of(steps_[i], room)) > f.ui.px(width(i) - around_words))
        return false;
    return true;
  };
  int room = 3;
  while (room > 0 && !fits(room)) --room;
  return room;
}

float Jog::draw_cross(Frame& f, const LeftColumn& column) {
  const std::size_t axes = f.catalog.axes.size();
  const bool flat = axes == 1, beside = axes == 2;
  const float cell = column.cell, pitch = cell + close_between;
  const float left_over = f.area.width - (static_cast<float>(axes) + 1) * pitch + close_between;
  const float apart =
      std::clamp(left_over, 0.0f, 16.0f);  // space between the cross and the columns beside it
  for (std::size_t i = 0; i < axes; ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const AxisId axis{static_cast<std::uint8_t>(i)};
      const Cell place = cell_of(axis, sign);
      const float x = place.column * pitch + (place.column < 3 ? 0 : apart);
      draw_button(f, axis, sign, x, (flat ? 0 : place.row) * pitch, ImVec2(cell, cell));
    }
  draw_stop(f, pitch, flat ? 0 : pitch, ImVec2(cell, cell));
  const ImVec2 corner(f.ui.px(flat ? 3 * pitch + 8 : 0), f.ui.px(flat ? 0 : 2 * pitch));
  draw_gamepad_switch(f, ImVec2(origin_.x + corner.x, origin_.y + corner.y), cell);
  const float aside = 3 * pitch + apart;
  if (axes > 2) draw_stop_again(f, aside, pitch, ImVec2(f.area.width - aside, cell));
  const float height = flat ? cell : 3 * cell + 2 * close_between, below = height + column.between_steps;
  if (!beside) {
    draw_steps_row(f, 0, below, std::min(f.area.width, 304.0f));
    return below + steps_height + column.below_steps;
  }
  const float x = 3 * pitch + 12;
  draw_steps_column(f, x, std::min(f.area.width - x, 104.0f), height);
  return below;
}

/// Draws two buttons side by side for each of many axes, whose rows are too narrow for buttons.
float Jog::draw_pairs(Frame& f) {
  const ImVec2 size(44, 40);
  const float pair = 2 * size.x + close_between + 12, row = size.y + 8;
  const int columns = std::max(1, static_cast<int>((f.area.width + 12) / pair));
  const auto place = [&](int n) {
    return ImVec2(pair * static_cast<float>(n % columns), row * static_cast<float>(n / columns));
  };
  draw_stop(f, 0, 0, ImVec2(2 * size.x + close_between, size.y));
  const int axes = static_cast<int>(f.catalog.axes.size());
  for (int i = 0; i < axes; ++i) {
    const ImVec2 at = place(i + 1);
    const AxisId axis{static_cast<std::uint8_t>(i)};
    draw_button(f, axis, Sign::minus, at.x, at.y, size);
    draw_button(f, axis, Sign::plus, at.x + size.x + close_between, at.y, size);
  }
  const ImVec2 free = place(axes + 1);
  draw_gamepad_switch(f, ImVec2(origin_.x + f.ui.px(free.x), origin_.y + f.ui.px(free.y)), size.y);
  const float below = place(axes + (f.ui.gamepad.present() ? 1 : 0)).y + row;
  draw_steps_row(f, 0, below, std::min(f.area.width, 304.0f));
  return below + steps_height + 8;
}

void Jog::draw_button(Frame& f, AxisId axis, Sign sign, float x, float y, ImVec2 size) {
  Ui& ui = f.ui;
  HoldOptions o;
  o.icon = in_pairs(f) ? Icon::none : cell_of(axis, sign).icon;
  o.width = size.x;
  o.height = size.y;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const std::string_view name = f.catalog.axes[axis.index].name;
  draw_jog_button(ui, f.tab, axis, sign, Path("{}{}", name, sign_text(sign)), o);
}

void Jog::draw_stop(Frame& f, float x, float y, ImVec2 size) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const std::string_view tip = f.tab.desk().records.stop_times.tip();
  const Touch t =
      touch(ui, {"jog/stop", Kind::button, "Stop", {}, {}, false, tip, false, true}, ui.px(size.x, size.y));
  if (t.hovered || t.held) draw_fill(ui, t.rect, ui[t.held ? Tone::sel : Tone::hover]);
  draw_outline(ui, t.rect, ui[Tone::fault]);
  const bool again = stops_now(f), wide = size.x > 1.5f * size.y;
  const std::string_view word = !again ? "Stop" : wide ? "Stop at once" : "At once";
  const float middle = t.rect.centre().y;
  if (wide) {  // side by side
    const float words = text_width(ui, Face::body_bold, word),
                left = t.rect.centre().x - words / 2 + ui.px(8);
    draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
              ImVec2(std::floor(left - ui.px(14)), std::floor(middle)), ui.px(12), ui[Tone::fault]);
    draw_text_line(ui, std::floor(left), t.rect.max.x, middle, Face::body_bold, ui[Tone::fault], word);
  } else {
    const float apart = ui.px(size.y < 44 ? 8 : 10);
    const auto line = [&](float at, Face face, std::string_view words) {
      draw_text_centred(ui, {ImVec2(t.rect.min.x, at - ui.px(10)), ImVec2(t.rect.max.x, at + ui.px(10))},
                        face, ui[Tone::fault], words);
    };
    const Face face = again && size.x < 60 ? Face::small_bold : Face::body_bold;
    if (word.find(' ') != std::string_view::npos &&
        text_width(ui, face, word) >
            t.rect.max.x - t.rect.min.x - ui.px(4)) {  // the words are in two lines, without the icon
      line(middle - apart, face, word.substr(0, word.find(' ')));
      line(middle + apart, face, word.substr(word.find(' ') + 1));
    } else {
      draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
                ImVec2(std::floor(t.rect.centre().x), std::floor(middle - apart)), ui.px(12),
                ui[Tone::fault]);
      line(middle + apart, face, word);
    }
  }
  draw_ring(ui, t);
  if (t.started) f.tab.stop_all();  // on the press, not on the release
}

/// Draws the effect of a second press in the empty cell beside Stop.
void Jog::draw_stop_again(Frame& f, float x, float y, ImVec2 size) {
  const ImVec2 at(origin_.x + f.ui.px(x), origin_.y + f.ui.px(y));
  const Rect place{ImVec2(at.x, at.y + f.ui.px(size.y / 2) - f.ui.line(Face::small)),
                   ImVec2(at.x + f.ui.px(size.x), at.y + f.ui.px(size.y))};
  draw_text_in_lines(f.ui, place, Face::small, f.ui[Tone::ink2], "Stop again: at once, no ramp", 2);
}

// ---- step

void Jog::follow_unit(Frame& f) {
  const DisplayUnit* of_each = unit_of_taps(f.tab);
  const DisplayUnit& unit = of_each ? *of_each : common_unit(f);
  const UnitNames names(f.tab);
  const std::string_view name = of_each ? names.view() : std::string_view(unit.name);
  const int many = f.tier == Tier::wide || f.catalog.axes.size() != 2 ? 5 : 4;
  const auto chosen = [&](const JogStep& step) { return step.steps == f.tab.settings.profile.jog_step; };
  const bool lit = std::any_of(steps_.begin(), steps_.end(), chosen);
  units_differ_ = of_each != nullptr;
  const bool same = unit.real == steps_unit_.real && unit.per_step == steps_unit_.per_step;
  if (same && steps_unit_.name == name && many == steps_many_ && lit) return;
  steps_unit_ = unit;
  steps_unit_.name = name;
  steps_many_ = many;
  steps_ = jog_steps(steps_unit_, 5);
  // Never drop the chosen step.
  if (many < 5) steps_.erase(chosen(steps_.back()) ? steps_.begin() + 1 : steps_.end() - 1);
  // A tap must not move by a step that no button shows, so a step chosen in another unit is replaced by the
  // smallest step.
  if (std::none_of(steps_.begin(), steps_.end(), chosen))
    choose_jog(f.tab, steps_.front().steps, f.tab.settings.profile.jog_speed);
}

std::string_view Jog::label_of(const JogStep& step, int room) const {
  if (room >= 3 || (room >= 1 && &step == &steps_.back()))
    return step.label;  // one label with the unit is enough
  if (step.id != "step") return step.number;
  return room >= 2 ? std::string_view(step.label) : std::string_view("1 st.");
}

void Jog::draw_step(Frame& f, const JogStep& step, std::string_view label, float width) {
  ButtonOptions o;
  o.on = step.steps == f.tab.settings.profile.jog_step;
  o.width = width;
  o.tip = units_differ_ && step.id != "step"
              ? "A tap moves each axis this far in its own unit, at least a step."
          : step.caption.empty() ? std::string_view("A tap moves this far.")
                                 : std::string_view(step.caption);
  if (button(f.ui, Path("jog/step/{}", step.id), label, o).clicked)
    choose_jog(f.tab, step.steps, f.tab.settings.profile.jog_speed);
}

void Jog::draw_steps_column(Frame& f, float x, float width, float height) {
  const float pitch = (height - 32) / static_cast<float>(steps_.size() - 1);
  const int room = words_that_fit(f, [&](std::size_t) { return width; });
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(
        ImVec2(origin_.x + f.ui.px(x), origin_.y + f.ui.px(std::floor(pitch * static_cast<float>(i)))));
    draw_step(f, steps_[i], label_of(steps_[i], room), width);
  }
}

void Jog::draw_steps_row(Frame& f, float x, float y, float row) {
  const auto n = static_cast<float>(steps_.size());
  const bool tight = row < 260;
  const float first = tight ? 1 : first_share, last = tight ? 1.3f : last_share,
              between = tight ? 2 : close_between;
  const float share = (row - between * (n - 1)) / (n - 2 + first + last);
  const auto width = [&](std::size_t i) {
    return std::floor(share * (i == 0 ? first : i + 1 == steps_.size() ? last : 1));
  };
  const int room = words_that_fit(f, width);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(ImVec2(origin_.x + f.ui.px(x), origin_.y + f.ui.px(y)));
    draw_step(f, steps_[i], label_of(steps_[i], room), width(i));
    x += width(i) + between;
  }
}

}  // namespace hw::panels
