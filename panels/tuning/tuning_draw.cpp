// Draws the tuning panel: plots, measures, gains.
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/sample_feed.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/tuning/step_table.h"
#include "panels/tuning/tuning.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float gain_row = 36;
// Heights at which a plot can be read from beside the machine, and the least heights.
constexpr float good_plot = 250, good_small_plot = 90;
constexpr float least_plot = 140, least_small_plot = 84;

/// Shares the height. If it is too small, the measurements can be scrolled to.
struct WorkHeights {
  float plot, small_plot;
  bool stacked;  ///< small plots below each other, else side by side
  bool flat;     ///< the table of measurements as columns
};
WorkHeights share(float height, bool output) {
  const float small_plots = output ? 2 : 1;
  WorkHeights h{};
  h.flat = height - step_table_height < good_plot + small_plots * good_small_plot;
  const float table = h.flat ? flat_step_table_height : step_table_height;
  const float room = std::max(least_plot + least_small_plot, height - table);
  h.stacked = output && room >= good_plot + small_plots * good_small_plot;
  const float rows = h.stacked ? small_plots : 1;
  constexpr float good_share = good_small_plot / (good_plot + good_small_plot);
  h.small_plot = std::floor(std::max(least_small_plot, room * (h.stacked ? 0.21f : good_share)));
  h.plot = room - rows * h.small_plot;
  return h;
}

/// "Proportional gain of X" under the title "Gains of X" becomes "Proportional".
std::string_view without_axis(const Frame& f, const ParamInfo& p) {
  const std::string& axis = f.catalog.axes[static_cast<std::size_t>(p.axis)].name;
  std::string_view label = p.label;
  const Path tail(" of {}", axis);
  if (label.ends_with(tail.view())) label.remove_suffix(tail.view().size());
  if (constexpr std::string_view gain = " gain"; label.ends_with(gain)) label.remove_suffix(gain.size());
  return label;
}

/// Both plots span the times of both runs.
PlotRange times(const StepRun* run, const StepRun* old, double usual) {
  PlotRange r{-20, static_cast<float>(usual)};
  if (!run || run->empty()) return r;
  r = {run->t_ms().front(), std::max(run->t_ms().back(), run->planned_end_ms())};
  if (old && !old->empty()) r.take(old->t_ms());
  return r;
}

}  // namespace

/// A run that has just begun keeps the choice of the previous one.
bool Tuning::shows_output() const {
  const StepRun* run = latest();
  if (run && run->empty()) run = before();
  return run && !run->output().empty();
}

void Tuning::draw_work(Frame& f, float width, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  begin_part(ui, "tuning/work", ui.px(width), ui.px(height), Tone::panel, 0);
  const bool output = shows_output();
  const WorkHeights heights = share(height, output);
  const float small = heights.small_plot;
  draw_plots(f, width, heights.plot);
  if (!output) {
    draw_error(f, width, small, true);
  } else if (heights.stacked) {
    draw_error(f, width, small, false);
    draw_output(f, small);
  } else {
    const ImVec2 left = ImGui::GetCursorScreenPos();
    draw_error(f, width / 2, small, true);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(ImVec2(left.x + ui.px(width / 2), left.y));
    draw_output(f, small);
    ImGui::SetCursorScreenPos(below);
  }
  const TwoSteps steps{recorder_->measured_number(), recorder_->measured(), compared_.number,
                       compared_.measures, recorder_->scatter()};
  heights.flat ? draw_flat_step_table(f, steps, width) : draw_step_table(f, steps, width);
  end_part();
}

void Tuning::draw_plots(Frame& f, float width, float height) {
  const StepRun* run = latest();
  const StepRun* old = before();
  PlotOptions o;
  const Path title("position, {}", f.catalog.step_word);
  o.title = title;
  o.x_unit = "ms";
  o.x_labels = false;
  o.x = times(run, old, length_.value().value_or(usual_length_ms));
  o.height = height;
  o.width = width;
  o.empty = "Record a step: command and encoder are drawn here.";
  const auto last = [](std::span<const float> v) { return v.empty() ? 0.0f : v.back(); };
  const Path command("command {:.0f}", run ? last(run->command()) : 0.0f);
  const Path encoder("encoder {:.0f}", run ? last(run->encoder()) : 0.0f);
  std::array<PlotTrace, 3> traces;
  std::size_t n = 0;
  if (old) traces[n++] = {old->t_ms(), old->encoder(), Tone::ink3, 1, false, {}, false, old->gaps()};
  if (run) {
    traces[n++] = {run->t_ms(), run->command(), Tone::ink, 1, true, command, true, run->gaps()};
    traces[n++] = {run->t_ms(), run->encoder(), Tone::motion, 2, false, encoder, false, run->gaps()};
    o.y = {0, static_cast<float>(run->step())};
  }
  for (std::size_t i = 0; i < n; ++i) o.y.take(traces[i].y);
  o.y.widen(0.1f);
  const StepMeasures& now = recorder_->measured();
  const bool measured = run && !recorder_->records() && now.any;
  const Path settled("settled {:.0f} ms after the step", now.settling_ms.high);
  const PlotMark mark{static_cast<float>(now.settling_ms.high), settled};
  if (measured) {
    const float target = last(run->command());
    o.band = {target - static_cast<float>(now.band), target + static_cast<float>(now.band)};
    if (now.settled && now.settling_ms.exact()) o.marks = {&mark, 1};
  }
  const Path words("{} samples, {}, {}", run ? run->t_ms().size() : 0, command.view(), encoder.view());
  if (run) o.words = words;
  plot(f.ui, "tuning/plot", "Step response", {traces.data(), n}, o, cursor_);
}

void Tuning::draw_error(Frame& f, float width, float height, bool lowest) {
  const StepRun* run = latest();
  const StepRun* old = before();
  PlotOptions o;
  const Path title("following error, {}", f.catalog.step_word);
  o.title = title;
  o.x_unit = "ms";
  o.x = times(run, old, length_.value().value_or(usual_length_ms));
  o.x_labels = lowest;
  o.width = width;
  o.height = height;
  o.y = {0, 0};
  const NumberText last_error =
      format_number(run && !run->empty() ? static_cast<double>(run->error().back()) : 0.0, 0);
  const Path error("error {}", last_error.view());
  std::array<PlotTrace, 2> traces;
  std::size_t n = 0;
  if (old) traces[n++] = {old->t_ms(), old->error(), Tone::ink3, 1, false, {}, false, old->gaps()};
  if (run) traces[n++] = {run->t_ms(), run->error(), Tone::trace, 2, false, error, true, run->gaps()};
  for (std::size_t i = 0; i < n; ++i) o.y.take(traces[i].y);
  o.y.widen(0.15f);
  if (run) o.words = error;
  plot(f.ui, "tuning/error", "Following error", {traces.data(), n}, o, cursor_);
}

/// No controller reports its output, so the title says how it is computed, and the side lists the omissions.
void Tuning::draw_output(Frame& f, float height) {
  const StepRun* run = latest();
  const StepRun* old = before();
  PlotOptions o;
  o.title = "output, % (calculated)";
  o.x_unit = "ms";
  o.x = times(run, old, length_.value().value_or(usual_length_ms));
  o.height = height;
  o.y = {0, 0};
  const Path largest("at most {:.0f} %", run->largest_output());
  std::array<PlotTrace, 2> traces;
  std::size_t n = 0;
  if (old && !old->output().empty())
    traces[n++] = {old->t_ms(), old->output(), Tone::ink3, 1, false, {}, false, old->gaps()};
  traces[n++] = {run->t_ms(), run->output(), Tone::ink, 2, false, largest, true, run->gaps()};
  for (std::size_t i = 0; i < n; ++i) o.y.take(traces[i].y);
  o.y.widen(0.15f);
  const Path words("calculated, not read: {}", largest.view());
  o.words = words;
  plot(f.ui, "tuning/output", "Output, calculated", {traces.data(), n}, o, cursor_);
}

// ---- gains

void Tuning::draw_side(Frame& f, float width) {
  Ui& ui = f.ui;
  SetupEdits& edits = f.tab.desk().setup;
  edits.settle(f.now);
  const std::string& name = f.catalog.axes[axis().index].name;
  const Path title("Gains of {}", name);
  const Path caption("run {} in grey", before() ? before()->number() : 0);
  section_title(ui, title, before() ? caption.view() : std::string_view());
  for (const std::size_t i : gains_) draw_gain(f, i, width);
  gap(ui, 8);
  const auto changes = std::count_if(gains_.begin(), gains_.end(), [&](std::size_t i) {
    return edits.changed(i, f.now) && edits.edited(i);
  });
  ButtonOptions send;
  send.style = ButtonStyle::primary;
  send.width = width - 76;
  send.disabled = !f.connected() ? f.no_link() : changes == 0 ? "No gain has been changed." : "";
  if (button(ui, "tuning/send", "Send gains", send).clicked) send_gains(f);
  ImGui::SameLine(0, ui.px(8));
  ButtonOptions undo;
  undo.width = 68;
  undo.disabled = changes == 0 ? "No gain has been changed." : "";
  if (button(ui, "tuning/undo", "Undo", undo).clicked)
    for (const std::size_t i : gains_) edits.undo(i), fields_[i].reset();
  gap(ui, 8);
  draw_scatter(f, width);
  if (!f.catalog.can.store)
    wrapped(ui, Face::small, Tone::ink2,
            "The controller loses its gains at power-off. Save them to a file in Setup.", width);
  if (shows_output()) {
    gap(ui, 8);
    wrapped(ui, Face::small, Tone::ink2,
            "The console calculates the output from error, speed and these gains, because the controller "
            "does not report it; an integral counts from the start of the recording.",
            width);
  }
  gap(ui, 16);
}

/// The scatter that a change must exceed to count.
void Tuning::draw_scatter(Frame& f, float width) {
  Ui& ui = f.ui;
  wrapped(ui, Face::small, Tone::ink2,
          recorder_->scatter().known()
              ? "A difference within the scatter of three repetitions counts as the same."
              : "Better or worse is shown when the scatter of three repetitions is known.",
          width);
  gap(ui, 4);
  ButtonOptions three;
  three.width = width;
  three.moving = true;
  three.disabled = why_not_beside_repeat(f);
  three.tip = "Makes the step three times to and fro, and ends where it began.";
  if (button(ui, "tuning/scatter", "Repeat three times", three).clicked) {
    drop_samples(f.tab);
    recorder_->learn_scatter(plan(), steps_view(f.tab));
  }
  gap(ui, 8);
}

void Tuning::draw_gain(Frame& f, std::size_t i, float width) {
  Ui& ui = f.ui;
  SetupEdits& edits = f.tab.desk().setup;
  const ParamInfo& p = f.catalog.params[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(16), field_width = 72;
  const float field_left = at.x + ui.px(width - field_width);
  const double scale = std::pow(10.0, p.decimals);
  const bool changed = edits.edited(i) && edits.changed(i, f.now);
  draw_text_line(ui, at.x, at.x + ui.px(36), middle, Face::code_field, ui[Tone::ink2], p.mnemonic);
  float end = field_left - ui.px(8);
  if (changed && f.now.params[i].known) {
    const Path was("was {:.{}f}", static_cast<double>(f.now.params[i].value) / scale, p.decimals);
    const float w = std::ceil(text_width(ui, Face::small, was));
    const float name_end = at.x + ui.px(36) + std::ceil(text_width(ui, Face::body, without_axis(f, p)));
    if (name_end + ui.px(8) <= end - w) {
      draw_text_line(ui, end - w, end + 1, middle, Face::small, ui[Tone::ink3], was);
      end -= w + ui.px(8);
    }
  }
  draw_text_in_two_lines(ui, at.x + ui.px(36), end, middle, Face::body, ui[Tone::ink], without_axis(f, p));
  NumberOptions o;
  o.range = {static_cast<double>(p.minimum) / scale, static_cast<double>(p.maximum) / scale, p.decimals,
             p.unit};
  o.width = field_width;
  o.disabled = f.no_link();
  o.changed = changed;
  o.tip = fields_[i].sentence.empty() ? p.explanation : fields_[i].sentence;
  o.sentence_below = false;
  const auto value = edits.shown(i, f.now);
  ImGui::SetCursorScreenPos(ImVec2(field_left, at.y));
  const NumberEvent e = number_field(
      ui, Path("tuning/{}", p.mnemonic), p.label,
      value ? std::optional<double>(static_cast<double>(*value) / scale) : std::nullopt, fields_[i], o);
  if ((e.committed || (e.entered && fields_[i].dirty())) && edits.set(i, std::llround(e.value * scale)))
    fields_[i].reset();
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(gain_row)));
}

void Tuning::send_gains(Frame& f) {
  const SetupEdits& edits = f.tab.desk().setup;
  for (const std::size_t i : gains_)
    if (const auto value = edits.edited(i); value && edits.changed(i, f.now))
      recorder_->sent_beside(f.send(intent::SetParam(f.catalog.params[i].mnemonic, *value)));
}

}  // namespace hw::panels
