#include "gui/model/kept_texts.h"

#include <algorithm>
#include <utility>

namespace hw::gui {

// Short enough that a crash costs a word or two, long enough that not every key press writes a file.
static constexpr Duration kept_after = Millis(1000);

KeptTexts::KeptTexts(ProgramTexts& texts, BlockList& blocks, DeskWork& work)
    : texts_(texts), blocks_(blocks), work_(work) {}

Result<> KeptTexts::begin(Autosave autosave, std::string key) {
  autosave_ = std::move(autosave);
  key_ = std::move(key);
  const auto restored = autosave_.restore(key_);
  if (!restored) return fail(restored.error());
  texts_.restore(*restored);
  const Result<> blocks_restored = blocks_.restore(*restored);
  saved_ = typed();
  return blocks_restored;
}

void KeptTexts::follow(Instant clock) {
  if (all_kept()) return;
  if (!dirty_) {
    dirty_ = true;
    changed_at_ = clock;
  }
  if (clock - changed_at_ >= kept_after) keep_now();
}

void KeptTexts::keep_now() {
  if (all_kept()) return;
  dirty_ = false;
  saved_ = typed();
  work_.worker().run(
      [autosave = autosave_, key = key_, unsaved = texts_.unsaved(),
       of_blocks = blocks_.unsaved()]() mutable {
        if (of_blocks) unsaved.push_back(of_blocks->text());
        // a full disk is reported on save; here it would only nag
        return autosave.keep(key, unsaved);
      },
      [](Result<>) {}, work_.alive());
}

double KeptTexts::due_in(Instant clock) const {
  return dirty_ ? std::max(0.0, seconds(kept_after - (clock - changed_at_))) : -1;
}

}  // namespace hw::gui
