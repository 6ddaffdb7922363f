#include "panels/jog.h"

#include <algorithm>
#include <cmath>

#include "gui/area.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/text.h"
#include "panels/jog_button.h"
#include "panels/jog_units.h"
#include "panels/measures.h"
#include "panels/path.h"
#include "panels/power_switch.h"
#include "panels/unit_chooser.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float least_around_words = 10;

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

/// Each device of a bus, and each of many axes, has a row with its own two buttons.
bool jogs_in_rows(const Frame& f) {
  return f.tier == Tier::narrow ? f.tab.bus && f.catalog.axes.size() == 1
                                : f.tab.bus || f.catalog.axes.size() > 4;
}
bool in_pairs(const Frame& f) { return f.catalog.axes.size() > 4 && !jogs_in_rows(f); }
/// Speed in the line of the title, captions in that of the steps: what is done every day needs no scrolling.
bool close_together(const Frame& f) {
  return f.tier == Tier::medium || (f.tier == Tier::wide && (f.tab.bus || f.catalog.axes.size() > 2));
}

float cell_size(const Frame& f, float columns) {
  const float largest = f.tier == Tier::wide && f.catalog.axes.size() <= 3 ? 56.0f : 48.0f;
  return std::min(largest, std::floor((f.area.width + close_between) / columns) - close_between);
}

}  // namespace

void Jog::draw(Frame& f) {
  follow_unit(f);
  draw_title(f);
  draw_hint(f);
  origin_ = ImGui::GetCursorScreenPos();
  if (jogs_in_rows(f)) {
    constexpr float stop = 48;
    draw_stop(f, 0, 0, ImVec2(stop, stop));
    const float beside = f.area.width - stop - 12;
    const bool fits = spare_of(f, 0, beside) >= least_around_words;
    if (fits)
      draw_steps_row(f, stop + 12, (stop - 32) / 2, beside);
    else
      draw_steps_row(f, 0, stop + 8, f.area.width);
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(stop + 8 + (fits ? 0 : 40))));
  } else if (in_pairs(f)) {
    draw_pairs(f);
  } else {
    draw_cross(f);
  }
  if (!close_together(f)) speed_.draw(f, f.tier == Tier::wide);
  if (f.tier != Tier::narrow) group_line(f.ui, close_together(f) ? 4 : 8);
}

/// In a narrow window the strip of positions has no room for the unit: it stands here.
void Jog::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = close_together(f) ? 36 : 40;
  section_title(ui, "Jog", {}, height);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  if (close_together(f)) {
    constexpr float title = 40;
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(title), at.y + ui.px(2)));
    speed_.draw_line(f, f.area.width - title);
  } else if (f.tier == Tier::narrow) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - unit_chooser_width(f)), at.y + ui.px(4)));
    draw_unit_chooser(f);
  }
  ImGui::SetCursorScreenPos(after);
}

bool Jog::labels_fit(const Frame& f, float width) const {
  return std::all_of(steps_.begin(), steps_.end(), [&](const JogStep& step) {
    return text_width(f.ui, Face::body_bold, step.label) + f.ui.px(8) <= f.ui.px(width);
  });
}

// The pad does not move under the hand when there is a reason not to jog: its place is kept.
void Jog::draw_hint(Frame& f) {
  Ui& ui = f.ui;
  const std::string_view flaw = speed_.flaw();
  const std::uint32_t off = flaw.empty() && f.tab.why_not_move().empty() ? powerless_axes(f) : 0;
  const std::string_view why = !flaw.empty() ? flaw : off != 0 ? powerless_words(f, off) : f.tab.why_not_move();
  const bool keeps = f.tier != Tier::narrow;
  if (why.empty() && !keeps) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Path hint("Hold a button to move. A tap moves the chosen step{}{}.",
                  steps_unit_.name.empty() ? "" : ", in ", steps_unit_.name);
  const std::string_view words = why.empty() ? hint.view() : why;
  draw_icon(ImGui::GetWindowDrawList(), Icon::info, ImVec2(at.x + ui.px(6), at.y + ui.px(8)), ui.px(12),
            ui[why.empty() ? Tone::ink3 : Tone::ink2]);
  const Rect left = draw_power_switches(f, {at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(36))}, off);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(20), at.y));
  const Tone tone = !flaw.empty() ? Tone::fault : why.empty() ? Tone::ink3 : Tone::ink2;
  wrapped(ui, Face::small, tone, words, left.width() / ui.scale - 20);
  const float lines = f.tier == Tier::wide ? 2 : keeps ? 3 : 0;
  const float end = std::max(ImGui::GetItemRectMax().y, at.y + lines * ui.line(Face::small));
  ImGui::SetCursorScreenPos(ImVec2(at.x, end + ui.px(4)));
}

void Jog::draw_cross(Frame& f) {
  const std::size_t axes = f.catalog.axes.size();
  const bool flat = axes == 1, beside = axes == 2;
  const float columns = axes <= 2 ? 3 : static_cast<float>(axes) + 1;
  const float cell = cell_size(f, columns), pitch = cell + close_between;
  for (std::size_t i = 0; i < axes; ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const AxisId axis{static_cast<std::uint8_t>(i)};
      const Cell place = cell_of(axis, sign);
      draw_button(f, axis, sign, place.column * pitch, (flat ? 0 : place.row) * pitch, ImVec2(cell, cell));
    }
  draw_stop(f, pitch, flat ? 0 : pitch, ImVec2(cell, cell));
  const float height = flat ? cell : 3 * cell + 2 * close_between;
  if (beside) {
    const float x = columns * pitch + 12;
    draw_steps_column(f, x, std::min(f.area.width - x, 104.0f), height);
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 12)));
  } else {
    draw_steps_row(f, 0, height + 8, std::min(f.area.width, 304.0f));
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 8 + 40)));
  }
}

/// Many axes where their rows have no room for buttons: two beside each other for each.
void Jog::draw_pairs(Frame& f) {
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
  const float below = place(axes).y + row;
  draw_steps_row(f, 0, below, std::min(f.area.width, 304.0f));
  ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(below + 40)));
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
  const Touch t =
      touch(ui, {"jog/stop", Kind::button, "Stop", {}, {}, false, "Stops this controller", false, true},
            ui.px(size.x, size.y));
  if (t.hovered || t.held) draw_fill(ui, t.rect, ui[t.held ? Tone::sel : Tone::hover]);
  draw_outline(ui, t.rect, ui[Tone::fault]);
  const float middle = t.rect.centre().y;
  if (size.x > 1.5f * size.y) {  // beside each other
    const float words = text_width(ui, Face::body_bold, "Stop"),
                left = t.rect.centre().x - words / 2 + ui.px(8);
    draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
              ImVec2(std::floor(left - ui.px(14)), std::floor(middle)), ui.px(12), ui[Tone::fault]);
    draw_text_line(ui, std::floor(left), t.rect.max.x, middle, Face::body_bold, ui[Tone::fault], "Stop");
  } else {
    draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
              ImVec2(std::floor(t.rect.centre().x), std::floor(middle - ui.px(10))), ui.px(12),
              ui[Tone::fault]);
    draw_text_centred(ui, {ImVec2(t.rect.min.x, middle), ImVec2(t.rect.max.x, middle + ui.px(20))},
                      Face::body_bold, ui[Tone::fault], "Stop");
  }
  draw_ring(ui, t);
  if (t.started) f.tab.stop_all();  // on the press, not on the release
}

// ---- step

void Jog::follow_unit(Frame& f) {
  const DisplayUnit unit = common_unit(f);
  const int many = f.tier == Tier::wide || f.catalog.axes.size() != 2 ? 5 : 4;
  const auto chosen = [&](const JogStep& step) { return step.steps == f.tab.jog_step(); };
  const bool lit = std::any_of(steps_.begin(), steps_.end(), chosen);
  if (unit == steps_unit_ && many == steps_many_ && lit) return;
  steps_unit_ = unit;
  steps_many_ = many;
  steps_ = jog_steps(unit, 5);
  // Never drop the chosen one.
  if (many < 5) steps_.erase(chosen(steps_.back()) ? steps_.begin() + 1 : steps_.end() - 1);
  // A tap never moves what no button shows: what was chosen in another unit gives way to the least.
  if (std::none_of(steps_.begin(), steps_.end(), chosen))
    f.tab.choose_jog(steps_.front().steps, f.tab.jog_speed());
}

std::string_view Jog::label_of(const JogStep& step, int room) const {
  if (room >= 3 || (room >= 1 && &step == &steps_.back())) return step.label;  // one unit says it for all
  if (step.id != "step") return step.number;
  return room >= 2 ? std::string_view(step.label) : std::string_view("1 st.");
}

void Jog::draw_step(Frame& f, const JogStep& step, std::string_view label, float width) {
  ButtonOptions o;
  o.on = step.steps == f.tab.jog_step();
  o.width = width;
  o.tip = step.caption.empty() ? std::string_view("A tap moves this far.") : std::string_view(step.caption);
  if (button(f.ui, Path("jog/step/{}", step.id), label, o).clicked)
    f.tab.choose_jog(step.steps, f.tab.jog_speed());
}

void Jog::draw_steps_column(Frame& f, float x, float width, float height) {
  const float pitch = (height - 32) / static_cast<float>(steps_.size() - 1);
  const int room = labels_fit(f, width) ? 3 : 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(
        ImVec2(origin_.x + f.ui.px(x), origin_.y + f.ui.px(std::floor(pitch * static_cast<float>(i)))));
    draw_step(f, steps_[i], label_of(steps_[i], room), width);
  }
}

/// What the words of all steps leave of a row, for each.
float Jog::spare_of(const Frame& f, int room, float row) const {
  float used = 0;
  for (const JogStep& step : steps_)
    used += text_width(f.ui, Face::body_bold, label_of(step, room)) / f.ui.scale;
  const float n = static_cast<float>(steps_.size());
  return std::floor((row - close_between * (n - 1) - used) / n);
}

// It is shared out, so that the longest is not cut.
void Jog::draw_steps_row(Frame& f, float x, float y, float row) {
  Ui& ui = f.ui;
  int room = 3;
  while (room > 0 && spare_of(f, room, row) < least_around_words) --room;
  const float spare = spare_of(f, room, row);
  for (const JogStep& step : steps_) {
    const std::string_view label = label_of(step, room);
    const float width = std::floor(text_width(ui, Face::body_bold, label) / ui.scale + spare);
    ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
    draw_step(f, step, label, width);
    x += width + close_between;
  }
}

}  // namespace hw::panels
