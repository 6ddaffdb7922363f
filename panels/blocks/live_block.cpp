#include "panels/blocks/live_block.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/sequence/rows_of_rest.h"
#include "gui/model/tab.h"
#include "panels/program/run_bar.h"
#include "panels/program/threads.h"

namespace hw::panels {

using namespace gui;

/// On a controller that runs several programs, the blocks are the first program.
void LiveBlock::follow(Frame& f, const SequenceText& blocks) {
  step_ = -1, words_ = {};
  const ProgramState& p = f.now.program;
  if (!is_under_way(p)) return;
  const ThreadState& thread = f.now.threads.front();
  const bool threads = f.catalog.program.threads > 0;
  const RunFollower::Place place = f.tab.desk().programs.follower.place();
  const RunState run = threads ? thread.run : p.run;
  const int slot = threads ? 0 : place.slot, command = threads ? thread.line : place.command;
  if ((threads && !(thread.known && is_busy(thread))) || slot < 0) return;
  const SequenceText* held = held_in(f, slot, blocks);
  const int line = held ? f.tab.desk().programs.texts.live_line(slot, command) : -1;
  if (line < 0 || ix(line) >= held->step_of_line.size()) return;
  bool leads = false;
  step_ = block_of(held->step_of_line[ix(line)], leads);
  words_ = run == RunState::held           ? "held here"
           : run == RunState::waiting      ? "waits here"
           : leads                         ? "on its way"
           : threads || p.command_reported ? "runs"
                                           : "runs, worked out";
  if (!threads && place.next_in_s > 0 && run == RunState::running) f.ui.wake_in(place.next_in_s + 0.01);
}

const SequenceText* LiveBlock::held_in(Frame& f, int slot, const SequenceText& blocks) {
  Desk& desk = f.tab.desk();
  const std::string& text = desk.programs.texts.text(slot);
  if (text == blocks.text) {
    rest_.reset(), rows_.clear();
    return &blocks;
  }
  const WrittenSequence* source =
      desk.programs.source.of(text, desk.blocks, desk.programs.language(), f.catalog);
  if (!source) return nullptr;
  if (rest_ != source->sequence || whole_ != desk.blocks.editor.shared()) {
    rest_ = source->sequence, whole_ = desk.blocks.editor.shared();
    rows_ = sequence::rows_of_rest(*rest_, *whole_);
    const auto first = std::find_if(rows_.begin(), rows_.end(), [](int row) { return row >= 0; });
    begins_at_ = first == rows_.end() ? -1 : *first;
  }
  return rows_.empty() ? nullptr : &source->written;
}

int LiveBlock::block_of(int step, bool& leads) const {
  if (rows_.empty()) return step;
  const int row = step >= 0 && ix(step) < rows_.size() ? rows_[ix(step)] : -1;
  leads = row < 0;
  return leads ? begins_at_ : row;
}

}  // namespace hw::panels
