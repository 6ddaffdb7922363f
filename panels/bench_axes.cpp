#include "panels/bench_axes.h"

#include <algorithm>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/front_panel.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float names_height = 20, bench_row = 32, slip_width = 44;

/// Columns of a row: logical pixels from its left.
struct BenchColumns {
  float name, sign_cell, word_cell, slip;
};

bool has_alarm(const Catalog& c) {
  return std::any_of(c.axes.begin(), c.axes.end(), [](const AxisInfo& axis) { return axis.alarm_input; });
}

/// The columns for this frame. A word in the titles is wider than an icon.
BenchColumns columns_in(const Frame& f, bool alarm) {
  constexpr float word_is_wider = 8;
  float name = 0;
  for (const AxisInfo& axis : f.catalog.axes)
    name = std::max(name, text_width(f.ui, Face::body_bold, axis.name) / f.ui.scale);
  name = std::max(24.0f, std::ceil(name) + 6);
  const float words = alarm ? 2 : 1, cells = 3 + words;
  const float sign_cell = std::floor((f.area.width - name - slip_width - words * word_is_wider) / cells);
  return {name, std::min(sign_cell, 44.0f), std::min(sign_cell, 44.0f) + word_is_wider,
          f.area.width - slip_width};
}

void draw_titles(Frame& f, const BenchColumns& columns, bool alarm) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = columns.name;
  const auto title = [&](std::string_view words, float width) {
    draw_text_centred(
        ui, {ImVec2(at.x + ui.px(x), at.y), ImVec2(at.x + ui.px(x + width), at.y + ui.px(names_height))},
        Face::small, ui[Tone::ink2], words);
    x += width;
  };
  title("jam", columns.sign_cell);
  title(sign_text(Sign::minus), columns.sign_cell);
  title(sign_text(Sign::plus), columns.sign_cell);
  title("home", columns.word_cell);
  if (alarm) title("alarm", columns.word_cell);
  x = columns.slip;
  title("slip", slip_width);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(names_height)));
}

/// The row of an axis of a controller.
class BenchRow {
 public:
  BenchRow(Frame& f, Tab& of, std::size_t axis, const BenchColumns& columns)
      : f_(f),
        of_(of),
        at_(axis),
        columns_(columns),
        name_(of.catalog().axes[axis].name),
        top_left_(ImGui::GetCursorScreenPos()) {}

  void draw() {
    Ui& ui = f_.ui;
    const float end = top_left_.x + ui.px(f_.area.width);
    ImGui::GetWindowDrawList()->AddRectFilled(top_left_, ImVec2(end, top_left_.y + ui.hair()),
                                              ui[Tone::line]);
    draw_text_line(ui, top_left_.x, end, top_left_.y + ui.px(bench_row / 2), Face::body_bold, ui[Tone::ink],
                   name_);
    const AxisId id{static_cast<std::uint8_t>(at_)};
    const BenchView& bench = of_.bench();
    toggle(Path("bench/jam/{}", name_), "Jam", "the load cannot move.", bench.jammed, columns_.sign_cell,
           [&](bool on) { return bench::Jam(id, on); });
    toggle(Path("bench/limit/{}/-", name_), "Hit the − limit of", "its switch is pressed by hand.",
           bench.limits_minus_by_hand, columns_.sign_cell,
           [&](bool on) { return bench::Limit(id, Sign::minus, on); });
    toggle(Path("bench/limit/{}/+", name_), "Hit the + limit of", "its switch is pressed by hand.",
           bench.limits_plus_by_hand, columns_.sign_cell,
           [&](bool on) { return bench::Limit(id, Sign::plus, on); });
    toggle(Path("bench/home/{}", name_), "Home switch of", "it is pressed by hand.", bench.homes_by_hand,
           columns_.word_cell, [&](bool on) { return bench::HomeSwitch(id, on); });
    if (of_.catalog().axes[at_].alarm_input)
      toggle(Path("bench/alarm/{}", name_), "Alarm of",
             "the alarm input is on, as the motor's driver would set it.", bench.alarms, columns_.word_cell,
             [&](bool on) { return bench::Alarm(id, on); });
    draw_slip(id);
    ImGui::SetCursorScreenPos(ImVec2(top_left_.x, top_left_.y + ui.px(bench_row)));
  }

 private:
  template <class Command>
  void toggle(std::string_view id, std::string_view what, std::string_view effect, std::uint32_t bits,
              float width, Command command) {
    const Path name("{} {}", what, name_), tip("{} {}: {}", what, name_, effect);
    ImGui::SetCursorScreenPos(ImVec2(top_left_.x + f_.ui.px(columns_.name + x_), top_left_.y));
    x_ += width;
    const bool on = bit(bits, at_);
    if (toggle_cell(f_.ui, id, name, on, width, tip).clicked) of_.operate_bench(command(!on));
  }

  void draw_slip(AxisId id) {
    ButtonOptions o;
    o.width = slip_width;
    o.height = 28;
    const Path tip("Moves the load of {} by 100 without a motor step. Only an encoder shows it.", name_);
    o.tip = tip;
    ImGui::SetCursorScreenPos(
        ImVec2(top_left_.x + f_.ui.px(columns_.slip), top_left_.y + f_.ui.px((bench_row - 28) / 2)));
    if (button(f_.ui, Path("bench/slip/{}", name_), "100", o).clicked)
      of_.operate_bench(bench::Slip(id, Steps(100)));
  }

  Frame& f_;
  Tab& of_;
  std::size_t at_;
  const BenchColumns& columns_;
  std::string_view name_;
  ImVec2 top_left_;
  float x_ = 0;  ///< left of the next cell, in pixels
};

}  // namespace

void draw_bench_axes(Frame& f) {
  const bool alarm = has_alarm(f.catalog);
  const BenchColumns columns = columns_in(f, alarm);
  draw_titles(f, columns, alarm);
  const auto draw_rows = [&](Tab& of) {
    for (std::size_t i = 0; i < of.catalog().axes.size(); ++i) BenchRow(f, of, i, columns).draw();
  };
  if (!f.tab.bus) return draw_rows(f.tab);
  for (Tab* each : f.tab.bus->members)
    if (each->bench().present) draw_rows(*each);
}

}  // namespace hw::panels
