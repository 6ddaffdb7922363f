#include "panels/jog.h"

#include <algorithm>
#include <cmath>

#include "gui/area.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/jog_button.h"
#include "panels/path.h"
#include "panels/unit_chooser.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float between = 4;
constexpr std::string_view minus_sign = "\u2212";

struct Cell {
  float column, row;
  Icon icon;
};
/// A cross for the first two axes; the third and fourth stand as columns beside it.
Cell cell_of(AxisId axis, Sign sign) {
  const bool plus = sign == Sign::plus;
  if (axis.index == 0) return {plus ? 2.0f : 0.0f, 1, plus ? Icon::play : Icon::back};
  const float column = axis.index == 1 ? 1.0f : static_cast<float>(axis.index) + 1;
  return {column, plus ? 0.0f : 2.0f, plus ? Icon::up : Icon::down};
}

/// On a bus of one-axis controllers each row has its own two buttons.
bool jogs_in_rows(const Frame& f) { return f.tab.bus && f.catalog.axes.size() == 1; }

}  // namespace

void Jog::draw(Frame& f) {
  const std::size_t axes = f.catalog.axes.size();
  const float columns = axes <= 2 ? 3 : static_cast<float>(axes) + 1;
  const float largest = f.tier == Tier::wide && axes <= 3 ? 56.0f : 48.0f;
  const float cell = std::min(largest, std::floor((f.area.width + between) / columns) - between);
  const float height = axes == 1 ? cell : 3 * cell + 2 * between;
  const float x = columns * (cell + between) + 12;
  const bool beside = axes == 2;
  follow_unit(f);
  const float width = std::min(f.area.width - x, 104.0f);
  short_labels_ = !beside || !labels_fit(f, width);
  draw_title(f, beside);
  draw_reason(f);
  origin_ = ImGui::GetCursorScreenPos();
  draw_pad(f, cell);
  if (beside) {
    draw_steps_column(f, x, width, height);
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 12)));
  } else {
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 8)));
    draw_steps_row(f);
  }
  draw_speed(f);
  if (f.tier != Tier::narrow) group_line(f.ui, 8);
}

/// In a narrow window the strip of positions has no room for the unit: it stands here.
void Jog::draw_title(Frame& f, bool steps_beside) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Path caption("a tap, in {}", steps_unit_.name);
  const bool captioned = steps_beside && short_labels_ && f.tier != Tier::narrow;
  section_title(ui, "Jog", captioned ? caption.view() : std::string_view(), 40);
  if (f.tier != Tier::narrow) return;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - unit_chooser_width(f)), at.y + ui.px(4)));
  draw_unit_chooser(f);
  ImGui::SetCursorScreenPos(after);
}

bool Jog::labels_fit(const Frame& f, float width) const {
  return std::all_of(steps_.begin(), steps_.end(), [&](const JogStep& step) {
    return text_width(f.ui, Face::body_bold, step.label) + f.ui.px(8) <= f.ui.px(width);
  });
}

void Jog::draw_reason(Frame& f) {
  const std::string_view why = f.tab.why_not_move();
  if (why.empty()) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_icon(ImGui::GetWindowDrawList(), Icon::info, ImVec2(at.x + f.ui.px(6), at.y + f.ui.px(8)), f.ui.px(12),
            f.ui[Tone::ink2]);
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(20), at.y));
  wrapped(f.ui, Face::small, Tone::ink2, why, f.area.width - 20);
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y));
  gap(f.ui, 4);
}

void Jog::draw_pad(Frame& f, float cell) {
  if (jogs_in_rows(f)) return draw_stop(f, 0, 0, cell);
  const bool flat = f.catalog.axes.size() == 1;
  for (std::size_t i = 0; i < std::min<std::size_t>(f.catalog.axes.size(), 4); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const AxisId axis{static_cast<std::uint8_t>(i)};
      const Cell place = cell_of(axis, sign);
      draw_button(f, axis, sign, place.column * (cell + between), (flat ? 0 : place.row) * (cell + between),
                  cell);
    }
  draw_stop(f, cell + between, flat ? 0 : cell + between, cell);
}

void Jog::draw_button(Frame& f, AxisId axis, Sign sign, float x, float y, float cell) {
  Ui& ui = f.ui;
  HoldOptions o;
  o.icon = cell_of(axis, sign).icon;
  o.width = o.height = cell;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const std::string_view name = f.catalog.axes[axis.index].name;
  draw_jog_button(ui, f.tab, axis, sign,
                  Path("{}{}", name, sign == Sign::plus ? std::string_view("+") : minus_sign), o);
}

void Jog::draw_stop(Frame& f, float x, float y, float cell) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const Touch t = touch(ui, {"jog/stop", Kind::button, "Stop", {}, {}, false, "Stops this controller"},
                        ui.px(cell, cell));
  if (t.hovered || t.held) draw_fill(ui, t.rect, ui[t.held ? Tone::sel : Tone::hover]);
  draw_outline(ui, t.rect, ui[Tone::fault]);
  const float middle = t.rect.centre().y;
  draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
            ImVec2(std::floor(t.rect.centre().x), std::floor(middle - ui.px(10))), ui.px(12),
            ui[Tone::fault]);
  draw_text_centred(ui, {ImVec2(t.rect.min.x, middle), ImVec2(t.rect.max.x, middle + ui.px(20))},
                    Face::body_bold, ui[Tone::fault], "Stop");
  draw_ring(ui, t);
  if (t.started) f.tab.stop_all();  // on the press, not on the release
}

// ---- step

void Jog::follow_unit(Frame& f) {
  const DisplayUnit& unit = f.tab.unit(AxisId{0});
  const int many = f.tier == Tier::wide || f.catalog.axes.size() != 2 ? 5 : 4;
  if (unit == steps_unit_ && many == steps_many_ && !steps_.empty()) return;
  steps_unit_ = unit;
  steps_many_ = many;
  steps_ = jog_steps(unit, 5);
  if (many == 5) return;
  // Never drop the chosen one.
  const bool last_chosen = steps_.back().steps == f.tab.jog_step();
  steps_.erase(last_chosen ? steps_.begin() + 1 : steps_.end() - 1);
}

std::string_view Jog::label_of(const JogStep& step) const {
  if (!short_labels_) return step.label;
  return step.id == "step" ? std::string_view("1 st.") : std::string_view(step.number);
}

void Jog::draw_step(Frame& f, const JogStep& step, float width) {
  ButtonOptions o;
  o.on = step.steps == f.tab.jog_step();
  o.width = width;
  o.tip = step.caption.empty() ? std::string_view("A tap moves this far.") : std::string_view(step.caption);
  if (button(f.ui, Path("jog/step/{}", step.id), label_of(step), o).clicked) {
    f.tab.profile.jog_step = step.steps;
    f.tab.profile_edited();
  }
}

void Jog::draw_steps_column(Frame& f, float x, float width, float height) {
  const float pitch = (height - 32) / static_cast<float>(steps_.size() - 1);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(
        ImVec2(origin_.x + f.ui.px(x), origin_.y + f.ui.px(std::floor(pitch * static_cast<float>(i)))));
    draw_step(f, steps_[i], width);
  }
}

void Jog::draw_steps_row(Frame& f) {
  Ui& ui = f.ui;
  text(ui, Face::small, Tone::ink2, Path("A tap moves, in {}", steps_unit_.name));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto words = [&](const JogStep& step) {
    return text_width(ui, Face::body_bold, label_of(step)) / ui.scale;
  };
  float used = 0;
  for (const JogStep& step : steps_) used += words(step);
  // What the words leave is shared out, so that the longest is not cut.
  const float n = static_cast<float>(steps_.size()), row = std::min(f.area.width, 304.0f);
  const float around = std::floor((row - between * (n - 1) - used) / n);
  float x = 0;
  for (const JogStep& step : steps_) {
    const float width = std::floor(words(step) + around);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(x), at.y));
    draw_step(f, step, width);
    x += width + between;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
}

// ---- speed

void Jog::draw_speed(Frame& f) {
  Ui& ui = f.ui;
  const bool own = f.tab.jog_speed().value <= 0;
  const double now = own ? f.catalog.jog_speed.value : f.tab.jog_speed().value;
  const NumberText words = format_speed(Pps(now), f.tab.unit(AxisId{0}));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  SliderOptions o;
  o.min = std::max(1.0, f.catalog.jog_speed_min.value);
  o.max = f.catalog.jog_speed_max.value;
  o.step = 1;
  o.logarithmic = true;
  o.normal = f.catalog.jog_speed.value;
  o.tip = own ? "Speed while held: the controller's own. Drag to choose another."
              : "Speed while held. A double click goes back to the controller's own.";
  o.value_text = words;
  o.width = f.area.width;
  float y = at.y;
  if (f.tier == Tier::wide) {
    draw_text(ui, at, Face::body, ui[Tone::ink2], own ? "Speed, the controller's" : "Speed while held");
    draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y), Face::body_bold, ui[Tone::ink], words);
    y += ui.px(22);
  } else {  // one line: the slider, and how fast that is
    const float right = std::ceil(text_width(ui, Face::body_bold, words));
    draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(6)), Face::body_bold, ui[Tone::ink],
                    words);
    o.width -= std::max(84.0f, std::ceil(right / ui.scale)) + 8;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
  double speed = now;
  if (slider(ui, "jog/speed", "Speed while held", speed, o)) {
    const double chosen = std::round(speed);
    f.tab.profile.jog_speed = Pps(chosen == f.catalog.jog_speed.value ? 0 : chosen);
    f.tab.profile_edited();
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, y + ui.px(36)));
}

}  // namespace hw::panels
