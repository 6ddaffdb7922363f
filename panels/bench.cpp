#include "panels/bench.h"

#include <algorithm>

#include "gui/ui.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float inner = 12, between = 4;

bool bit(std::uint32_t bits, std::size_t n) { return (bits >> n) & 1u; }
std::string_view sign_text(Sign sign) { return sign == Sign::plus ? "+" : "\u2212"; }

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

/// It has something to press or to see beside its switch.
bool has_front_panel(const BenchFacts& facts, int supply) {
  const auto there = [supply](const auto& part) { return part.supply == supply; };
  return std::any_of(facts.buttons.begin(), facts.buttons.end(), there) ||
         std::any_of(facts.lamps.begin(), facts.lamps.end(), there);
}

/// The path of something that each supply has: "bench/power", of a second box "bench/power/Slave".
Path path_of(std::string_view what, const BenchSupply& supply) {
  return Path("bench/{}{}{}", what, supply.name.empty() ? "" : "/", supply.name);
}

/// On the front panel of a second box its own name need not be said again: "Slave Run" is "Run" there.
std::string_view without(std::string_view owner, std::string_view name) {
  const bool said = !owner.empty() && name.size() > owner.size() && name.starts_with(owner);
  return said ? name.substr(owner.size() + 1) : name;
}

/// The maker's word before "front panel".
std::string_view first_word(std::string_view title) { return title.substr(0, title.find(' ')); }

Touch on_off(Frame& f, std::string_view id, std::string_view name, bool on, float width,
             std::string_view tip = {}) {
  ToggleOptions o;
  o.state = on ? ToggleState::on : ToggleState::off;
  o.width = width;
  o.tip = tip;
  return toggle_lamp(f.ui, id, name, o);
}

/// Two cells a row.
class Grid {
 public:
  Grid(Ui& ui, float width) : ui_(ui), cell_((width - 8) / 2), at_(ImGui::GetCursorScreenPos()) {}
  void next() {
    const auto column = static_cast<float>(n_ % 2), row = static_cast<float>(n_ / 2);
    ImGui::SetCursorScreenPos(ImVec2(at_.x + ui_.px(column * (cell_ + 8)), at_.y + ui_.px(row * 40)));
    ++n_;
  }
  void end() {
    ImGui::SetCursorScreenPos(ImVec2(at_.x, at_.y + ui_.px(static_cast<float>((n_ + 1) / 2) * 40)));
  }
  [[nodiscard]] float cell() const { return cell_; }

 private:
  Ui& ui_;
  float cell_;
  ImVec2 at_;
  int n_ = 0;
};

}  // namespace

void Bench::draw(Frame& f) {
  if (f.rail) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect r{at, ImVec2(at.x + f.ui.px(f.area.width), at.y + f.ui.px(40))};
    draw_text_centred(f.ui, {r.min, ImVec2(r.max.x, r.min.y + f.ui.px(16))}, Face::small_bold,
                      f.ui[Tone::ink], "Bench");
    draw_icon(ImGui::GetWindowDrawList(), Icon::emulated,
              ImVec2(std::floor(r.centre().x), r.min.y + f.ui.px(30)), f.ui.px(12), f.ui[Tone::emu]);
    show(f.ui, {"bench/emulated", Kind::text, "EMULATED", "EMULATED", {}, false, "EMULATED"}, r);
    return;
  }
  draw_title(f);
  for (int i = 0; i < static_cast<int>(f.catalog.bench.supplies.size()); ++i)
    if (has_front_panel(f.catalog.bench, i)) draw_front_panel(f, i);
  draw_trouble(f);
  draw_axes(f);
  draw_inputs(f);
  release_forgotten(f);
  gap(f.ui, 12);
}

void Bench::draw_title(Frame& f) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(f.ui, "Bench", {}, 44);
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const float width = badge_width(f.ui, Icon::emulated, "EMULATED");
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(f.area.width) - width, at.y + f.ui.px(12)));
  emulated_badge(f.ui, "bench/emulated");
  ImGui::SetCursorScreenPos(after);
}

// ---- front panel

void Bench::draw_front_panel(Frame& f, int supply) {
  Ui& ui = f.ui;
  const BenchFacts& facts = f.catalog.bench;
  const BenchSupply& box = facts.supplies[static_cast<std::size_t>(supply)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float head = 56, row = 48, breaker = 28;
  const float rows = row * static_cast<float>(rows_of(facts, supply));
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

void Bench::draw_lamps(Frame& f, int supply, ImVec2 corner, float width) {
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

void Bench::draw_power(Frame& f, int supply, ImVec2 at) {
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

void Bench::draw_buttons(Frame& f, int supply, ImVec2 at, float width) {
  const auto& buttons = f.catalog.bench.buttons;
  for (int row = 0; row < rows_of(f.catalog.bench, supply); ++row) {
    const auto here = [&](const BenchButton& b) { return b.supply == supply && b.row == row; };
    const auto in_row = std::count_if(buttons.begin(), buttons.end(), here);
    const float cell = (width - between * static_cast<float>(in_row - 1)) / static_cast<float>(in_row);
    float x = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
      if (!here(buttons[i])) continue;
      ImGui::SetCursorScreenPos(
          ImVec2(at.x + f.ui.px(std::floor(x)), at.y + f.ui.px(static_cast<float>(row) * 48)));
      // So wide that the last ends where the row ends.
      draw_button(f, i, std::floor(x + cell) - std::floor(x));
      x += cell + between;
    }
  }
}

void Bench::draw_button(Frame& f, std::size_t i, float width) {
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

/// Its white centre stands out when it has tripped; pushing it in is all that a hand can do to it.
void Bench::draw_breaker(Frame& f, int supply, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const BenchSupply& box = f.catalog.bench.supplies[static_cast<std::size_t>(supply)];
  const bool out = bit(f.bench.breakers_out, static_cast<std::size_t>(supply));
  ImGui::SetCursorScreenPos(at);
  const Touch t = touch(ui,
                        {path_of("breaker", box), Kind::button, "Circuit breaker", out ? "out" : "in",
                         out ? "" : "The breaker is in.", false, "It has tripped: no power. Push it in."},
                        ui.px(width, 32));
  if (t.hovered) draw_fill(ui, t.rect, ui[Tone::hover]);
  const ImVec2 centre(t.rect.min.x + ui.px(10), std::floor(t.rect.centre().y));
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_icon(list, Icon::ring, centre, ui.px(18), ui[Tone::edge]);
  list->AddCircleFilled(centre, ui.px(out ? 6 : 4), ui[out ? Tone::ink : Tone::edge]);
  draw_text_line(ui, t.rect.min.x + ui.px(26), t.rect.max.x, centre.y, out ? Face::small_bold : Face::small,
                 ui[out ? Tone::warn : Tone::ink2], out ? "Breaker tripped. Push it in" : "Breaker in");
  draw_ring(ui, t);
  if (t.clicked) f.operate_bench(bench::Breaker(supply, false));
}

/// The window lost the focus, or the panel was not drawn when the hand let go.
void Bench::release_forgotten(Frame& f) {
  if (pressed_.empty() || ImGui::IsMouseDown(0) || ImGui::IsAnyItemActive()) return;
  if (f.ui.focus.key_held(Path("bench/button/{}", pressed_))) return;
  f.operate_bench(bench::Button(pressed_, false));
  pressed_.clear();
}

// ---- trouble

void Bench::draw_trouble(Frame& f) {
  Ui& ui = f.ui;
  section_title(ui, "Make trouble", {}, 32);
  Grid grid(ui, f.area.width);
  grid.next();
  if (on_off(f, "bench/unplug", "Unplug", f.bench.unplugged, grid.cell(),
             "Pulls the cable out of the computer.")
          .clicked)
    f.operate_bench(bench::Unplug(!f.bench.unplugged));
  ButtonOptions o;
  o.width = grid.cell();
  grid.next();
  o.tip = "Flips bits in the next 4 bytes from the controller.";
  if (button(ui, "bench/garble", "Garble 4 bytes", o).clicked) f.operate_bench(bench::Garble(4));
  grid.next();
  o.tip = "The next 4 bytes from the controller never arrive.";
  if (button(ui, "bench/drop", "Drop 4 bytes", o).clicked) f.operate_bench(bench::Drop(4));
  grid.next();
  o.tip = "Off, and on again: what is in RAM only is gone.";
  if (button(ui, "bench/power_cycle", "Power off, on", o).clicked) f.operate_bench(bench::PowerCycle());
  const auto& supplies = f.catalog.bench.supplies;
  for (int i = 0; i < static_cast<int>(supplies.size()); ++i) {
    const BenchSupply& box = supplies[static_cast<std::size_t>(i)];
    const bool on = bit(f.bench.switches_on, static_cast<std::size_t>(i));
    if (!has_front_panel(f.catalog.bench, i)) {
      grid.next();
      if (on_off(f, path_of("power", box), "Power", on, grid.cell(), "The supply of this controller.")
              .clicked)
        f.operate_bench(bench::Power(!on, i));
    }
    if (!box.breaker) continue;
    grid.next();
    o.tip = "Too much current: the circuit breaker pops out and takes the power away.";
    o.disabled =
        bit(f.bench.breakers_out, static_cast<std::size_t>(i)) ? "It has tripped. Push it in first." : "";
    if (button(ui, path_of("trip", box), Path("Trip {}{}breaker", box.name, box.name.empty() ? "" : " "), o)
            .clicked)
      f.operate_bench(bench::Breaker(i, true));
  }
  grid.end();
}

void Bench::draw_axes(Frame& f) {
  Grid grid(f.ui, f.area.width);
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    const std::string& name = f.catalog.axes[i].name;
    const bool jammed = bit(f.bench.jammed, i);
    grid.next();
    if (on_off(f, Path("bench/jam/{}", name), Path("Jam {}", name), jammed, grid.cell(),
               "The load cannot move.")
            .clicked)
      f.operate_bench(bench::Jam(axis, !jammed));
  }
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    const std::string& name = f.catalog.axes[i].name;
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const bool by_hand =
          bit(sign == Sign::minus ? f.bench.limits_minus_by_hand : f.bench.limits_plus_by_hand, i);
      grid.next();
      if (on_off(f, Path("bench/limit/{}/{}", name, letter(sign)), Path("Hit {}{}", name, sign_text(sign)),
                 by_hand, grid.cell(), "Presses the limit switch by hand.")
              .clicked)
        f.operate_bench(bench::Limit(axis, sign, !by_hand));
    }
  }
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    const std::string& name = f.catalog.axes[i].name;
    const bool home = bit(f.bench.homes_by_hand, i);
    grid.next();
    if (on_off(f, Path("bench/home/{}", name), Path("Home {}", name), home, grid.cell(),
               "Presses the home switch by hand.")
            .clicked)
      f.operate_bench(bench::HomeSwitch(axis, !home));
    grid.next();
    ButtonOptions o;
    o.width = grid.cell();
    o.tip = "The load jumps by 100 without the controller knowing. An encoder sees it.";
    if (button(f.ui, Path("bench/slip/{}", name), Path("Slip {} by 100", name), o).clicked)
      f.operate_bench(bench::Slip(axis, Steps(100)));
    if (!f.catalog.axes[i].alarm_input) continue;
    const bool alarm = bit(f.bench.alarms, i);
    grid.next();
    if (on_off(f, Path("bench/alarm/{}", name), Path("Alarm {}", name), alarm, grid.cell(),
               "The alarm input of the axis, as its motor's driver would raise it.")
            .clicked)
      f.operate_bench(bench::Alarm(axis, !alarm));
  }
  grid.end();
}

void Bench::draw_inputs(Frame& f) {
  Ui& ui = f.ui;
  if (f.catalog.inputs.empty() && f.catalog.analog.empty()) return;
  section_title(ui, "Signals by hand", {}, 32);
  Grid grid(ui, f.area.width);
  for (int n = 1; n <= static_cast<int>(f.catalog.inputs.size()); ++n) {
    const InputInfo& info = f.catalog.inputs[static_cast<std::size_t>(n - 1)];
    const bool operated = bit(f.bench.inputs_operated, static_cast<std::size_t>(n - 1));
    grid.next();
    if (on_off(f, Path("bench/in/{}", f.catalog.input_number(static_cast<std::size_t>(n - 1))),
               with_minus(info.name), operated, grid.cell(), info.help)
            .clicked)
      f.operate_bench(bench::Input(n, !operated));
  }
  grid.end();
  for (int n = 1; n <= static_cast<int>(f.catalog.analog.size()); ++n) {
    const AnalogInfo& info = f.catalog.analog[static_cast<std::size_t>(n - 1)];
    const std::int32_t now = f.bench.analog[static_cast<std::size_t>(n - 1)];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text_line(ui, at.x, at.x + ui.px(64), at.y + ui.px(16), Face::body, ui[Tone::ink], info.name);
    const Path words("{} {}", now, info.unit);
    draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(8)), Face::small, ui[Tone::ink2],
                    words);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(64), at.y));
    SliderOptions o;
    o.min = info.minimum;
    o.max = info.maximum;
    o.step = 1;
    o.value_text = words;
    o.width = f.area.width - 64 - 84;
    double value = now;
    if (slider(ui, Path("bench/analog/{}", n), info.name, value, o))
      f.operate_bench(bench::Analog(n, static_cast<std::int32_t>(value)));
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
  }
}

}  // namespace hw::panels
