// Changes the blocks. Each change can be undone as a whole.
#include <algorithm>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"
#include "gui/model/tab.h"
#include "panels/blocks/blocks.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

/// The first candidate that the controller accepts at this place. If it accepts none, the first candidate,
/// which shows the reason.
seq::Step::Body first_taken(const Frame& f, const seq::Sequence& s, const seq::StepPath& at,
                            const BlockCandidates& ways) {
  const auto* writer = dynamic_cast<const PartialWriter*>(f.tab.desk().programs.language());
  constexpr std::size_t soon_written = 500;
  if (!writer || ways.size() < 2) return ways.front();
  const bool long_list = s.steps.size() > soon_written;
  for (const seq::Step::Body& way : ways) {
    seq::Editor trial;
    trial.load(long_list ? seq::frame_of(s) : s);
    const auto placed = trial.insert(long_list ? seq::StepPath{0} : at, seq::Step{way});
    BlockRows rows;
    rows.follow(trial);
    const int row = rows.row_of(placed);
    std::vector<RefusedStep> refused;
    const auto written = writer->write_with_gaps(trial.sequence(), f.catalog, refused);
    if (written &&
        std::none_of(refused.begin(), refused.end(), [row](const auto& r) { return r.step == row; }))
      return way;
  }
  return ways.front();
}

}  // namespace

/// Adds a block after the chosen block, into a chosen loop or contour, or at the end.
void Blocks::add(Frame& f, const BlockCandidates& ways) {
  seq::StepPath at{editor_->sequence().steps.size()};
  if (chosen_.any()) {
    const seq::StepSpan span = chosen_.span();
    at = span.first;
    const seq::Step* step = editor_->at(at);
    const seq::StepList* inner = step && span.count == 1 ? steps_in(*step) : nullptr;
    if (inner)
      at.push_back(inner->size());
    else
      at.back() += span.count;
  }
  choose(editor_->insert(at, seq::Step{first_taken(f, editor_->sequence(), at, ways)}));
}

/// Rejected input stays with its block.
void Blocks::put_form_away() {
  StepForm::Draft left = form_.leave();
  if (chosen_.any()) drafts_.keep(*chosen_.head(), std::move(left));
}

void Blocks::open_form() {
  chosen_.follow(*editor_, rows_);
  drafts_.follow(*editor_, rows_);
  if (chosen_.any() && !chosen_.several()) form_.take_up(drafts_.take(*chosen_.head()));
}

void Blocks::choose(std::optional<seq::StepPath> path) {
  put_form_away();
  chosen_.choose(std::move(path));
  open_form();
}

void Blocks::choose_all(const seq::StepSpan& span) {
  if (span.count == 1) return choose(std::optional(span.first));
  put_form_away();
  chosen_.choose(span);
  open_form();
}

/// Chooses the moved blocks at their new place.
void Blocks::choose_moved(const seq::StepSpan& span) {
  chosen_.follow(*editor_, rows_);
  drafts_.follow(*editor_, rows_);  // drafts must follow their blocks before another draft takes an old place
  drafts_.keep(span.first, form_.leave());
  choose_all(span);
}

void Blocks::bring_up(const Frame& f, seq::StepPath path) {
  sides_.show_list(f);
  choose(std::move(path));
}

void Blocks::choose_first_refused(const Frame& f) {
  const std::vector<RefusedStep>& refused = work_.written()->refused;
  if (!refused.empty() && work_.up_to_date() && ix(refused.front().step) < rows_.size())
    bring_up(f, rows_.path(ix(refused.front().step)));
}

/// A second click clears the choice.
void Blocks::click(std::size_t row) {
  if (ImGui::GetIO().KeyShift && chosen_.any()) {
    put_form_away();
    chosen_.extend(rows_.path(row));
    return open_form();
  }
  const bool alone = chosen_.row() == static_cast<int>(row) && !chosen_.several();
  choose(alone ? std::nullopt : std::optional(rows_.path(row)));
}

/// Moves the chosen blocks up or down across all rows, into and out of loops and contours.
void Blocks::move(int rows) {
  if (!chosen_.any()) return;
  const seq::StepSpan span = chosen_.span();
  seq::StepPath to = span.first;
  if (rows < 0 && to.back() > 0) {
    --to.back();
    const seq::Step* above = editor_->at(to);
    if (const seq::StepList* inner = above ? steps_in(*above) : nullptr) to.push_back(inner->size());
  } else if (rows < 0) {
    to.pop_back();  // out of its loop, before it
  } else {
    to.back() += span.count;
    const seq::Step* below = editor_->at(to);
    if (below && steps_in(*below)) {
      to.push_back(0);
    } else if (below) {
      ++to.back();
    } else {
      to.pop_back();  // out of its loop, after it
      if (!to.empty()) ++to.back();
    }
  }
  if (to.empty()) return;
  if (const auto moved = editor_->move(span, to)) choose_moved(seq::StepSpan(*moved, span.count));
}

/// Drops the carried block there, with the other chosen blocks if it is chosen. After the row of a loop or
/// contour means inside it.
void Blocks::drop(const RowDrag::Drop& d) {
  if (d.from >= rows_.size() || d.to >= rows_.size()) return;
  seq::StepPath to = rows_.path(d.to);
  const seq::Step* there = editor_->at(to);
  if (d.behind && there && steps_in(*there))
    to.push_back(0);
  else if (d.behind)
    ++to.back();
  const bool all = chosen_.several() && chosen_.has_row(static_cast<int>(d.from));
  const bool open = is_open(d.from);
  const seq::StepSpan span = all ? chosen_.span() : seq::StepSpan(rows_.path(d.from));
  if (!open) put_form_away();
  if (const auto moved = editor_->move(span, to))
    choose_moved(seq::StepSpan(*moved, span.count));
  else if (!open)
    open_form();
}

void Blocks::remove() {
  form_.forget();
  choose(editor_->remove(chosen_.span()));
}

void Blocks::take_back() {
  form_.forget();
  editor_->undo(), choose(chosen_.head());
}
void Blocks::make_again() {
  form_.forget();
  editor_->redo(), choose(chosen_.head());
}

void Blocks::duplicate() {
  const seq::StepSpan span = chosen_.span();
  if (const auto again = editor_->duplicate(span)) choose_all(seq::StepSpan(*again, span.count));
}

void Blocks::put_into_loop() {
  if (const auto loop = editor_->put_into_loop(chosen_.span())) choose(loop);
}

void Blocks::skip(bool skipped) {
  const seq::StepSpan span = chosen_.span();
  if (editor_->skip(span, skipped)) choose_all(span);
}

}  // namespace hw::panels
