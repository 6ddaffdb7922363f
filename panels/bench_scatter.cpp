#include "panels/bench_scatter.h"

#include <algorithm>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr std::int64_t widest = 50;  // scripts and bench files may exceed it

void let_switches_scatter(Tab& of, Steps by) {
  AxisPlace place;
  place.scatter = by;
  for (std::size_t i = 0; i < of.catalog().axes.size(); ++i)
    of.operate_bench(bench::Place(AxisId{static_cast<std::uint8_t>(i)}, place));
}

void let_all_scatter(const Frame& f, Steps by) {
  if (!f.tab.bus) return let_switches_scatter(f.tab, by);
  for (Tab* each : f.tab.bus->members)
    if (each->bench().present) let_switches_scatter(*each, by);
}

}  // namespace

void draw_switch_scatter(Frame& f) {
  Ui& ui = f.ui;
  constexpr float name_width = 112, words_width = 68, row = 36;
  const std::int64_t now = f.bench.switches[0].scatter.value;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(row / 2), Face::body, ui[Tone::ink],
                 "Switch scatter");
  const Path words = now == 0 ? Path("none") : Path("up to {}", now);
  draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(10)), Face::small, ui[Tone::ink2],
                  words);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width), at.y + ui.px(2)));
  SliderOptions o;
  o.max = widest;
  o.step = 1;
  o.value_text = words;
  o.width = f.area.width - name_width - words_width;
  o.tip = "Each limit and home switch acts up to this many steps before or after its position, at random.";
  double value = static_cast<double>(std::min(now, widest));
  if (slider(ui, "bench/scatter", "Switch scatter", value, o))
    let_all_scatter(f, Steps(static_cast<std::int64_t>(value)));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(row)));
}

}  // namespace hw::panels
