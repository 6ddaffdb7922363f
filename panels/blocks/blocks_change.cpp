// What happens to the blocks: each of it one change that can be taken back.
#include <algorithm>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "panels/blocks/blocks.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

/// Of the ways to begin a block the first that the controller takes at its place; where it takes none, the
/// first, which then says why.
seq::Step::Body first_taken(const Frame& f, const seq::Sequence& s, const seq::StepPath& at,
                            const BlockWays& ways) {
  const auto* writer = dynamic_cast<const PartialWriter*>(f.tab.desk().language());
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
    const auto written = writer->write_what_can_be(trial.sequence(), f.catalog, refused);
    if (written &&
        std::none_of(refused.begin(), refused.end(), [row](const auto& r) { return r.step == row; }))
      return way;
  }
  return ways.front();
}

}  // namespace

/// Behind the chosen block, into a chosen loop, or at the end.
void Blocks::add(Frame& f, const BlockWays& ways) {
  seq::StepPath at{editor_->sequence().steps.size()};
  if (chosen_.any()) {
    const seq::StepSpan span = chosen_.span();
    at = span.first;
    const seq::Step* step = editor_->at(at);
    const auto* loop = step && span.count == 1 ? std::get_if<seq::Repeat>(&step->body) : nullptr;
    if (loop)
      at.push_back(loop->steps.size());
    else
      at.back() += span.count;
  }
  choose(editor_->insert(at, seq::Step{first_taken(f, editor_->sequence(), at, ways)}));
}

void Blocks::choose(std::optional<seq::StepPath> path) {
  chosen_.choose(std::move(path));
  chosen_.follow(*editor_, rows_);
  form_.forget();
}

void Blocks::choose_all(const seq::StepSpan& span) {
  if (span.count == 1) return choose(std::optional(span.first));
  chosen_.choose(span);
  chosen_.follow(*editor_, rows_);
  form_.forget();
}

void Blocks::choose_first_refused() {
  const std::vector<RefusedStep>& refused = work_.written()->refused;
  if (!refused.empty() && work_.up_to_date() && ix(refused.front().step) < rows_.size())
    choose(rows_.path(ix(refused.front().step)));
}

/// Once more: it is not chosen any longer.
void Blocks::click(std::size_t row) {
  if (ImGui::GetIO().KeyShift && chosen_.any()) {
    chosen_.extend(rows_.path(row));
    chosen_.follow(*editor_, rows_);
    return form_.forget();
  }
  const bool alone = chosen_.row() == static_cast<int>(row) && !chosen_.several();
  choose(alone ? std::nullopt : std::optional(rows_.path(row)));
}

/// Up or down among all rows, in and out of loops.
void Blocks::move(int rows) {
  if (!chosen_.any()) return;
  const seq::StepSpan span = chosen_.span();
  seq::StepPath to = span.first;
  if (rows < 0 && to.back() > 0) {
    --to.back();
    const seq::Step* above = editor_->at(to);
    if (const auto* loop = above ? std::get_if<seq::Repeat>(&above->body) : nullptr)
      to.push_back(loop->steps.size());
  } else if (rows < 0) {
    to.pop_back();  // out of its loop, in front of it
  } else {
    to.back() += span.count;
    const seq::Step* below = editor_->at(to);
    if (below && std::holds_alternative<seq::Repeat>(below->body)) {
      to.push_back(0);
    } else if (below) {
      ++to.back();
    } else {
      to.pop_back();  // out of its loop, behind it
      if (!to.empty()) ++to.back();
    }
  }
  if (to.empty()) return;
  if (const auto moved = editor_->move(span, to)) choose_all(seq::StepSpan(*moved, span.count));
}

/// What was carried comes there, with all that is chosen where that is of it; behind a loop is within it.
void Blocks::drop(const RowDrag::Drop& d) {
  if (d.from >= rows_.size() || d.to >= rows_.size()) return;
  seq::StepPath to = rows_.path(d.to);
  const seq::Step* there = editor_->at(to);
  if (d.behind && there && std::holds_alternative<seq::Repeat>(there->body))
    to.push_back(0);
  else if (d.behind)
    ++to.back();
  const bool all = chosen_.several() && chosen_.has_row(static_cast<int>(d.from));
  const seq::StepSpan span = all ? chosen_.span() : seq::StepSpan(rows_.path(d.from));
  if (const auto moved = editor_->move(span, to)) choose_all(seq::StepSpan(*moved, span.count));
}

void Blocks::remove() { choose(editor_->remove(chosen_.span())); }

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
