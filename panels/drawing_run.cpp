#include "panels/drawing_run.h"

#include <fmt/format.h>

#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

std::string_view DrawingRun::why_not_now(const Frame& f) {
  if (!f.connected()) return "There is no link. Cut comes back when the controller answers.";
  if (f.tab.desk().job.busy()) return "A program is being transferred.";
  const ProgramState& p = f.now.program;
  if (p.owned && p.run != RunState::idle && p.run != RunState::error)
    return "A program is at work. Cut comes back when it has ended or was stopped.";
  return f.tab.why_not_move();
}

void DrawingRun::draw(Frame& f, const Wanted& wanted) {
  say_what_came(f);
  if (f.now.pieces.running)
    draw_while_running(f);
  else
    draw_start(f, wanted);
  draw_progress(f);
  gap(f.ui, 8);
}

void DrawingRun::draw_start(Frame& f, const Wanted& wanted) {
  const std::string_view now = why_not_now(f);
  const ButtonOptions options{.icon = Icon::play,
                              .disabled = !wanted.pieces ? wanted.why_not : now,
                              .tip = wanted.tool,
                              .height = 40,
                              .moving = true};
  if (button(f.ui, "drawing/cut", "Cut", options).clicked) ask(f, wanted, wanted.pieces, 0);
  const PiecesState& done = f.now.pieces;
  if (!cut_ || done.done == 0 || done.done >= done.total) return;
  ImGui::SameLine(0, f.ui.px(8));
  const ButtonOptions on{.disabled = cut_ != wanted.pieces ? "The drawing has changed since." : now,
                         .tip = "Goes to the start of the piece that was not ended, with the tool off.",
                         .height = 40,
                         .moving = true};
  if (button(f.ui, "drawing/cut_on", "Go on", on).clicked) ask(f, wanted, cut_, done.done);
}

void DrawingRun::draw_while_running(Frame& f) {
  const bool held = f.now.pieces.held;
  const ButtonOptions hold{.icon = held ? Icon::play : Icon::pause,
                           .tip = held ? "" : "Ends what it is at where it can, and begins nothing new.",
                           .height = 40,
                           .moving = held};
  if (button(f.ui, "drawing/hold", held ? "Go on" : "Hold", hold).clicked) {
    if (held)
      f.send(intent::Resume());
    else
      f.send(intent::Pause());
  }
  ImGui::SameLine(0, f.ui.px(8));
  if (button(f.ui, "drawing/stop", "Stop", {.icon = Icon::stop, .height = 40, .stops = true}).clicked)
    f.send(intent::Stop());
}

void DrawingRun::draw_progress(Frame& f) {
  const PiecesState& now = f.now.pieces;
  if (now.total == 0) return;
  progress_.clear();
  const char* what = !now.running && now.done < now.total ? "Stopped in" : now.held ? "Held before" : "At";
  if (now.done == now.total)
    fmt::format_to(std::back_inserter(progress_), "All {} pieces are done", now.total);
  else
    fmt::format_to(std::back_inserter(progress_), "{} piece {} of {}", what, now.done + 1, now.total);
  gap(f.ui, 8);
  meter(f.ui, "drawing/progress", progress_, static_cast<float>(now.done) / static_cast<float>(now.total),
        {.tone = Tone::motion, .old = !now.running});
  gap(f.ui, 4);
  wrapped(f.ui, Face::small, Tone::ink2, progress_);
}

// ---- what is asked, and what comes of it

void DrawingRun::ask(Frame& f, const Wanted& wanted, Cut pieces, int first) {
  asked_ = std::move(pieces);
  first_ = first;
  go_ahead_ = f.tab.desk().until_stopped();
  const std::size_t count = asked_->all.size();
  question_.clear();
  if (first > 0)
    question_ =
        fmt::format("It goes on at piece {} of {}: first to its start, with the tool off.", first + 1, count);
  else
    question_ =
        fmt::format("{}{}{}", count > 1 ? fmt::format("It goes in {} pieces", count) : "It goes in one piece",
                    wanted.time.empty() ? "" : fmt::format(" and takes {}", wanted.time), ".");
  if (asked_->lifts > 0)
    question_ += fmt::format("\nThe tool is lifted {} time{} within what it draws in one go.", asked_->lifts,
                             asked_->lifts == 1 ? "" : "s");
  if (f.catalog.program.capacity > 0)
    question_ += fmt::format("\nWhat the controller holds as {} 0 is replaced.", f.catalog.program.slot_word);
  if (!wanted.tool.empty()) question_ += fmt::format("\n{}", wanted.tool);
  asking_ = true;
}

void DrawingRun::draw_dialog(Frame& f) {
  if (!asking_) return;
  const Dialog what{.title = first_ > 0 ? "Go on with the drawing?" : "Cut the drawing?",
                    .sentences = question_,
                    .yes = first_ > 0 ? "Go on" : "Cut",
                    .moving = true};
  if (dialog(f.ui, "drawing/ask_cut", asking_, what) == Answer::yes) cut(f);
}

/// While the question stood a stop may have come, or something else have begun.
void DrawingRun::cut(Frame& f) {
  if (go_ahead_.expired()) return f.toast(Mood::warn, "A stop came first. Nothing was begun.");
  if (const std::string_view why = why_not_now(f); !why.empty()) return f.toast(Mood::warn, std::string(why));
  cut_ = asked_;
  begun_ = f.send_and_watch(intent::RunInPieces(cut_, first_));
}

void DrawingRun::say_what_came(Frame& f) {
  const IntentFate* fate = f.now.fate_of(begun_);
  if (!fate || fate->fate == Fate::pending) return;
  begun_ = 0;
  if (fate->fate != Fate::done) f.toast(Mood::fault, std::string(fate->sentence.view()));
}

}  // namespace hw::panels
