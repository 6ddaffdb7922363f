#include "panels/program/rehearsal_card.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/program/io_chart.h"
#include "panels/program/rehearsal_words.h"
#include "panels/program/run_bar.h"
#include "panels/program/threads.h"
#include "panels/program/travel_words.h"

namespace hw::panels {

using namespace gui;

/// Adds the inputs of the words other than the outcome.
static void add_shown(std::string& all, const Frame& f, std::size_t axis) {
  const AxisState& state = f.now.axes[axis];
  const Travel travel = state.travel_holds() ? state.travel : Travel();
  all += f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(axis)}).name;
  fmt::format_to(std::back_inserter(all), " {} {} {} {}\n", travel.has_minus, travel.minus.value,
                 travel.has_plus, travel.plus.value);
}

// Puts the outcome into words, in the user's units; the caption names the text.
void RehearsalCard::refresh(Frame& f, int slot) {
  Desk& desk = f.tab.desk();
  const int started = desk.programs.texts.start_of(slot);
  outcome_ = desk.programs.rehearsals.of(started);
  refresh_caption(f, slot);
  std::string& units = units_now_;  // keeps its memory from frame to frame
  units.clear();
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) add_shown(units, f, i);
  if (version_ == desk.programs.rehearsals.version() && slot_ == started && units == text_of_units_) return;
  version_ = desk.programs.rehearsals.version();
  slot_ = started;
  text_of_units_ = units;
  refresh_words(f);
}

void RehearsalCard::refresh_caption(const Frame& f, int slot) {
  Desk& desk = f.tab.desk();
  const int started = desk.programs.texts.start_of(slot);
  const int older = desk.programs.rehearsals.older_than_line(started, desk.programs.texts.text(slot));
  const HeldProgram& held = desk.programs.texts.held(slot);
  old_ = outcome_ && older >= 0;
  const ProgramState& p = f.now.program;
  const bool runs =
      f.catalog.program.threads == 0 || is_busy(f.now.threads[static_cast<std::size_t>(started)]);
  of_running_ =
      outcome_ && p.owned && p.slot == slot && p.run != RunState::idle && runs && held.text == outcome_->text;
  if (desk.programs.rehearsals.under_way(started))
    shown_caption_ = "calculating";
  else if (!outcome_)
    shown_caption_ = "";
  else if (of_running_)
    shown_caption_ = "of the version running";
  else if (old_) {
    const auto end = fmt::format_to_n(caption_, sizeof caption_, "before line {}", older + 1);
    shown_caption_ = {caption_, std::min(end.size, sizeof caption_)};
  } else {
    shown_caption_ = "of this text";
  }
}

void RehearsalCard::refresh_words(const Frame& f) {
  axes_.clear();
  event_times_.clear();
  lanes_.clear();
  stops_.clear();
  for (std::string* words : {&time_, &fault_, &sends_, &spans_, &stand_, &assumed_, &memory_}) words->clear();
  if (!outcome_) return;
  if (!outcome_->result) {
    fault_ = outcome_->result.error().sentence();
    return;
  }
  const Rehearsal& r = *outcome_->result;
  time_ = exact_time(r.duration_s);
  fault_ = r.error;
  if (fault_.empty() && !r.finished)
    fault_ = fmt::format("The program has not ended after {}; it may never end.",
                         format_duration(r.duration_s).view());
  for (const RehearsedAxis& axis : r.axes) add_span(f, axis);
  stand_ = stand_words(f, *outcome_);
  if (begins_here()) stops_ = past_travel_words(f, r);
  for (std::string& stop : stop_words(r)) stops_.push_back(std::move(stop));
  assumed_ = assumption_words(r);
  memory_ = memory_words(r, f.catalog.program);
  sends_ = r.sent_to_host;
  std::replace(sends_.begin(), sends_.end(), '\r', ' ');
  lanes_ = io_lanes(r);
  constexpr std::size_t most_events = 200;
  for (std::size_t i = 0; i < std::min(r.events.size(), most_events); ++i)
    event_times_.push_back(fmt::format("{:.1f} s", r.events[i].t));
}

void RehearsalCard::add_span(const Frame& f, const RehearsedAxis& axis) {
  const int i = f.catalog.find_axis(axis.name);
  if (i < 0) return;
  if (axis.minimum == axis.maximum) return axes_.push_back({axis.name, "does not move"});
  DisplayUnit unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(i)});
  if (axis.in_counts !=
      f.now.axes[static_cast<std::size_t>(i)].in_counts)  // the program has changed the loop
    unit = {.name = axis.in_counts ? f.catalog.loop_word : f.catalog.step_word};
  std::string span = fmt::format("{} to {}", format_position(Steps(axis.minimum), unit).view(),
                                 format_with_unit(Steps(axis.maximum), unit).view());
  spans_ += fmt::format("{}{}: {}", spans_.empty() ? "" : ", ", axis.name, span);
  axes_.push_back({axis.name, std::move(span)});
}

bool RehearsalCard::draw_column(Frame& f, int slot, float width, float height) {
  Ui& ui = f.ui;
  bool again = false;
  refresh(f, slot);
  begin_part(ui, "rehearsal", ui.px(width), ui.px(height), Tone::panel, 16);
  section_title(ui, "Rehearsal", shown_caption_);
  if (!outcome_) {
    wrapped(ui, Face::body, Tone::ink2,
            "Simulate runs the text without moving anything, and shows its time, the travel of each axis, "
            "and its commands.");
  } else if (!outcome_->result) {
    named_text(ui, "rehearsal/result", Face::body_medium, Tone::fault, "The program cannot run.");
    wrapped(ui, Face::body, Tone::ink, fault_);
  } else {
    draw_progress(f);
    if (!fault_.empty()) {
      wrapped(ui, Face::body, Tone::fault, fault_);
      gap(ui, 8);
    }
    const bool goes = of_running_ && !lanes_.empty();
    draw_io_chart(ui, lanes_, outcome_->result->duration_s,
                  goes ? std::optional(f.tab.desk().programs.follower.run_s()) : std::nullopt);
    draw_axes(f);
    again = draw_verdict(f);
    draw_events(f);
  }
  gap(ui, 12);
  end_part();
  return again;
}

void RehearsalCard::draw_progress(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  named_text(ui, "rehearsal/result", Face::time, old_ && !of_running_ ? Tone::ink3 : Tone::ink, time_);
  const auto progress = of_running_ ? run_progress(f) : std::nullopt;
  if (progress) {
    draw_text_right(ui, ImVec2(right, at.y + ui.px(4)), Face::body, ui[Tone::ink2], progress->left);
    if (f.now.program.run == RunState::running) ui.wake_in(0.1);
  }
  gap(ui, 8);
  meter(ui, "rehearsal/progress", "Done", progress ? progress->share : 0,
        {.tone = Tone::motion,
         .old = old_ && !of_running_,
         .words = progress ? progress->left.view() : std::string_view()});
  gap(ui, 12);
}

void RehearsalCard::draw_axes(Frame& f) {
  char id[48];
  for (const Axis& axis : axes_) {
    const auto end = fmt::format_to_n(id, sizeof id, "rehearsal/axis/{}", axis.name);
    key_value(f.ui, {id, std::min(end.size, sizeof id)}, axis.name, axis.span);
  }
  gap(f.ui, 8);
}

bool RehearsalCard::draw_verdict(Frame& f) {
  Ui& ui = f.ui;
  const Rehearsal& r = *outcome_->result;
  const bool at_zero = std::all_of(r.axes.begin(), r.axes.end(), [](auto& axis) { return axis.begin == 0; });
  key_value(ui, "rehearsal/begins", "Begins",
            at_zero         ? "at 0"
            : begins_here() ? "where the axes stand"
                            : "where the axes stood");
  const bool again = draw_limits(f);
  draw_sentences(f);
  char words[32];
  auto end = fmt::format_to_n(words, sizeof words, "{}", r.moves);
  key_value(ui, "rehearsal/moves", "Moves", {words, std::min(end.size, sizeof words)});
  if (!memory_.empty()) key_value(ui, "rehearsal/memory", "Memory", memory_);
  char id[48], key[48];
  for (const auto& [output, on] : r.outputs) {
    const auto first = r.outputs_at_first.find(output);
    if (on == (first == r.outputs_at_first.end() ? 0 : first->second)) continue;
    end = fmt::format_to_n(id, sizeof id, "rehearsal/out/{}", output);
    const auto key_end = fmt::format_to_n(key, sizeof key, "Output {} at the end", output);
    key_value(ui, {id, std::min(end.size, sizeof id)}, {key, std::min(key_end.size, sizeof key)},
              on ? "on" : "off");
  }
  key_value(ui, "rehearsal/sends", "Sends",
            sends_.empty() ? std::string_view("nothing") : std::string_view(sends_));
  return again;
}

// The tick is shown only if the axes would really take that path.
bool RehearsalCard::draw_limits(Frame& f) {
  Ui& ui = f.ui;
  const bool touched = outcome_->result->limit_touched;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  const std::string_view verdict = !judges_limits() ? "not judged" : touched ? "touched" : "none touched";
  const bool fine = judges_limits() && !touched, warns = !begins_here() || (judges_limits() && touched);
  key_value(ui, "rehearsal/limits", "Limits", verdict, warns ? Tone::warn : Tone::ink);
  if (fine || warns)
    draw_icon(ImGui::GetWindowDrawList(), fine ? Icon::check : Icon::warning,
              ImVec2(std::floor(right - text_width(ui, Face::body, verdict) - ui.px(14)), at.y + ui.px(12)),
              ui.px(12), ui[fine ? Tone::ok : Tone::warn]);
  if (stand_.empty()) return false;
  const ImVec2 words_at = ImGui::GetCursorScreenPos();
  const float height = wrapped_height(ui, Face::small, stand_, right - words_at.x);
  wrapped(ui, Face::small, warns ? Tone::warn : Tone::ink2, stand_);
  show(ui, {.id = "rehearsal/stand", .kind = Kind::text, .label = "Start position", .value = stand_},
       {words_at, ImVec2(right, words_at.y + height)});
  gap(ui, 8);
  const StartMatch match = outcome_->start.match;
  if (begins_here() || match == StartMatch::unknown || match == StartMatch::doubtful) return false;
  const std::string_view why = of_running_                   ? "The program runs."
                               : match == StartMatch::moving ? "An axis is moving."
                                                             : why_not_rehearse_now(f.now, f.catalog);
  const bool again = button(ui, "rehearsal/again", "Rehearse from here", {.disabled = why}).clicked;
  gap(ui, 8);
  return again;
}

void RehearsalCard::draw_sentences(Frame& f) {
  Ui& ui = f.ui;
  const auto sentence = [&](std::string_view id, std::string_view label, Tone tone,
                            const std::string& words) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    wrapped(ui, Face::small, tone, words);
    show(ui, {.id = id, .kind = Kind::text, .label = label, .value = words},
         {at, ImVec2(at.x + width, ImGui::GetCursorScreenPos().y)});
    gap(ui, 6);
  };
  char id[32];
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    const auto end = fmt::format_to_n(id, sizeof id, "rehearsal/stop/{}", i + 1);
    sentence({id, std::min(end.size, sizeof id)}, "Stop", Tone::warn, stops_[i]);
  }
  if (!assumed_.empty()) sentence("rehearsal/assumed", "Assumed", Tone::ink2, assumed_);
}

void RehearsalCard::draw_events(Frame& f) {
  Ui& ui = f.ui;
  const Rehearsal& r = *outcome_->result;
  if (event_times_.empty()) return;
  group_line(ui, 8);
  const float left = ImGui::GetCursorScreenPos().x, right = left + ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < event_times_.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + ui.px(10);
    draw_text_line(ui, left, left + ui.px(60), middle, Face::code_time, ui[Tone::ink3], event_times_[i]);
    draw_text_line(ui, left + ui.px(64), right, middle,
                   r.events[i].command >= 0 ? Face::code_time : Face::small, ui[Tone::ink2],
                   r.events[i].what);
    ImGui::Dummy(ImVec2(right - left, ui.px(20) - ImGui::GetStyle().ItemSpacing.y));
  }
  if (r.events.size() > event_times_.size()) text(ui, Face::small, Tone::ink3, "and more");
}

/// The verdict on limits, for the single line.
RehearsalCard::Verdict RehearsalCard::verdict(const Frame& f) const {
  if (!begins_here()) return {"begins elsewhere: limits not checked", Icon::warning};
  if (passes_travel(f, *outcome_->result)) return {"goes past your limit", Icon::warning};
  if (!judges_limits()) return {"limits not checked", Icon::none};
  if (outcome_->result->limit_touched) return {"a limit is touched", Icon::warning};
  return {"no limit touched", Icon::check};
}

bool RehearsalCard::draw_line(Frame& f, int slot, bool opened) {
  Ui& ui = f.ui;
  refresh(f, slot);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ui.px(f.area.x + 16), right = ui.px(f.area.right() - 16), middle = at.y + ui.px(18);
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  const Touch t = touch(ui,
                        {.id = "rehearsal/expand",
                         .kind = Kind::toggle,
                         .label = "Rehearsal",
                         .value = opened ? "open" : "closed"},
                        ImVec2(ui.px(f.area.width), ui.px(36)));
  if (t.hovered) draw_fill(ui, t.rect, ui[Tone::hover], 0);
  ImGui::GetWindowDrawList()->AddRectFilled(t.rect.min, ImVec2(t.rect.max.x, t.rect.min.y + ui.hair()),
                                            ui[Tone::line]);
  float x = left;
  const auto word = [&](Face face, Tone tone, std::string_view s) {
    draw_text_line(ui, x, right - ui.px(24), middle, face, ui[tone], s);
    x += std::ceil(text_width(ui, face, s)) + ui.px(14);
  };
  word(Face::body_bold, Tone::ink, "Rehearsal");
  const Tone tone = old_ && !of_running_ ? Tone::ink3 : Tone::ink;
  if (!outcome_) {
    word(Face::body, Tone::ink2,
         shown_caption_.empty() ? "Simulate runs the text without moving anything." : shown_caption_);
  } else if (!outcome_->result || !fault_.empty()) {
    word(Face::body, Tone::fault, fault_);
  } else {
    word(Face::body_medium, tone, time_);
    if (const auto progress = of_running_ ? run_progress(f) : std::nullopt) {
      word(Face::body_medium, Tone::motion, progress->left);
      if (f.now.program.run == RunState::running) ui.wake_in(0.2);
    }
    if (old_ && !of_running_) word(Face::small, Tone::ink3, shown_caption_);
    const auto [verdict, mark] = this->verdict(f);
    // The verdict is never cut; spans are shown as far as they fit.
    const float verdict_width = ui.px(20 + 14) + std::ceil(text_width(ui, Face::body, verdict));
    const float spans_end = right - ui.px(24) - verdict_width;
    draw_text_line(ui, x, spans_end, middle, Face::body, ui[Tone::ink2], spans_);
    if (!spans_.empty())
      x = std::max(x, std::min(spans_end, x + std::ceil(text_width(ui, Face::body, spans_)))) + ui.px(14);
    if (mark != Icon::none) {
      draw_icon(ImGui::GetWindowDrawList(), mark, ImVec2(x + ui.px(6), middle), ui.px(12),
                ui[mark == Icon::check ? Tone::ok : Tone::warn]);
      x += ui.px(20);
    }
    word(Face::body, Tone::ink, verdict);
  }
  show(ui,
       {.id = "rehearsal/result",
        .kind = Kind::text,
        .label = "Rehearsal",
        .value = fault_.empty() ? time_ : fault_},
       t.rect);
  draw_icon(ImGui::GetWindowDrawList(), opened ? Icon::chevron_up : Icon::chevron_down,
            ImVec2(right - ui.px(6), middle), ui.px(12), ui[Tone::ink2]);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(36)));
  return t.clicked;
}

}  // namespace hw::panels
