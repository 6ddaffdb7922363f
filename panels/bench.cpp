#include "panels/bench.h"

#include <algorithm>

#include "gui/shell/console.h"
#include "gui/surface/ui.h"
#include "gui/widgets/area.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/bench_axes.h"
#include "panels/bench_scatter.h"
#include "panels/cells.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float cell_pitch = 36;

Touch on_off(Frame& f, std::string_view id, std::string_view name, bool on, float width, std::string_view tip,
             bool narrow = false) {
  ToggleOptions o;
  o.state = on ? ToggleState::on : ToggleState::off;
  o.width = width;
  o.tip = tip;
  o.narrow = narrow;
  return toggle_lamp(f.ui, id, name, o);
}

}  // namespace

void Bench::draw(Frame& f) {
  if (f.rail) return draw_rail(f);
  // In a narrow window the bench is a column among others and scrolls as a whole.
  const bool alone = f.tier != Tier::narrow, folded = f.area.height <= lower_right_title;
  draw_title(f, folded);
  if (folded) return;
  if (!alone) return draw_parts(f);
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(ImGui::GetWindowPos().x, at.y));
  begin_part(ui, "bench", ImGui::GetWindowWidth(), std::max(1.0f, ui.px(f.area.bottom()) - at.y), Tone::panel,
             16);
  draw_parts(f);
  end_part();
}

void Bench::draw_rail(Frame& f) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect r{at, ImVec2(at.x + f.ui.px(f.area.width), at.y + f.ui.px(40))};
  draw_text_centred(f.ui, {r.min, ImVec2(r.max.x, r.min.y + f.ui.px(16))}, Face::small_bold, f.ui[Tone::ink],
                    "Bench");
  draw_icon(ImGui::GetWindowDrawList(), Icon::emulated,
            ImVec2(std::floor(r.centre().x), r.min.y + f.ui.px(30)), f.ui.px(12), f.ui[Tone::emu]);
  show(f.ui, {"bench/emulated", Kind::text, "EMULATED", "EMULATED", {}, false, "EMULATED"}, r);
}

void Bench::draw_parts(Frame& f) {
  front_panels_.draw(f);
  draw_bench_axes(f);
  draw_switch_scatter(f);
  gap(f.ui, 8);
  draw_trouble(f);
  draw_inputs(f);
  gap(f.ui, 12);
}

/// The fold button is before the title, so that nothing else moves.
void Bench::draw_title(Frame& f, bool folded) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float words = 0;
  if (f.tier != Tier::narrow) {
    constexpr float fold_width = 32;
    ButtonOptions o;
    o.style = ButtonStyle::quiet;
    o.icon = folded ? Icon::chevron_right : Icon::chevron_down;
    o.width = fold_width;
    o.tip = folded ? "Open the bench" : "Fold the bench";
    ImGui::SetCursorScreenPos(ImVec2(at.x - ui.px(10), at.y + ui.px((lower_right_title - 32) / 2)));
    if (button(ui, "bench/fold", "", o).clicked) f.console.lower_right = folded ? Fold::open : Fold::folded;
    words = fold_width - 10;
  }
  draw_text_line(ui, at.x + ui.px(words), at.x + ui.px(f.area.width), at.y + ui.px(lower_right_title / 2),
                 Face::body_bold, ui[Tone::ink], "Bench");
  const float width = badge_width(ui, Icon::emulated, "EMULATED");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width) - width, at.y + ui.px(12)));
  emulated_badge(ui, "bench/emulated");
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(lower_right_title)));
}

// ---- faults of the whole device

void Bench::draw_trouble(Frame& f) {
  Ui& ui = f.ui;
  Cells cells(ui, f.area.width, 2, cell_pitch);
  cells.stand_at_next();
  if (on_off(f, "bench/unplug", "Unplug", f.bench.unplugged, cells.cell(),
             "Pulls the cable out of the computer.")
          .clicked)
    f.operate_bench(bench::Unplug(!f.bench.unplugged));
  ButtonOptions o;
  o.width = cells.cell();
  cells.stand_at_next();
  o.tip = "Off and on again: data that is only in RAM is lost.";
  if (button(ui, "bench/power_cycle", "Power off, on", o).clicked) f.operate_bench(bench::PowerCycle());
  cells.stand_at_next();
  o.tip = "Flips bits in the next 4 bytes from the controller.";
  if (button(ui, "bench/garble", "Garble 4 bytes", o).clicked) f.operate_bench(bench::Garble(4));
  cells.stand_at_next();
  o.tip = "The next 4 bytes from the controller never arrive.";
  if (button(ui, "bench/drop", "Drop 4 bytes", o).clicked) f.operate_bench(bench::Drop(4));
  draw_supplies(f, cells);
  cells.end();
}

void Bench::draw_supplies(Frame& f, Cells& cells) {
  const auto& supplies = f.catalog.bench.supplies;
  for (int i = 0; i < static_cast<int>(supplies.size()); ++i) {
    const BenchSupply& box = supplies[static_cast<std::size_t>(i)];
    const bool on = bit(f.bench.switches_on, static_cast<std::size_t>(i));
    if (!has_front_panel(f.catalog.bench, i)) {
      cells.stand_at_next();
      if (on_off(f, path_of("power", box), "Power", on, cells.cell(), "The power supply of this controller.")
              .clicked)
        f.operate_bench(bench::Power(!on, i));
    }
    if (!box.breaker) continue;
    cells.stand_at_next();
    ButtonOptions o;
    o.width = cells.cell();
    o.tip = "Trips the circuit breaker: the power goes off.";
    o.disabled = bit(f.bench.breakers_out, static_cast<std::size_t>(i))
                     ? "Push the breaker in first: it has tripped."
                     : "";
    const Path name = box.name.empty() ? Path("Trip breaker") : Path("{} breaker", box.name);
    if (button(f.ui, path_of("trip", box), name, o).clicked) f.operate_bench(bench::Breaker(i, true));
  }
}

// ---- manual signals

void Bench::draw_inputs(Frame& f) {
  const std::span<const InputInfo> inputs(f.catalog.inputs);
  if (inputs.empty() && f.catalog.analog.empty()) return;
  section_title(f.ui, "Signals by hand", {}, 32);
  constexpr float lamp_width = 19, lamp_and_word = 60;
  int columns = inputs.size() % 4 != 0 && inputs.size() % 3 == 0 ? 3 : 4;  // avoids a row that is half empty
  while (columns > 2 && !fit_in_cells(f.ui, f.area.width, columns, inputs, lamp_width)) --columns;
  const bool narrow = columns > 2 || !fit_in_cells(f.ui, f.area.width, columns, inputs, lamp_and_word);
  Cells cells(f.ui, f.area.width, columns, cell_pitch);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool operated = bit(f.bench.inputs_operated, i);
    cells.stand_at_next();
    if (on_off(f, Path("bench/in/{}", f.catalog.input_number(i)), with_minus(inputs[i].name), operated,
               cells.cell(), inputs[i].help, narrow)
            .clicked)
      f.operate_bench(bench::Input(static_cast<int>(i) + 1, !operated));
  }
  cells.end();
  for (int n = 1; n <= static_cast<int>(f.catalog.analog.size()); ++n) draw_analog(f, n);
}

void Bench::draw_analog(Frame& f, int n) {
  Ui& ui = f.ui;
  constexpr float name_width = 64, words_width = 84, row = 36;
  const AnalogInfo& info = f.catalog.analog[static_cast<std::size_t>(n - 1)];
  const std::int32_t now = f.bench.analog[static_cast<std::size_t>(n - 1)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(16), Face::body, ui[Tone::ink], info.name);
  const Path words("{} {}", now, info.unit);
  draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(8)), Face::small, ui[Tone::ink2],
                  words);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width), at.y));
  SliderOptions o;
  o.min = info.minimum;
  o.max = info.maximum;
  o.step = 1;
  o.value_text = words;
  o.width = f.area.width - name_width - words_width;
  double value = now;
  if (slider(ui, Path("bench/analog/{}", n), info.name, value, o))
    f.operate_bench(bench::Analog(n, static_cast<std::int32_t>(value)));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(row)));
}

}  // namespace hw::panels
