#include "panels/blocks/written_blocks.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/track_path.h"
#include "core/sequence/steps_in.h"
#include "panels/blocks/own_texts.h"

namespace hw::panels {
namespace {

/// Removes the name of the step and the colon that writers put before the reason.
std::string as_sentence(std::string why) {
  if (why.empty()) return why;
  why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
  if (std::string_view(".!?").find(why.back()) == std::string_view::npos) why += '.';
  return why;
}

/// Sorts the refusals by block and keeps only the first refusal of each block.
void sort_refused(std::vector<RefusedStep>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const RefusedStep& a, const RefusedStep& b) { return a.step < b.step; });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const RefusedStep& a, const RefusedStep& b) { return a.step == b.step; }),
            all.end());
}

/// Why the text must not be run; empty: it may.
std::string problem_of(const std::vector<RefusedStep>& refused, const ProgramReport& report) {
  if (refused.empty()) {
    const auto found = std::find_if(report.problems.begin(), report.problems.end(),
                                    [](const Problem& p) { return p.error; });
    return found == report.problems.end() ? std::string() : found->sentence;
  }
  if (refused.size() == 1) return refused.front().what;
  return fmt::format("{} {} more {} not written.", refused.front().what, refused.size() - 1,
                     refused.size() == 2 ? "block is" : "blocks are");
}

auto first_from(const std::vector<RefusedStep>& refused, int row) {
  return std::lower_bound(refused.begin(), refused.end(), row,
                          [](const RefusedStep& r, int before) { return r.step < before; });
}

}  // namespace

WrittenBlocks write_blocks(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog) {
  WrittenBlocks made;
  auto written = write_without_bad_texts(language, sequence, catalog);
  if (!written) {
    made.problem = written.error().what;
    return made;
  }
  made.text = std::move(written->text), made.refused = std::move(written->refused);
  made.line_begins.push_back(0);
  for (std::size_t i = 0; i < made.text.text.size(); ++i)
    if (made.text.text[i] == '\n') made.line_begins.push_back(i + 1);
  made.lines_of_step.resize(ix(count_steps(sequence.steps)));
  for (const int step : made.text.step_of_line)
    if (step >= 0 && ix(step) < made.lines_of_step.size()) ++made.lines_of_step[ix(step)];
  sort_refused(made.refused);
  for (RefusedStep& r : made.refused) r.why = as_sentence(std::move(r.why));
  made.problem = problem_of(made.refused, written->report);
  made.step_of_command = lines_of_commands(written->report, 0);
  for (int& line : made.step_of_command) {
    const bool known = line >= 0 && ix(line) < made.text.step_of_line.size();
    line = known ? made.text.step_of_line[ix(line)] : -1;
  }
  for (const auto& [slot, cost] : written->report.cost) made.cost += cost;
  if (!made.text.remarks.empty()) made.remark = made.text.remarks.front();
  return made;
}

const RefusedStep* WrittenBlocks::refusal_of(int row) const {
  const auto found = first_from(refused, row);
  return row >= 0 && found != refused.end() && found->step == row ? &*found : nullptr;
}

int WrittenBlocks::refused_before(int row) const {
  return static_cast<int>(first_from(refused, row) - first_from(refused, 0));
}

}  // namespace hw::panels
