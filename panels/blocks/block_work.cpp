#include "panels/blocks/block_work.h"

#include <utility>

#include "core/base/index.h"
#include "core/device/language.h"
#include "core/device/sequence_draft.h"
#include "core/device/track_path.h"
#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Long, for the worker.
WrittenBlocks write_blocks(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog) {
  WrittenBlocks made;
  auto written = language.write(sequence, catalog);
  if (!written) {
    made.problem = written.error().what;
    made.refused = refused_step(made.problem);
    return made;
  }
  made.text = std::move(*written);
  made.line_begins.push_back(0);
  for (std::size_t i = 0; i < made.text.text.size(); ++i)
    if (made.text.text[i] == '\n') made.line_begins.push_back(i + 1);
  const ProgramReport report = language.analyse(made.text.text, 0);
  for (const Problem& p : report.problems)
    if (p.error && made.problem.empty()) made.problem = p.sentence;
  made.step_of_command = lines_of_commands(report, 0);
  for (int& line : made.step_of_command) {
    const bool known = line >= 0 && ix(line) < made.text.step_of_line.size();
    line = known ? made.text.step_of_line[ix(line)] : -1;
  }
  for (const auto& [slot, cost] : report.cost) made.cost += cost;
  if (!made.text.remarks.empty()) made.remark = made.text.remarks.front();
  return made;
}

}  // namespace

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
