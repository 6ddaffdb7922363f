#include "panels/drawing_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gui/console.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

namespace {

std::string_view why_not_now(const Frame& f) {
  if (!f.connected()) return "There is no link. Cut comes back when the controller answers.";
  if (f.tab.desk().job.busy()) return "A program is being transferred.";
  const ProgramState& p = f.now.program;
  if (p.owned && p.run != RunState::idle && p.run != RunState::error)
    return "A program is at work. Cut comes back when it has ended or was stopped.";
  return f.tab.why_not_move();
}

bool was_stopped(const PiecesState& p) { return !p.running && p.step >= 0 && p.done < p.total; }

/// What is to be known before any of it runs.
std::string said_first(const Pieces& pieces, const Catalog& catalog, std::string_view tool) {
  std::string said;
  if (pieces.lifts > 0)
    said += fmt::format("\nThe tool is lifted {} time{} within what it draws in one go.", pieces.lifts,
                        pieces.lifts == 1 ? "" : "s");
  const bool by_programs =
      std::any_of(pieces.all.begin(), pieces.all.end(), [](const Piece& piece) { return piece.draws < 0; });
  if (!pieces.remark.empty()) said += fmt::format("\n{}", pieces.remark);
  if (catalog.program.capacity > 0 && pieces.remark.empty() && by_programs)
    said += fmt::format("\nWhat the controller holds as {} 0 is replaced.", catalog.program.slot_word);
  if (!tool.empty()) said += fmt::format("\n{}", tool);
  return said;
}

std::string in_pieces(std::size_t count) {
  return count > 1 ? fmt::format("in {} pieces", count) : std::string("in one piece");
}

}  // namespace

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
  const std::string_view now = working_ ? "It is being worked out." : why_not_now(f);
  const bool any = wanted.made && wanted.made->pieces;
  const ButtonOptions options{.icon = Icon::play,
                              .disabled = any || wanted.in_work ? now : wanted.why_not,
                              .tip = any ? wanted.made->written.tool : std::string_view(),
                              .height = 40,
                              .moving = true,
                              .on = waits_};
  waits_ = button(f.ui, "drawing/cut", "Cut", options).clicked || waits_;
  const bool asks = !wanted.in_work && std::exchange(waits_, false);
  if (asks && any && now.empty()) {
    const std::string time = wanted.time.empty() ? "" : fmt::format(" and takes {}", wanted.time);
    asked_.goes_on = false;
    ask(f, wanted.made, wanted.made->pieces,
        fmt::format("It goes {}{}.", in_pieces(wanted.made->pieces->all.size()), time));
  }
  if (!cut_ || !was_stopped(f.now.pieces)) return;
  ImGui::SameLine(0, f.ui.px(8));
  const ButtonOptions on{
      .disabled = cut_ != wanted.made ? "The drawing has changed since." : now,
      .tip = "Goes to the start of what was being drawn, with the tool off, and draws the rest.",
      .height = 40,
      .moving = true};
  if (button(f.ui, "drawing/cut_on", "Go on", on).clicked) ask_to_go_on(f);
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
  if (f.now.pieces.speed_can_change) draw_override(f);
}

void DrawingRun::draw_override(Frame& f) {
  double percent = f.now.pieces.percent;
  speed_.clear();
  fmt::format_to(std::back_inserter(speed_), "Speed: {:.0f} % of what was asked for", percent);
  gap(f.ui, 8);
  wrapped(f.ui, Face::small, Tone::ink2, speed_);
  const SliderOptions o{.min = 10,
                        .max = 200,
                        .step = 10,
                        .normal = 100,
                        .tip = f.now.pieces.draws ? "Holds for what is sent from now on."
                                                  : "Holds from the next piece on.",
                        .value_text = speed_};
  if (slider(f.ui, "drawing/override", "Speed", percent, o))
    f.send(intent::OverrideSpeed(static_cast<int>(std::lround(percent))));
}

/// By steps of the drawing where they are known: pieces differ in length.
void DrawingRun::draw_progress(Frame& f) {
  const PiecesState& now = f.now.pieces;
  if (now.total == 0) return;
  progress_.clear();
  const char* what = was_stopped(now) ? "Stopped in"
                     : !now.held      ? "At"
                     : now.draws      ? "Held in"
                                      : "Held before";
  if (now.done == now.total)
    fmt::format_to(std::back_inserter(progress_), "All {} pieces are done", now.total);
  else
    fmt::format_to(std::back_inserter(progress_), "{} piece {} of {}", what, now.done + 1, now.total);
  const auto steps = cut_ ? cut_->conversion.sequence.steps.size() : 0;
  const double share = now.done == now.total ? 1
                       : steps > 0 && now.step > 0
                           ? static_cast<double>(now.step) / static_cast<double>(steps)
                           : static_cast<double>(now.done) / static_cast<double>(now.total);
  gap(f.ui, 8);
  meter(f.ui, "drawing/cut_progress", "Progress", static_cast<float>(std::min(share, 1.0)),
        {.tone = Tone::motion, .old = !now.running, .words = progress_});
  gap(f.ui, 4);
  wrapped(f.ui, Face::small, Tone::ink2, progress_);
}

// ---- what is asked, and what comes of it

void DrawingRun::ask(Frame& f, Made made, Cut pieces, std::string question) {
  asked_.question = std::move(question) + said_first(*pieces, f.catalog, made->written.tool);
  asked_.made = std::move(made), asked_.pieces = std::move(pieces);
  asked_.go_ahead = f.tab.desk().until_stopped();
  asked_.open = true;
}

/// What is left is cut anew: from the start of what was being drawn.
void DrawingRun::ask_to_go_on(Frame& f) {
  const Language* language = f.tab.desk().language();
  if (!language) return;
  working_ = true;
  const int step = f.now.pieces.step;
  f.tab.desk().worker().run([made = cut_, catalog = f.catalog, language,
                             step] { return language->in_pieces(made->conversion.sequence, catalog, step); },
                            [this, &console = f.console](Result<Pieces> left) {
                              working_ = false;
                              if (!left) return console.toast(Mood::fault, left.error().sentence());
                              left_ = std::make_shared<const Pieces>(std::move(*left));
                            },
                            alive_);
  f.ui.wake_in(0);
}

void DrawingRun::draw_dialog(Frame& f) {
  if (const Cut left = std::exchange(left_, nullptr); left && was_stopped(f.now.pieces)) {
    asked_.goes_on = true;
    ask(f, cut_, left,
        fmt::format("The tool goes to the start of what was being drawn, off, and draws the rest {}.",
                    in_pieces(left->all.size())));
  }
  if (!asked_.open) return;
  const Dialog what{.title = asked_.goes_on ? "Go on with the drawing?" : "Cut the drawing?",
                    .sentences = asked_.question,
                    .yes = asked_.goes_on ? "Go on" : "Cut",
                    .moving = true};
  if (dialog(f.ui, "drawing/ask_cut", asked_.open, what) == Answer::yes) cut(f);
}

/// While the question stood a stop may have come, or something else have begun.
void DrawingRun::cut(Frame& f) {
  if (asked_.go_ahead.expired()) return f.toast(Mood::warn, "A stop came first. Nothing was begun.");
  if (const std::string_view why = why_not_now(f); !why.empty()) return f.toast(Mood::warn, std::string(why));
  cut_ = asked_.made;
  begun_ = f.send_and_watch(intent::RunInPieces(asked_.pieces));
}

void DrawingRun::say_what_came(Frame& f) {
  const IntentFate* fate = f.now.fate_of(begun_);
  if (!fate || fate->fate == Fate::pending) return;
  begun_ = 0;
  if (fate->fate != Fate::done) f.toast(Mood::fault, std::string(fate->sentence.view()));
}

}  // namespace hw::panels
