#include "panels/drawing/drawing_run.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/piece_sync.h"
#include "core/sequence/places_before.h"
#include "gui/model/run_places.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;

namespace {

/// The state of an axis of the frame's catalog.
const AxisState& axis_state(const Frame& f, int axis) {
  return owner_of(f, axis).now().axes[draws_together(f) ? 0 : ix(axis)];
}

/// Why a controller whose axis draws cannot run; empty: all can.
std::string_view why_not_at_all(const Frame& f, const DrawingJob::Made* made) {
  if (!made) return why_no_pieces(f.tab);
  for (const sequence::Axis& axis : made->conversion.sequence.axes) {
    const int place = f.catalog.find_axis(axis.name);
    if (place < 0) continue;
    if (const std::string_view why = why_no_pieces(owner_of(f, place)); !why.empty()) return why;
    if (!axis_state(f, place).position_known) return position_not_known;
  }
  return {};
}

/// Says the present position, and the way from there to the start of the rest.
std::string way_in_words(const Frame& f, const sequence::Sequence& of, int first_step) {
  const sequence::Places to = places_before(of, {ix(first_step)});
  sequence::Places from;
  for (std::size_t a = 0; a < of.axes.size(); ++a)
    if (const int axis = f.catalog.find_axis(of.axes[a].name); axis >= 0 && to[a])
      from[a] = static_cast<double>(axis_state(f, axis).commanded().value) / of.axes[a].per_unit;
  const std::string there = places_in_words(f, of, to);
  return there.empty()
             ? there
             : fmt::format("\nFirst, with the tool off: from {} to {}.", places_in_words(f, of, from), there);
}

/// The step where the rest of the drawing begins, which all of its controllers have reached; nullopt: nothing
/// is left.
std::optional<int> rest_of(const Frame& f, const DrawingJob::Made* made) {
  if (!made || pieces_of(f).running) return std::nullopt;
  std::optional<int> step;
  const auto take = [&](const PiecesState& p) {
    if (p.rest_of == made->number) step = std::min(step.value_or(p.rest_step), p.rest_step);
  };
  if (!draws_together(f))
    take(f.now.pieces);
  else
    for (const Tab* member : f.tab.bus->members) take(member->now().pieces);
  return step;
}

/// Facts that the user must know before the drawing runs.
std::string first_in_words(const Pieces& pieces, const Catalog& catalog, std::string_view tool) {
  std::string lines;
  if (pieces.lifts > 0)
    lines += fmt::format("\nThe tool is lifted {} time{} within one chain.", pieces.lifts,
                         pieces.lifts == 1 ? "" : "s");
  const bool by_programs =
      std::any_of(pieces.all.begin(), pieces.all.end(), [](const Piece& piece) { return piece.draws < 0; });
  if (!pieces.remark.empty()) lines += fmt::format("\n{}", pieces.remark);
  if (catalog.program.capacity > 0 && pieces.remark.empty() && by_programs)
    lines += fmt::format("\nIt replaces {} 0 in the controller.", catalog.program.slot_word);
  if (!tool.empty()) lines += fmt::format("\n{}", tool);
  return lines;
}

std::string in_pieces(std::size_t count) {
  return count > 1 ? fmt::format("in {} pieces", count) : std::string("in one piece");
}

}  // namespace

const DrawingJob::Made* DrawingRun::at_work(const Frame& f) const {
  const bool another = cut_ && draws_together(f) && f.tab.bus->begun.get() != &cut_->conversion.sequence;
  return cut_ && !another && pieces_of(f).drawing == cut_->number ? cut_.get() : nullptr;
}

void DrawingRun::draw(Frame& f, const Wanted& wanted) {
  report_outcome(f);
  if (pieces_of(f).running)
    draw_while_running(f);
  else
    draw_start(f, wanted);
  draw_progress(f);
  gap(f.ui, 8);
}

/// Why the drawing cannot be cut, at all or because of its closed loops.
std::string_view DrawingRun::why_not_now(const Frame& f, const DrawingJob::Made* made) {
  const Pieces* pieces = made && !made->parts.empty() ? made->parts.front().get() : nullptr;
  const std::uint32_t closed = pieces ? loops_in_the_way(*pieces, f.now) : 0;
  if (std::exchange(closed_loops_, closed) != closed)
    loops_ = closed != 0 ? why_not_begun(*pieces, f.catalog, f.now) : std::string();
  if (const std::string_view why = why_not_at_all(f, made); !why.empty()) return why;
  return loops_;
}

/// Names the loops that prevent cutting, and offers to open them.
void DrawingRun::draw_loops(Frame& f, const Pieces& pieces) {
  if (closed_loops_ == 0) return;
  Ui& ui = f.ui;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::body, Tone::warn, loops_);
  show(ui, {"drawing/loops", Kind::text, "Closed loops", loops_}, {from, ImGui::GetCursorScreenPos()});
  gap(ui, 4);
  const ButtonOptions off{.disabled = why_not_at_all(f, nullptr),
                          .tip = "Positions then count in steps. The loop stays off until you switch it on.",
                          .height = 40};
  if (button(ui, "drawing/open_loops", "Switch it off", off).clicked)
    for (const OpenLoop& loop : pieces.open_loops)
      if ((closed_loops_ >> loop.axis.index & 1u) != 0) f.send(intent::SetParam(loop.parameter, 0));
  gap(ui, 8);
}

void DrawingRun::draw_start(Frame& f, const Wanted& wanted) {
  const bool any = wanted.made && !wanted.made->parts.empty();
  const Pieces* pieces = any ? wanted.made->parts.front().get() : nullptr;
  const std::string_view why = why_not_now(f, wanted.made.get());
  const std::string_view now = working_ ? "Calculating." : why;
  if (pieces) draw_loops(f, *pieces);
  const ButtonOptions options{.icon = Icon::play,
                              .disabled = any || wanted.in_work ? now : wanted.why_not,
                              .tip = any ? wanted.made->written.tool : std::string_view(),
                              .height = 40,
                              .moving = true,
                              .on = waits_};
  waits_ = button(f.ui, "drawing/cut", "Cut", options).clicked || waits_;
  const bool asks = !wanted.in_work && std::exchange(waits_, false);
  if (asks && any && now.empty()) {
    const bool is_sent_first = !wanted.made->with_transfers && f.catalog.program.capacity > 0;
    const std::string time = wanted.time.empty()
                                 ? ""
                                 : fmt::format(", and takes {}{}", wanted.time,
                                               is_sent_first ? " once the controller has it" : "");
    ask(f, What::all, wanted.made, wanted.made->parts,
        fmt::format("The drawing is cut {}, {} move{} in all{}.",
                    in_pieces(wanted.made->parts.front()->all.size()), wanted.moves,
                    wanted.moves == 1 ? "" : "s", time));
  }
  const Made* rest = left(f);
  if (!rest) return;
  ImGui::SameLine(0, f.ui.px(8));
  const ButtonOptions on{
      .disabled = *rest != wanted.made ? "The drawing has changed since." : now,
      .tip = "Goes to the start of the unfinished part with the tool off, and draws the rest.",
      .height = 40,
      .moving = true};
  if (button(f.ui, "drawing/cut_on", "Resume", on).clicked) ask_to_go_on(f);
}

void DrawingRun::draw_while_running(Frame& f) {
  const bool held = pieces_of(f).held;
  const ButtonOptions hold{
      .icon = held ? Icon::play : Icon::pause,
      .tip = held ? "" : "Finishes the present part where possible, and starts no other part.",
      .height = 40,
      .moving = held};
  if (button(f.ui, "drawing/hold", held ? "Resume" : "Hold", hold).clicked) {
    if (held)
      send_to_all(f, intent::Resume());
    else
      send_to_all(f, intent::Pause());
  }
  ImGui::SameLine(0, f.ui.px(8));
  if (button(f.ui, "drawing/stop", "Stop", {.icon = Icon::stop, .height = 40, .stops = true}).clicked) {
    if (draws_together(f))
      f.tab.bus->stop_all();
    else
      f.send(intent::Stop());
  }
  if (pieces_of(f).speed_can_change) draw_override(f);
}

/// Sends the request to each controller that draws.
void DrawingRun::send_to_all(Frame& f, const IntentBody& request) {
  if (draws_together(f))
    f.tab.bus->send_to_pieces(request);
  else
    f.send(request);
}

// ---- questions, and their results

void DrawingRun::ask(Frame& f, What what, Made made, Parts parts, std::string question) {
  asked_.question = std::move(question) + first_in_words(*parts.front(), f.catalog, made->written.tool);
  if (const Conversion& c = made->conversion; !c.off_the_table.empty())
    asked_.question +=
        fmt::format("\n{} of {} chains leave the table.", c.off_the_table.size(), c.chains.size());
  asked_.what = what, asked_.made = std::move(made), asked_.parts = std::move(parts);
  asked_.go_ahead = f.tab.desk().until_stopped();
  asked_.open = true;
}

/// Asks whether to cut the rest, from the start of the interrupted part.
void DrawingRun::ask_to_go_on(Frame& f) {
  if (const Made* rest = left(f)) work_out(f, What::rest, *rest, *rest_of(f, rest->get()));
}

const DrawingRun::Made* DrawingRun::left(const Frame& f) const {
  if (rest_of(f, cut_.get())) return &cut_;
  return rest_of(f, stopped_.get()) ? &stopped_ : nullptr;
}

int DrawingRun::chain_at_work(const Frame& f, const DrawingJob::Made* made) const {
  const PiecesState& now = pieces_of(f);
  if (!made || at_work(f) != made || now.step < 0 || (!now.running && now.done >= now.total)) return -1;
  const std::vector<std::size_t>& begins = made->conversion.begins;
  return static_cast<int>(std::upper_bound(begins.begin(), begins.end(), ix(now.step)) - begins.begin()) - 1;
}

std::string_view DrawingRun::why_no_trace(const Frame& f, const DrawingJob::Made* made) const {
  if (working_) return "Calculating.";
  if (pieces_of(f).running)
    return "The drawing is being cut. Frame is available again when it has ended or was stopped.";
  return why_not_at_all(f, made);
}

void DrawingRun::trace_frame(Frame& f, Made made) { work_out(f, What::frame, std::move(made), 0); }

void DrawingRun::work_out(Frame& f, What what, Made made, int from_step) {
  const Language* language = draws_together(f) ? nullptr : f.tab.desk().programs.language();
  working_ = true;
  f.tab.desk().work.worker().run(
      [what, made, catalog = f.catalog, language, from_step] {
        const Conversion& c = made->conversion;
        const bool frame = what == What::frame;
        return parts_of(frame ? c.frame : c.sequence, catalog, language, from_step, frame ? 0 : made->number);
      },
      [this, what, made, &console = f.console](Result<Parts> parts) {
        working_ = false;
        if (!parts) return console.toast(Severity::fault, parts.error().sentence());
        worked_out_ = {what, made, std::move(*parts)};
      },
      alive_);
  f.ui.wake_in(0);
}

void DrawingRun::draw_dialog(Frame& f) {
  auto [what, made, parts] = std::exchange(worked_out_, {});
  if (!parts.empty() && what == What::frame)
    ask(f, what, std::move(made), std::move(parts),
        fmt::format("The axes go once around the drawing with the tool off, and return to the start.{}",
                    left(f) ? "\nYou can continue the stopped cut afterwards." : ""));
  else if (const Made* rest = left(f); !parts.empty() && rest && *rest == made) {
    std::string question = fmt::format(
        "With the tool off, the axes go to the start of the unfinished part. Then the rest is drawn {}.",
        in_pieces(parts.front()->all.size()));
    question += way_in_words(f, made->conversion.sequence, parts.front()->all.front().first_step);
    ask(f, what, std::move(made), std::move(parts), std::move(question));
  }
  if (!asked_.open) return;
  static constexpr std::array<std::array<std::string_view, 2>, 3> words{
      {{"Cut the drawing?", "Cut"}, {"Resume the drawing?", "Resume"}, {"Trace the frame?", "Trace"}}};
  const auto& [title, yes] = words[static_cast<std::size_t>(asked_.what)];
  const Dialog dialog_of{.title = title, .sentences = asked_.question, .yes = yes, .moving = true};
  if (dialog(f.ui, "drawing/ask_cut", asked_.open, dialog_of) == Answer::yes) cut(f);
}

/// Cuts the drawing, unless a stop came or another run began while the question was open.
void DrawingRun::cut(Frame& f) {
  if (asked_.go_ahead.expired()) return f.toast(Severity::warn, std::string(nothing_started));
  const bool frame = asked_.what == What::frame;
  const std::string_view why =
      frame ? why_not_at_all(f, asked_.made.get()) : why_not_now(f, asked_.made.get());
  if (!why.empty()) return f.toast(Severity::warn, std::string(why));
  traces_ = frame;
  if (!frame) {  // a frame cannot be resumed, and does not replace the rest of a cut
    if (const Made* rest = left(f); rest && *rest != asked_.made) stopped_ = *rest;
    cut_ = asked_.made;
  }
  begun_.clear();
  const Parts& parts = asked_.parts;
  if (!draws_together(f)) {
    begun_.push_back({&f.tab, f.send_and_watch(intent::RunInPieces(parts.front()))});
    return;
  }
  const Conversion& c = asked_.made->conversion;
  traced_ = frame ? &c.frame : nullptr;
  f.tab.bus->begun = {asked_.made, frame ? &c.frame : &c.sequence};
  auto seats = PieceSync::seats(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int axis = f.catalog.find_axis(c.sequence.axes[i].name);
    Tab& owner = owner_of(f, axis);
    begun_.push_back({&owner, owner.send(intent::RunInPieces(parts[i], std::move(seats[i])))});
  }
}

void DrawingRun::report_outcome(Frame& f) {
  std::erase_if(begun_, [&f](const Begun& begun) {
    const IntentOutcome* outcome = begun.by->now().outcome_of(begun.id);
    if (!outcome || outcome->state == IntentState::pending) return false;
    if (outcome->state != IntentState::done) f.toast(Severity::fault, begun.by->messages.words_of(*outcome));
    return true;
  });
}

}  // namespace hw::panels
