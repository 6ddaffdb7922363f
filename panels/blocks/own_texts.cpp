#include "panels/blocks/own_texts.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/fields.h"
#include "core/sequence/steps_in.h"

namespace hw::panels {

namespace seq = sequence;
namespace {

/// Some languages report only the first step that they refuse.
Result<WrittenText> written_of(const Language& language, const seq::Sequence& sequence,
                               const Catalog& catalog) {
  WrittenText made;
  const auto* partial = dynamic_cast<const PartialWriter*>(&language);
  auto text =
      partial ? partial->write_with_gaps(sequence, catalog, made.refused) : language.write(sequence, catalog);
  if (!text) return tl::unexpected(text.error());
  made.text = std::move(*text);
  made.report = language.analyse(made.text.text, 0);
  return made;
}

/// A step as a row of the list, as SequenceText counts it, and as the user counts it: "3.2".
struct RowStep {
  seq::Step* step;
  std::string number;
};
void add_rows(seq::StepList& steps, const std::string& before, std::vector<RowStep>& rows) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    rows.push_back({&steps[i], fmt::format("{}{}", before, i + 1)});
    if (seq::StepList* inner = steps_in(steps[i])) add_rows(*inner, rows.back().number + ".", rows);
  }
}

bool has_own_text(const seq::StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const seq::Step& step) {
    const seq::StepList* inner = steps_in(step);
    return std::holds_alternative<seq::Custom>(step.body) || (inner && has_own_text(*inner));
  });
}

std::ptrdiff_t errors_in(const ProgramReport& report) {
  return std::count_if(report.problems.begin(), report.problems.end(),
                       [](const Problem& p) { return p.error; });
}

bool fits(const ProgramReport& report, const Catalog& catalog) {
  return std::all_of(report.cost.begin(), report.cost.end(), [&](const auto& slot) {
    return catalog.program.capacity <= 0 || slot.second <= catalog.program.capacity;
  });
}

class OwnTexts {
 public:
  OwnTexts(const Language& language, const seq::Sequence& sequence, const Catalog& catalog)
      : language_(language), catalog_(catalog), kept_(sequence) {
    add_rows(kept_.steps, "", rows_);
  }

  Result<WrittenText> write() {
    auto written = written_of(language_, kept_, catalog_);
    while (written && (leave_out_marked(*written) || leave_out_cause(*written)))
      written = written_of(language_, kept_, catalog_);
    if (written) written->refused.insert(written->refused.end(), refused_.begin(), refused_.end());
    return written;
  }

 private:
  [[nodiscard]] bool is_own(int row) const {
    if (row < 0 || ix(row) >= rows_.size() || rows_[ix(row)].step->skipped) return false;
    const seq::Step::Body& body = rows_[ix(row)].step->body;
    const auto* tool = std::get_if<seq::Pen>(&body);
    return std::holds_alternative<seq::Custom>(body) ||
           (tool && has_own_text(tool->down ? kept_.pen_down : kept_.pen_up));
  }
  static int row_of(const Problem& problem, const SequenceText& text) {
    const bool known = problem.line >= 0 && ix(problem.line) < text.step_of_line.size();
    return known ? text.step_of_line[ix(problem.line)] : -1;
  }

  /// Leaves out the steps that have an error. A line that exceeds the memory is not an error of its block.
  bool leave_out_marked(const WrittenText& written) {
    bool any = false;
    for (const Problem& problem : written.report.problems) {
      const int row = problem.error ? row_of(problem, written.text) : -1;
      if (!is_own(row)) continue;
      const std::vector<int>& steps = written.text.step_of_line;
      const auto first = std::find(steps.begin(), steps.end(), row) - steps.begin();
      const auto* own = std::get_if<seq::Custom>(&rows_[ix(row)].step->body);
      const bool several = own && own->text.find('\n') != own->text.npos;
      leave_out(row, several ? fmt::format("Line {}: {}", problem.line - first + 1, problem.sentence)
                             : problem.sentence);
      any = true;
    }
    return any;
  }

  /// Leaves out a step that causes an error elsewhere: a step without which there are fewer errors.
  bool leave_out_cause(const WrittenText& written) {
    constexpr int most_tried = 24;
    const std::ptrdiff_t errors = errors_in(written.report);
    if (errors == 0 || !fits(written.report, catalog_)) return false;
    int tried = 0;
    for (int row = 0; ix(row) < rows_.size() && tried < most_tried; ++row) {
      if (!is_own(row)) continue;
      ++tried;
      const seq::Step::Body own = std::exchange(rows_[ix(row)].step->body, in_its_place(row));
      const auto without = written_of(language_, kept_, catalog_);
      rows_[ix(row)].step->body = own;
      if (!without || errors_in(without->report) >= errors) continue;
      const Problem& error = *std::find_if(written.report.problems.begin(), written.report.problems.end(),
                                           [](const Problem& p) { return p.error; });
      const int at = row_of(error, written.text);
      leave_out(row, at < 0 ? fmt::format("The program cannot be written with it: {}", error.sentence)
                            : fmt::format("Block {} cannot be written with it: {}", rows_[ix(at)].number,
                                          error.sentence));
      return true;
    }
    return false;
  }

  [[nodiscard]] seq::Comment in_its_place(int row) const {
    return {fmt::format("block {} is not written", rows_[ix(row)].number)};
  }
  void leave_out(int row, std::string why) {
    seq::Step::Body& body = rows_[ix(row)].step->body;
    const bool all_of_it = std::holds_alternative<seq::Custom>(body);
    refused_.push_back(
        {row,
         all_of_it ? "text" : "",
         fmt::format("Step {} ({}): {}", rows_[ix(row)].number, seq::kind_names[body.index()], why),
         why,
         {}});
    body = in_its_place(row);
  }

  const Language& language_;
  const Catalog& catalog_;
  seq::Sequence kept_;
  std::vector<RowStep> rows_;  ///< rows of `kept_`, whose lists stay unchanged
  std::vector<RefusedStep> refused_;
};

}  // namespace

Result<WrittenText> write_without_bad_texts(const Language& language, const seq::Sequence& sequence,
                                            const Catalog& catalog) {
  auto written = written_of(language, sequence, catalog);
  if (!written || errors_in(written->report) == 0) return written;
  return OwnTexts(language, sequence, catalog).write();
}

}  // namespace hw::panels
