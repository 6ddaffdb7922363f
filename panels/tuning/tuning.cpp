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

constexpr std::size_t most_runs = 8;
constexpr int arming_ms = 300;  // longest time from the first sample to the step
constexpr double pause_s = 0.3, patience_s = 2.0;
constexpr double usual_step = 400, longest_ms = 10'000;

bool is_gain(const ParamInfo& p) { return p.axis >= 0 && p.group == servo_loop_group; }

}  // namespace

bool can_tune(const Catalog& c) {
  return c.can.servo_tuning && std::any_of(c.params.begin(), c.params.end(), is_gain);
}

void Tuning::make(const Frame& f) {
  if (!std::exchange(made_, true)) {
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

void Tuning::take(const AxisSample& s) {
  if ((stage_ != Stage::arming && stage_ != Stage::recording) || s.axis != axis().index || runs_.empty())
    return;
  if (!std::exchange(any_sample_, true)) first_at_ = s.at;
  last_at_ = s.at;
  runs_.back().take(s);
}

bool Tuning::asked_by_others(const Frame& f) const { return f.now.outcomes[0].id > newest_; }

bool Tuning::was_away(const Frame& f) {
  const int frame = ImGui::GetFrameCount();
  const bool frames_missed = frame - std::exchange(drawn_frame_, frame) > 1;
  return f.ui.now_s - std::exchange(drawn_s_, f.ui.now_s) > 1.0 || frames_missed;
}

/// The event since a step was requested that forbids the next one.
std::string_view Tuning::interruption(const Frame& f, bool away) const {
  if (away) return "another panel was in front";
  if (f.now.link.state != LinkState::good || f.now.link.timeouts != timeouts_)
    return "the controller did not answer for a while";
  if (f.now.restarts != restarts_) return "the controller was reset";
  return {};
}

/// Any other event ends Repeat for good: a stop, another sender's command, a refusal, a lost link, a reset,
/// another panel in front.
void Tuning::follow(Frame& f) {
  take_samples(f.tab, [this](const AxisSample& s) { take(s); });
  const bool away = was_away(f);
  if (stage_ == Stage::idle) return;
  const std::string_view between = interruption(f, away);
  // After a stop between the request for samples and the step, the step is not made.
  if (stage_ == Stage::arming && (f.ui.cancelled() || asked_by_others(f))) {
    runs_.pop_back();
    stage_ = Stage::idle;
    return end_repeat(f, "The step was not made: something else came first.");
  }
  if (stage_ == Stage::arming && !between.empty()) {
    runs_.pop_back();
    stage_ = Stage::idle;
    return end_repeat(f, fmt::format("The step was not made: {}.", between));
  }
  if (repeat_.on) {
    if (f.ui.cancelled())
      end_repeat(f, "Stopped: Repeat is off.");
    else if (!between.empty())
      end_repeat(f, fmt::format("Repeat is off: {}.", between));
    else if (asked_by_others(f))
      end_repeat(f, "Repeat is off: something else was asked of the controller.");
  }
  f.ui.wake_in(0.02);
  if (stage_ == Stage::pausing) {
    const bool settles = f.now.axis_moves(axis().index);
    if (!repeat_.on)
      stage_ = Stage::idle;
    else if (f.ui.now_s - since_s_ > pause_s && !settles && !ended_early(f))
      record(f);
    return;
  }
  if (stage_ == Stage::arming && any_sample_) make_step(f);
  const IntentOutcome* outcome = f.now.outcome_of(move_);
  if (outcome && (outcome->state == IntentState::refused || outcome->state == IntentState::failed)) {
    f.toast(Severity::fault, std::string(outcome->sentence.view()));
    runs_.pop_back();
    repeat_.on = false;
    stage_ = Stage::idle;
    return;
  }
  const bool whole = any_sample_ && last_at_ - first_at_ >= from_seconds(length_ms_ / 1000);
  if (whole || f.ui.now_s - since_s_ > length_ms_ / 1000 + patience_s) finish(f);
}

void Tuning::end_repeat(Frame& f, std::string why) {
  repeat_.on = repeat_.learns_scatter = false;
  if (!why.empty()) f.toast(Severity::plain, std::move(why));
}

/// `steps`: even; negative: until Repeat is pressed again.
void Tuning::begin_repeat(Frame& f, int steps) {
  repeat_.on = true;
  repeat_.steps_left = steps;
  sign_ = 1;
  record(f);
}

/// A step away from the start is followed by one back.
void Tuning::end_where_it_began(Frame& f) {
  const bool stands = stage_ == Stage::pausing, leads_away = sign_ > 0;
  repeat_.steps_left = (stands ? 0 : 1) + (leads_away == stands ? 0 : 1);
  if (repeat_.steps_left == 0) end_repeat(f, {});
}

/// From steps away only; those back begin elsewhere.
void Tuning::learn_scatter(Frame& f) {
  if (!repeat_.learns_scatter) return;
  if (sign_ > 0) scatter_.take(now_);
  if (repeat_.steps_left != 0) return;
  f.toast(Severity::ok,
          "Three repetitions are measured: a smaller difference than theirs is called the same.");
}

/// Ends Repeat. A step that has not settled is the subject of the tuning, and ends nothing.
bool Tuning::ended_early(Frame& f) {
  const EndedBy ended = f.now.axes[axis().index].ended_by;
  if (ended == EndedBy::target || ended == EndedBy::nothing || ended == EndedBy::not_in_place) return false;
  end_repeat(f, "Repeat is off: the axis was stopped before its target.");
  return true;
}

void Tuning::finish(Frame& f) {
  stage_ = Stage::idle;
  if (!runs_.back().moved()) {
    const bool none = runs_.back().empty();
    runs_.pop_back();
    repeat_.on = false;
    return f.toast(Severity::fault, none ? "No sample has come: nothing was recorded."
                                         : "The axis was not sent anywhere: nothing was recorded.");
  }
  runs_.back().end();
  now_ = measure(runs_.back());
  while (runs_.size() > most_runs) runs_.pop_front();
  run_texts_.clear(), run_names_.clear();
  for (const StepRun& r : runs_)
    if (&r != &runs_.back()) run_texts_.push_back(fmt::format("run {}", r.number()));
  run_names_.assign(run_texts_.begin(), run_texts_.end());
  now_number_ = runs_.back().number();
  measure_before();
  if (!repeat_.on || ended_early(f)) return;
  if (repeat_.steps_left > 0) --repeat_.steps_left;
  learn_scatter(f);
  if (repeat_.steps_left == 0) return end_repeat(f, {});
  sign_ = -sign_;
  stage_ = Stage::pausing;
  since_s_ = f.ui.now_s;
}

const StepRun* Tuning::before() const {
  if (runs_.size() < 2) return nullptr;
  for (const StepRun& r : runs_)
    if (r.number() == compare_ && &r != &runs_.back()) return &r;
  return &runs_[runs_.size() - 2];
}

void Tuning::measure_before() {
  const StepRun* old = before();
  was_number_ = old ? old->number() : 0;
  was_ = old ? measure(*old) : StepMeasures();
}

std::string_view Tuning::why_not(const Frame& f) {
  if (!f.connected()) return f.no_link();
  if (stage_ == Stage::recording || stage_ == Stage::arming) return "A step is being recorded.";
  if (!f.tab.why_not_move(axis()).empty()) return f.tab.why_not_move(axis());
  if (f.now.axes[axis().index].activity == Activity::moving)
    return "The axis is moving. Wait until it rests.";
  const auto step = step_.value(), length = length_.value();
  if (!step || std::llround(*step) == 0) return "Type how far the step goes.";
  if (!length || *length < 10 || *length > longest_ms) return "Record from 10 to 10 000 ms.";
  return {};
}

/// The step waits for the first sample, so that the recording shows the initial position.
void Tuning::record(Frame& f) {
  if (stage_ == Stage::pausing) stage_ = Stage::idle;
  if (const std::string_view why = why_not(f); !why.empty()) {
    repeat_.on = false;
    return f.toast(Severity::fault, std::string(why));
  }
  take_samples(f.tab, [](const AxisSample&) {});  // of an earlier recording
  const Steps step(sign_ * std::llround(*step_.value()));
  if (length_ms_ != *length_.value() || std::abs(step.value) != std::abs(step_now_.value)) scatter_ = {};
  length_ms_ = *length_.value();
  step_now_ = step;
  runs_.emplace_back(++number_, axis(), step_now_);
  any_sample_ = false;
  timeouts_ = f.now.link.timeouts;
  restarts_ = f.now.restarts;
  const auto length = std::chrono::milliseconds(std::llround(length_ms_) + arming_ms);
  move_ = newest_ = f.send_and_watch(intent::Sample(axis(), length));
  stage_ = Stage::arming;
  since_s_ = f.ui.now_s;
}

void Tuning::make_step(Frame& f) {
  move_ = newest_ = f.send_and_watch(intent::MoveBy({AxisTarget{axis(), step_now_}}));
  stage_ = Stage::recording;
}

// ---- toolbar

void Tuning::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  ButtonOptions go;
  go.icon = Icon::play;
  go.moving = true;
  go.height = 40;
  go.disabled = repeat_.on ? std::string_view("Repeat is on: switch it off first.") : why_not(f);
  go.tip = "Moves the axis by the step and records it.";
  if (button(ui, "tuning/record", f.area.width >= 640 ? "Record step" : "Record", go).clicked) {
    sign_ = 1;
    record(f);
  }
  ImGui::SameLine(0, ui.px(8));
  ButtonOptions again;
  again.moving = !repeat_.on;  // a press that ends it takes effect at once
  again.height = 40;
  again.on = true;
  again.width = button_width(ui, "Repeat", again);  // the same width in both states
  again.on = repeat_.on;
  again.disabled = repeat_.on ? std::string_view() : why_not(f);
  again.tip =
      "Steps to and fro until it is pressed again, and ends where it began. A stop or another panel ends it "
      "at once.";
  if (button(ui, "tuning/repeat", "Repeat", again).clicked) {
    if (repeat_.on)
      end_where_it_began(f);
    else
      begin_repeat(f, -1);
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
  const std::string_view busy = stage_ == Stage::idle ? "" : "Steps are being recorded.";
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
      picked >= 0 && picked != chosen_) {
    chosen_ = picked;
    runs_.clear(), run_names_.clear(), run_texts_.clear();
    scatter_ = {};
    compare_ = now_number_ = was_number_ = 0;
    make(f);
  }
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
  if (run_names_.empty() || f.area.width < 660) return;
  Ui& ui = f.ui;
  const StepRun* with = before();
  int chosen = -1;
  for (std::size_t i = 0; with && i + 1 < runs_.size(); ++i)
    if (&runs_[i] == with) chosen = static_cast<int>(i);
  ImGui::SetCursorScreenPos(ImVec2(right - ui.px(84), top));
  const int picked = dropdown(ui, "tuning/compare", "Compare with", run_names_, chosen,
                              {.tip = "The run that is drawn in grey.", .width = 84});
  if (picked < 0) return;
  compare_ = runs_[static_cast<std::size_t>(picked)].number();
  measure_before();
}

}  // namespace hw::panels
