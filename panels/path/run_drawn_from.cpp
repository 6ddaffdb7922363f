#include "panels/path/run_drawn_from.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/piece_sync.h"
#include "core/device/pieces_together.h"
#include "core/sequence/places_before.h"
#include "core/sequence/words.h"
#include "gui/model/run_places.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/surface/ui.h"
#include "gui/widgets/message.h"
#include "panels/drawing/drawn_together.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

sequence::Places drawn_from(const Frame& f, const sequence::Sequence& of) {
  sequence::Places places;
  for (std::size_t a = 0; a < of.axes.size(); ++a)
    if (const int axis = f.catalog.find_axis(of.axes[a].name); axis >= 0)
      places[a] =
          static_cast<double>(owner_of(f, axis).now().axes[0].commanded().value) / of.axes[a].per_unit;
  return places;
}

int first_step_of(const std::vector<Pieces>& parts) {
  return parts.empty() || parts.front().all.empty() ? 0 : std::max(0, parts.front().all.front().first_step);
}

}  // namespace

std::string_view why_not_run_drawn(const Frame& f, const DrawnTogether& drawn) {
  if (!draws_together(f) || !drawn.sequence) return "There is no drawing.";
  if (pieces_of(f).running) return "Stop the drawing first: it is being cut.";
  for (const sequence::Axis& axis : drawn.sequence->axes) {
    const int place = f.catalog.find_axis(axis.name);
    if (place < 0) return "One of its axes is not on this bus.";
    Tab& owner = owner_of(f, place);
    if (const std::string_view why = why_no_pieces(owner); !why.empty()) return why;
    if (!owner.now().axes[0].position_known) return position_not_known;
  }
  return {};
}

/// The worker prepares the pieces of each controller, because the drawing may be long.
void RunDrawnFrom::ask(Frame& f, const DrawnTogether& drawn, int step) {
  if (std::exchange(working_, true)) return;
  drawn_ = drawn;
  go_ahead_ = f.tab.desk().until_stopped();
  f.tab.desk().work.worker().run(
      [sequence = drawn.sequence, bus = std::make_shared<const Catalog>(f.catalog), step] {
        return pieces_together(*sequence, *bus, step);
      },
      [this](Result<Parts> parts) { worked_out_ = std::move(parts), working_ = false; }, alive_);
  f.ui.wake_in(0);
}

void RunDrawnFrom::take(Frame& f, Result<Parts> parts) {
  if (!parts) return f.toast(Severity::warn, parts.error().sentence());
  parts_ = std::move(*parts);
  compose_question(f);
  asking_ = true;
}

void RunDrawnFrom::compose_question(const Frame& f) {
  const sequence::Sequence& of = *drawn_.sequence;
  const int first = first_step_of(parts_);
  question_ = fmt::format("The axes stand here: {}.\n", places_in_words(f, of, drawn_from(f, of)));
  if (const std::string to = places_in_words(f, of, sequence::places_before(of, {ix(first)})); !to.empty())
    question_ += fmt::format("First, with the tool off: to {}.\n", to);
  question_ += fmt::format("Then step {} of {}", first + 1, drawn_.name);
  if (ix(first) < of.steps.size())
    question_ += fmt::format(", {} {}", sequence::title_of(of.steps[ix(first)].body),
                             sequence::summary_of(of.steps[ix(first)].body, of));
  question_ += ", and everything after it.";
  if (!parts_.empty() && !parts_.front().remark.empty()) question_ += "\n" + parts_.front().remark;
}

/// Begins, unless a stop came or another run began while the question was open.
void RunDrawnFrom::begin(Frame& f) {
  if (go_ahead_.expired()) return f.toast(Severity::warn, std::string(nothing_started));
  if (const std::string_view why = why_not_run_drawn(f, drawn_); !why.empty())
    return f.toast(Severity::warn, std::string(why));
  f.tab.bus->begun = drawn_.sequence;
  begun_.clear();
  auto seats = PieceSync::seats(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Tab& owner = owner_of(f, f.catalog.find_axis(drawn_.sequence->axes[i].name));
    parts_[i].drawing = drawn_.pieces;
    auto pieces = std::make_shared<const Pieces>(std::move(parts_[i]));
    begun_.push_back({&owner, owner.send(intent::RunInPieces(std::move(pieces), std::move(seats[i])))});
  }
}

void RunDrawnFrom::report_outcome(Frame& f) {
  std::erase_if(begun_, [&f](const Begun& begun) {
    const IntentOutcome* outcome = begun.by->now().outcome_of(begun.id);
    if (!outcome || outcome->state == IntentState::pending) return false;
    if (outcome->state != IntentState::done) f.toast(Severity::fault, begun.by->messages.words_of(*outcome));
    return true;
  });
}

void RunDrawnFrom::draw_dialog(Frame& f, std::string_view where) {
  report_outcome(f);
  if (auto parts = std::exchange(worked_out_, std::nullopt)) take(f, std::move(*parts));
  if (!asking_) return;
  const Dialog what{.title = "Run from here?",
                    .sentences = question_,
                    .yes = "Go there and run",
                    .no = "Leave it",
                    .moving = true};
  if (dialog(f.ui, Path("{}/run_from", where), asking_, what) == Answer::yes) begin(f);
}

std::optional<drawing::Point3> RunDrawnFrom::goes_to(const Frame& f, const PathAxes& axes) const {
  if (!asking_) return std::nullopt;
  auto at = place_now(f, axes);
  if (!at) return std::nullopt;
  const sequence::Sequence& of = *drawn_.sequence;
  const sequence::Places to = sequence::places_before(of, {ix(first_step_of(parts_))});
  const Directions all = directions_of(f, axes);
  for (std::size_t n = 0; n < all.count; ++n)
    for (std::size_t a = 0; a < of.axes.size(); ++a)
      if (all.all[n].tab && of.axes[a].name == all.all[n].name && to[a])
        along(*at, n) = from_steps(Steps(std::llround(*to[a] * of.axes[a].per_unit)), all.all[n].unit());
  return at;
}

}  // namespace hw::panels
