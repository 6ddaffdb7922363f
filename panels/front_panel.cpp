#include "panels/front_panel.h"

#include <algorithm>
#include <cmath>

#include "gui/surface/ui.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float inner = 12, caption_height = 20;

Tone tone_of(LampColour colour) {
  switch (colour) {
    case LampColour::green: return Tone::lamp_ok;
    case LampColour::yellow: return Tone::lamp_warn;
    case LampColour::red: break;
  }
  return Tone::fault;
}

int rows_of(const BenchFacts& facts, int supply) {
  int rows = 0;
  for (const BenchButton& button : facts.buttons)
    if (button.supply == supply) rows = std::max(rows, button.row + 1);
  return rows;
}

bool has_captions(const BenchFacts& facts, int supply, int row) {
  return std::any_of(facts.buttons.begin(), facts.buttons.end(), [&](const BenchButton& b) {
    return b.supply == supply && b.row == row && !b.caption.empty();
  });
}

/// Top of a row, logical, below the top of the first row. The row after the last gives the end of all rows.
float top_of_row(const BenchFacts& facts, int supply, int row) {
  float top = 0;
  for (int above = 0; above < row; ++above)
    top += 48 + (has_captions(facts, supply, above) ? caption_height : 0);
  return top;
}

/// A name without the name of its box, which the front panel shows: "Slave Run" becomes "Run".
std::string_view without(std::string_view owner, std::string_view name) {
  const bool sentence = !owner.empty() && name.size() > owner.size() && name.starts_with(owner);
  return sentence ? name.substr(owner.size() + 1) : name;
}

/// The maker's word before "front panel".
std::string_view first_word(std::string_view title) { return title.substr(0, title.find(' ')); }

}  // namespace

bool has_front_panel(const BenchFacts& facts, int supply) {
  const auto there = [supply](const auto& part) { return part.supply == supply; };
  return std::any_of(facts.buttons.begin(), facts.buttons.end(), there) ||
         std::any_of(facts.lamps.begin(), facts.lamps.end(), there);
}

Path path_of(std::string_view what, const BenchSupply& supply) {
  return Path("bench/{}{}{}", what, supply.name.empty() ? "" : "/", supply.name);
}

void FrontPanels::draw(Frame& f) {
  for (int i = 0; i < static_cast<int>(f.catalog.bench.supplies.size()); ++i)
    if (has_front_panel(f.catalog.bench, i)) draw_panel(f, i);
  release_forgotten(f);
}

void FrontPanels::draw_panel(Frame& f, int supply) {
  Ui& ui = f.ui;
  const BenchFacts& facts = f.catalog.bench;
  const BenchSupply& box = facts.supplies[static_cast<std::size_t>(supply)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float head = 56, breaker = 28;
  const float rows = top_of_row(facts, supply, rows_of(facts, supply));
  const float height = inner + head + rows - 8 + (box.breaker ? breaker : 0) + inner;
  const Rect r{at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(height))};
  draw_fill(ui, r, ui[Tone::well], 6);
  draw_outline(ui, r, ui[Tone::edge], 6);
  const float left = r.min.x + ui.px(inner), width = f.area.width - 2 * inner;
  draw_text_line(ui, left, r.max.x, r.min.y + ui.px(inner + 12), Face::title_bold, ui[Tone::ink],
                 box.name.empty() ? first_word(facts.panel_title) : std::string_view(box.name));
  draw_text_line(ui, left, r.max.x, r.min.y + ui.px(inner + 30), Face::small, ui[Tone::ink2], "front panel");
  draw_lamps(f, supply, ImVec2(r.min.x + ui.px(100), r.min.y + ui.px(inner)), 90);
  draw_power(f, supply, ImVec2(r.max.x - ui.px(inner + 40), r.min.y + ui.px(inner)));
  draw_buttons(f, supply, ImVec2(left, r.min.y + ui.px(inner + head)), width);
  if (box.breaker) draw_breaker(f, supply, ImVec2(left, r.min.y + ui.px(inner + head + rows - 4)), width);
  ImGui::SetCursorScreenPos(ImVec2(at.x, r.max.y));
  gap(ui, 8);
}

void FrontPanels::draw_lamps(Frame& f, int supply, ImVec2 corner, float width) {
  Ui& ui = f.ui;
  const BenchFacts& facts = f.catalog.bench;
  float y = corner.y;
  for (std::size_t i = 0; i < facts.lamps.size(); ++i) {
    const BenchLamp& info = facts.lamps[i];
    if (info.supply != supply) continue;
    const bool on = bit(f.bench.lamps, i);
    const Rect r{ImVec2(corner.x, y), ImVec2(corner.x + ui.px(width), y + ui.px(20))};
    draw_lamp(ui, ImVec2(r.min.x + ui.px(7), std::floor(r.centre().y)), 14, LampShape::round,
              on ? LampState::on : LampState::off, tone_of(info.colour));
    draw_text_line(ui, r.min.x + ui.px(20), r.max.x, r.centre().y, Face::small, ui[Tone::ink],
                   without(facts.supplies[static_cast<std::size_t>(supply)].name, info.name));
    const std::string_view value = bit(f.bench.lamps_blink, i) ? (on ? "blinking, on" : "blinking, off")
                                   : on                        ? "on"
                                                               : "off";
    show(ui, {Path("bench/lamp/{}", info.name), Kind::lamp, info.name, value, {}, false, value}, r);
    y += ui.px(20);
  }
}

void FrontPanels::draw_power(Frame& f, int supply, ImVec2 at) {
  Ui& ui = f.ui;
  const bool on = bit(f.bench.switches_on, static_cast<std::size_t>(supply));
  const BenchSupply& box = f.catalog.bench.supplies[static_cast<std::size_t>(supply)];
  ImGui::SetCursorScreenPos(at);
  const Touch t = touch(
      ui, {path_of("power", box), Kind::toggle, "Power switch", on ? "on" : "off", {}, false, "Power switch"},
      ui.px(40, 40));
  draw_fill(ui, t.rect, ui[t.hovered ? Tone::hover : Tone::raised]);
  draw_outline(ui, t.rect, ui[Tone::edge]);
  const float half = t.rect.height() / 2;
  Rect rocker{ImVec2(t.rect.min.x + ui.px(4), t.rect.min.y + ui.px(4)),
              ImVec2(t.rect.max.x - ui.px(4), t.rect.min.y + half)};
  Rect word{ImVec2(t.rect.min.x, t.rect.min.y + half), t.rect.max};
  if (!on) {
    rocker = {ImVec2(t.rect.min.x + ui.px(4), t.rect.min.y + half),
              ImVec2(t.rect.max.x - ui.px(4), t.rect.max.y - ui.px(4))};
    word = {t.rect.min, ImVec2(t.rect.max.x, t.rect.min.y + half)};
  }
  draw_fill(ui, rocker, ui[on ? Tone::ink2 : Tone::line], 2);
  draw_text_centred(ui, word, Face::small_bold, ui[on ? Tone::ink : Tone::ink3], on ? "on" : "off");
  draw_ring(ui, t);
  if (t.clicked) f.operate_bench(bench::Power(!on, supply));
}

void FrontPanels::draw_buttons(Frame& f, int supply, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const auto& buttons = f.catalog.bench.buttons;
  for (int row = 0; row < rows_of(f.catalog.bench, supply); ++row) {
    const auto here = [&](const BenchButton& b) { return b.supply == supply && b.row == row; };
    const auto in_row = std::count_if(buttons.begin(), buttons.end(), here);
    const float cell = (width - close_between * static_cast<float>(in_row - 1)) / static_cast<float>(in_row);
    const bool captions = has_captions(f.catalog.bench, supply, row);
    const float top = at.y + ui.px(top_of_row(f.catalog.bench, supply, row));
    std::string_view caption;
    float x = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
      if (!here(buttons[i])) continue;
      const float left = at.x + ui.px(std::floor(x));
      if (buttons[i].caption != caption) {
        caption = buttons[i].caption;
        draw_text(ui, ImVec2(left, top), Face::small, ui[Tone::ink2], caption);
      }
      ImGui::SetCursorScreenPos(ImVec2(left, top + ui.px(captions ? caption_height : 0)));
      // The widths are rounded so that the last button ends with the row.
      draw_button(f, i, std::floor(x + cell) - std::floor(x));
      x += cell + close_between;
    }
  }
}

void FrontPanels::draw_button(Frame& f, std::size_t i, float width) {
  const BenchButton& info = f.catalog.bench.buttons[i];
  HoldOptions o;
  o.width = width;
  o.height = 40;
  o.moving = false;
  o.stops = info.stops;
  o.lit = bit(f.bench.buttons, i);
  const BenchSupply& box = f.catalog.bench.supplies[static_cast<std::size_t>(info.supply)];
  const Hold hold =
      hold_button(f.ui, Path("bench/button/{}", info.name), with_minus(without(box.name, info.name)), o);
  if (hold.started) {
    pressed_ = info.name;
    f.operate_bench(bench::Button(info.name, true));
  }
  if (hold.ended && pressed_ == info.name) {
    pressed_.clear();
    f.operate_bench(bench::Button(info.name, false));
  }
}

/// A tripped breaker shows its white centre. The only manual action is to push it in.
void FrontPanels::draw_breaker(Frame& f, int supply, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const BenchSupply& box = f.catalog.bench.supplies[static_cast<std::size_t>(supply)];
  const bool out = bit(f.bench.breakers_out, static_cast<std::size_t>(supply));
  ImGui::SetCursorScreenPos(at);
  const Touch t = touch(
      ui,
      {path_of("breaker", box), Kind::button, "Circuit breaker", out ? "out" : "in",
       out ? "" : "The breaker is in.", false, "Push it in: the breaker has tripped, and there is no power."},
      ui.px(width, 32));
  if (t.hovered) draw_fill(ui, t.rect, ui[Tone::hover]);
  const ImVec2 centre(t.rect.min.x + ui.px(10), std::floor(t.rect.centre().y));
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_icon(list, Icon::ring, centre, ui.px(18), ui[Tone::edge]);
  if (out) list->AddCircleFilled(centre, ui.px(7), ui[Tone::ink2]);
  list->AddCircleFilled(centre, ui.px(out ? 6 : 4),
                        ui[out ? Tone::on_stop : Tone::edge]);  // a real breaker is white in both themes
  draw_text_line(ui, t.rect.min.x + ui.px(26), t.rect.max.x, centre.y, out ? Face::small_bold : Face::small,
                 ui[out ? Tone::warn : Tone::ink2], out ? "Breaker tripped. Push it in" : "Breaker in");
  draw_ring(ui, t);
  if (t.clicked) f.operate_bench(bench::Breaker(supply, false));
}

/// Releases the button when the window has lost the focus, or when the mouse was released while the panel was
/// not drawn.
void FrontPanels::release_forgotten(Frame& f) {
  if (pressed_.empty() || ImGui::IsMouseDown(0) || ImGui::IsAnyItemActive()) return;
  if (f.ui.focus.key_held(Path("bench/button/{}", pressed_))) return;
  f.operate_bench(bench::Button(pressed_, false));
  pressed_.clear();
}

}  // namespace hw::panels
