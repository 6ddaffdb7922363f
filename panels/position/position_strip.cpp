#include "panels/position/position_strip.h"

#include <algorithm>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/position/axis_extras.h"
#include "panels/position/position_words.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

/// Draws the state, then EMULATED at the first axis and the user's name at the others, if they fit.
void draw_strip_state(Frame& f, AxisId axis, ImVec2 at, float end) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  const StateLook& look = look_of(state_of(f.now, axis.index, f.clock));
  const float middle = at.y + std::floor(ui.line(Face::small) / 2), icon = ui.px(18);
  const auto word_width = [&](State state) {
    return icon + std::ceil(text_width(ui, Face::small_bold, look_of(state).word));
  };
  const bool worded = at.x + icon + text_width(ui, Face::small_bold, look.word) <= end;
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(at.x + ui.px(6), middle), ui.px(10), ui[look.tone]);
  if (worded) draw_text_line(ui, at.x + icon, end + 1, middle, Face::small_bold, ui[look.tone], look.word);
  show(ui, {Path("dro/{}/state", name), Kind::text, "State", look.word, {}, false, look.word},
       {at, ImVec2(std::max(at.x + icon, std::min(end, at.x + word_width(State::moving_plus))),
                   at.y + ui.line(Face::small) - ui.px(2))});
  const float left = at.x + std::max(word_width(State::moving_plus), word_width(State::stopping)) + ui.px(8);
  if (f.bench.present && axis.index == 0) {
    const EmulatedForm form = emulated_form(ui, end - left);
    if (left + emulated_width(ui, form) > end) return;
    ImGui::SetCursorScreenPos(ImVec2(left, at.y - ui.px(2)));
    return emulated_badge(ui, "dro/emulated", form);
  }
  const std::string& users = f.tab.settings.profile.axes[axis.index].name;
  const std::string_view label =
      users.empty() ? std::string_view(f.catalog.axes[axis.index].description) : std::string_view(users);
  const bool whole = left + std::ceil(text_width(ui, Face::small, label)) <= end;
  if (whole || (!users.empty() && end - left > ui.px(40)))  // a part of the maker's word is useless
    draw_text_line(ui, left, end, middle, Face::small, ui[Tone::ink2], label);
}

}  // namespace

/// Draws the limit lamps of an axis where the limits panel does not fit.
void draw_strip_limits(Frame& f, AxisId axis, ImVec2 at) {
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

void draw_beside_strip_number(Frame& f, AxisId axis, const Rect& row) {
  Ui& ui = f.ui;
  const AxisInfo& info = f.catalog.axes[axis.index];
  const float middle = std::floor(row.centre().y), small = ui.line(Face::small);
  const float end = row.max.x;
  draw_text_line(ui, row.min.x, end, middle, Face::title_bold, ui[Tone::ink], info.name);
  const float name = std::ceil(text_width(ui, Face::title_bold, info.name));
  float x = row.min.x + std::max(ui.px(22), name + ui.px(8));
  if (end - x < ui.px(38))
    return draw_strip_state(f, axis, ImVec2(x, middle - small / 2), end);  // only the icon fits
  if (const float power = power_width(f, axis, true); power > 0 && x + power + ui.px(100) <= end) {
    draw_power(f, axis, ImVec2(x, row.min.y + ui.px(4)), 32, true);
    x += power + ui.px(4);
  }
  const ImVec2 upper(x, row.min.y + ui.px(4)), lower(x, upper.y + small);
  draw_strip_state(f, axis, upper, end);
  draw_strip_limits(f, axis, ImVec2(x, lower.y - ui.px(2)));
  x += ui.px(strip_limits_width + 4);
  draw_at_work(f, axis, ImVec2(x, lower.y), std::max(0.0f, end - x), false);
}

}  // namespace hw::panels
