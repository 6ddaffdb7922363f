#include "panels/bench.h"

#include <algorithm>

#include "gui/surface/ui.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

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
  front_panels_.draw(f);
  draw_trouble(f);
  draw_axes(f);
  draw_inputs(f);
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
    if (button(ui, path_of("trip", box),
               box.name.empty() ? Path("Trip breaker") : Path("{} breaker", box.name), o)
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
