#include "panels/tuning/tuning.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/device/servo_tuning.h"
#include "gui/model/sample_feed.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double usual_step = 400, longest_ms = 10'000;

bool is_gain(const ParamInfo& p) { return p.axis >= 0 && p.group == servo_loop_group; }

}  // namespace

bool can_tune(const Catalog& c) {
  return c.can.servo_tuning && std::any_of(c.params.begin(), c.params.end(), is_gain);
}

void Tuning::make(const Frame& f) {
  if (!recorder_) {
    recorder_ = f.tab.desk().step_recorder.get();
    for (std::size_t i = 0; i < f.catalog.axes.size(); ++i)
      if (std::any_of(f.catalog.params.begin(), f.catalog.params.end(),
                      [&](const ParamInfo& p) { return is_gain(p) && p.axis == static_cast<int>(i); }))
        axes_.push_back(AxisId{static_cast<std::uint8_t>(i)}), names_.push_back(f.catalog.axes[i].name);
    fields_.resize(f.catalog.params.size());
    step_.set(usual_step, 0);
    length_.set(usual_length_ms, 0);
    gains_.clear();
  }
  if (!gains_.empty() && f.catalog.params[gains_.front()].axis == axis().index) return;
  gains_.clear();
  for (std::size_t i = 0; i < f.catalog.params.size(); ++i)
    if (is_gain(f.catalog.params[i]) && f.catalog.params[i].axis == axis().index) gains_.push_back(i);
}

void Tuning::draw(Frame& f) {
  make(f);
  follow(f);
  draw_toolbar(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool side = f.area.width >= 560;
  const float side_wide = f.area.width >= 800 ? side_width : narrow_side_width;
  const float width = f.area.width - (side ? side_wide : 0);
  draw_work(f, width, (f.ui.px(f.area.bottom()) - at.y) / f.ui.scale);
  if (!side) return;
  const float x = f.ui.px(f.area.x + width);
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(x, at.y), ImVec2(x + f.ui.hair(), f.ui.px(f.area.bottom())), f.ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(x + f.ui.hair(), at.y));
  begin_part(f.ui, "tuning/side", 0, f.ui.px(f.area.bottom()) - at.y, Tone::panel, 16);
  draw_side(f, ImGui::GetContentRegionAvail().x / f.ui.scale);
  end_part();
}

// ---- the recording

void Tuning::follow(Frame& f) {
  recorder_->looked_at();
  for (Report& report : recorder_->take_report()) f.toast(report.severity, std::move(report.sentence));
  if (compared_.latest == recorder_->measured_number()) return;
  compared_.latest = recorder_->measured_number();
  name_runs();
  measure_before();
}

void Tuning::name_runs() {
  compared_.texts.clear(), compared_.names.clear();
  for (const StepRun& run : recorder_->runs())
    if (run.number() < compared_.latest) compared_.texts.push_back(fmt::format("run {}", run.number()));
  compared_.names.assign(compared_.texts.begin(), compared_.texts.end());
}

const StepRun* Tuning::before() const {
  const std::deque<StepRun>& runs = recorder_->runs();
  if (runs.size() < 2) return nullptr;
  for (const StepRun& run : runs)
    if (run.number() == compared_.wanted && &run != &runs.back()) return &run;
  return &runs[runs.size() - 2];
}

void Tuning::measure_before() {
  const StepRun* old = before();
  compared_.number = old ? old->number() : 0;
  compared_.measures = old ? measure(*old) : StepMeasures();
}

void Tuning::choose_axis(Frame& f, int axis) {
  chosen_ = axis;
  recorder_->forget_runs();
  compared_ = {};
  make(f);
}

std::string_view Tuning::why_not_beside_repeat(const Frame& f) const {
  return recorder_->repeats() ? std::string_view("Repeat is on: switch it off first.") : why_not(f);
}

std::string_view Tuning::why_not(const Frame& f) const {
  if (const std::string_view why = recorder_->why_not(axis(), steps_view(f.tab)); !why.empty()) return why;
  const auto step = step_.value(), length = length_.value();
  if (!step || std::llround(*step) == 0) return "Type the size of the step.";
  if (!length || *length < 10 || *length > longest_ms) return "Record from 10 to 10 000 ms.";
  return {};
}

StepRecorder::Plan Tuning::plan() const {
  return {axis(), Steps(std::llround(*step_.value())), *length_.value()};
}

// ---- toolbar

void Tuning::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  ButtonOptions go;
  go.icon = Icon::play;
  go.moving = true;
  go.height = 40;
  go.disabled = why_not_beside_repeat(f);
  go.tip = "Moves the axis by the step and records it.";
  if (button(ui, "tuning/record", f.area.width >= 640 ? "Record step" : "Record", go).clicked) {
    drop_samples(f.tab);
    recorder_->record(plan(), steps_view(f.tab));
  }
  ImGui::SameLine(0, ui.px(8));
  ButtonOptions again;
  again.moving = !recorder_->repeats();  // a press that ends the series takes effect at once
  again.height = 40;
  again.on = true;
  again.width = button_width(ui, "Repeat", again);  // the same width in both states
  again.on = recorder_->repeats();
  again.disabled = recorder_->repeats() ? std::string_view() : why_not(f);
  again.tip =
      "Steps to and fro until you press it again, and ends at the start. A stop or another panel ends it at "
      "once.";
  if (button(ui, "tuning/repeat", "Repeat", again).clicked) {
    if (recorder_->repeats()) {
      recorder_->end_where_it_began();
    } else {
      drop_samples(f.tab);
      recorder_->repeat(plan(), steps_view(f.tab));
    }
  }
  const float after = ImGui::GetItemRectMax().x;
  ImGui::SetCursorScreenPos(ImVec2(after + ui.px(16), at.y + ui.px(12)));
  draw_fields(f);
  draw_compare(f, ui.px(f.area.right() - 16), at.y + ui.px(12));
  end_toolbar(f, at);
}

void Tuning::draw_fields(Frame& f) {
  Ui& ui = f.ui;
  const bool roomy = f.area.width >= 800;
  const std::string_view busy = !recorder_->busy() ? "" : "Steps are being recorded.";
  const auto word = [&](std::string_view s) {
    if (!roomy) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::ceil(text_width(ui, Face::body, s));
    draw_text_line(ui, at.x, at.x + width + 1, at.y + ui.px(16), Face::body, ui[Tone::ink2], s);
    ImGui::SetCursorScreenPos(ImVec2(at.x + width + ui.px(8), at.y));
  };
  const auto next = [&](float by) {
    const ImVec2 after(ImGui::GetItemRectMax().x + ui.px(by), ImGui::GetItemRectMin().y);
    ImGui::SetCursorScreenPos(after);
  };
  word("Axis");
  const float top = ImGui::GetCursorScreenPos().y;
  if (const int picked =
          dropdown(ui, "tuning/axis", "Axis", names_, chosen_, {.disabled = busy, .width = 52});
      picked >= 0 && picked != chosen_)
    choose_axis(f, picked);
  next(roomy ? 12 : 8);
  ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top));
  word("step");
  NumberOptions o;
  o.range = {-1e7, 1e7, 0, f.catalog.step_word};
  o.width = 112;
  o.disabled = busy;
  o.sentence_below = false;
  const float x_step = ImGui::GetCursorScreenPos().x;
  number_field(ui, "tuning/step", "Step", std::nullopt, step_, o);
  ImGui::SetCursorScreenPos(ImVec2(x_step + ui.px(112 + (roomy ? 12.f : 8.f)), top));
  word("record");
  o.range = {10, longest_ms, 0, "ms"};
  o.width = 84;
  number_field(ui, "tuning/length", "Record", std::nullopt, length_, o);
}

void Tuning::draw_compare(Frame& f, float right, float top) {
  if (compared_.names.empty() || f.area.width < 660) return;
  Ui& ui = f.ui;
  const StepRun* with = before();
  int chosen = -1;
  const std::deque<StepRun>& runs = recorder_->runs();
  for (std::size_t i = 0; with && i < compared_.names.size(); ++i)
    if (&runs[i] == with) chosen = static_cast<int>(i);
  ImGui::SetCursorScreenPos(ImVec2(right - ui.px(84), top));
  const int picked = dropdown(ui, "tuning/compare", "Compare with", compared_.names, chosen,
                              {.tip = "The run drawn in grey.", .width = 84});
  if (picked < 0) return;
  compared_.wanted = runs[static_cast<std::size_t>(picked)].number();
  measure_before();
}

}  // namespace hw::panels
