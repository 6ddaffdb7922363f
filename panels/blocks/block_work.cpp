#include "panels/blocks/block_work.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/language.h"
#include "core/device/track_path.h"
#include "core/sequence/steps_in.h"
#include "gui/model/tab.h"
#include "gui/surface/ui.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Some languages say only the first one.
Result<SequenceText> write_what_can_be(const Language& language, const sequence::Sequence& sequence,
                                       const Catalog& catalog, std::vector<RefusedStep>& refused) {
  if (const auto* partial = dynamic_cast<const PartialWriter*>(&language))
    return partial->write_what_can_be(sequence, catalog, refused);
  return language.write(sequence, catalog);
}

const sequence::Step* step_at(const sequence::StepList& steps, int& index) {
  for (const sequence::Step& step : steps) {
    if (index-- == 0) return &step;
    const sequence::StepList* inner = steps_in(step);
    if (const sequence::Step* found = inner ? step_at(*inner, index) : nullptr) return found;
  }
  return nullptr;
}

/// Texts that people have typed may hold errors; what a line costs too much is no fault of its block.
void find_errors(const ProgramReport& report, const sequence::Sequence& sequence, WrittenBlocks& made) {
  for (const Problem& p : report.problems) {
    if (!p.error) continue;
    if (made.problem.empty()) made.problem = p.sentence;
    int index = ix(p.line) < made.text.step_of_line.size() ? made.text.step_of_line[ix(p.line)] : -1;
    const int step = index;
    const sequence::Step* own = index < 0 ? nullptr : step_at(sequence.steps, index);
    if (own && std::holds_alternative<sequence::Custom>(own->body))
      made.refused.push_back({step, "text", p.sentence, p.sentence, {}});
  }
}

/// In order, and of each block the first.
void sort_refused(std::vector<RefusedStep>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const RefusedStep& a, const RefusedStep& b) { return a.step < b.step; });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const RefusedStep& a, const RefusedStep& b) { return a.step == b.step; }),
            all.end());
}

/// Long, for the worker.
WrittenBlocks write_blocks(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog) {
  WrittenBlocks made;
  auto written = write_what_can_be(language, sequence, catalog, made.refused);
  if (!written) {
    made.problem = written.error().what;
    return made;
  }
  made.text = std::move(*written);
  made.line_begins.push_back(0);
  for (std::size_t i = 0; i < made.text.text.size(); ++i)
    if (made.text.text[i] == '\n') made.line_begins.push_back(i + 1);
  made.lines_of_step.resize(ix(count_steps(sequence.steps)));
  for (const int step : made.text.step_of_line)
    if (step >= 0 && ix(step) < made.lines_of_step.size()) ++made.lines_of_step[ix(step)];
  const ProgramReport report = language.analyse(made.text.text, 0);
  sort_refused(made.refused);
  if (!made.refused.empty()) made.problem = made.refused.front().what;
  find_errors(report, sequence, made);
  sort_refused(made.refused);
  if (made.refused.size() > 1)
    made.problem += fmt::format(" {} more {} not written.", made.refused.size() - 1,
                                made.refused.size() == 2 ? "block is" : "blocks are");
  made.step_of_command = lines_of_commands(report, 0);
  for (int& line : made.step_of_command) {
    const bool known = line >= 0 && ix(line) < made.text.step_of_line.size();
    line = known ? made.text.step_of_line[ix(line)] : -1;
  }
  for (const auto& [slot, cost] : report.cost) made.cost += cost;
  if (!made.text.remarks.empty()) made.remark = made.text.remarks.front();
  return made;
}

auto first_from(const std::vector<RefusedStep>& refused, int row) {
  return std::lower_bound(refused.begin(), refused.end(), row,
                          [](const RefusedStep& r, int before) { return r.step < before; });
}

}  // namespace

const RefusedStep* WrittenBlocks::refusal_of(int row) const {
  const auto found = first_from(refused, row);
  return row >= 0 && found != refused.end() && found->step == row ? &*found : nullptr;
}

int WrittenBlocks::refused_before(int row) const {
  return static_cast<int>(first_from(refused, row) - first_from(refused, 0));
}

void BlockWork::follow(Frame& f, const sequence::Editor& editor) {
  wanted_ = editor.version();
  if (up_to_date() || *under_way_ > 0) return;
  Desk& desk = f.tab.desk();
  const Language* language = desk.language();
  if (!language) {
    WrittenBlocks none;
    none.version = wanted_;
    none.problem = "This controller has no language that blocks could be written in.";
    written_ = std::make_shared<const WrittenBlocks>(std::move(none));
    return;
  }
  if (!catalog_) catalog_ = std::make_shared<const Catalog>(f.catalog);
  ++*under_way_;
  desk.worker().run(
      [language, catalog = catalog_, sequence = editor.shared(), version = wanted_] {
        WrittenBlocks made = write_blocks(*language, *sequence, *catalog);
        made.version = version;
        return made;
      },
      [this, under_way = under_way_.get()](WrittenBlocks made) {
        --*under_way;
        written_ = std::make_shared<const WrittenBlocks>(std::move(made));
      },
      under_way_);
  f.ui.wake_in(0);
}

std::string_view BlockWork::why_none(const sequence::Editor& editor) const {
  if (editor.sequence().steps.empty()) return "There are no blocks yet.";
  if (!up_to_date()) return "Their text is being written.";
  return written_->problem;
}

}  // namespace hw::panels
