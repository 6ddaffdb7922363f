#pragma once
// Keeps the unsaved program texts and blocks of one controller through a crash, see Autosave. GUI thread.
#include <cstdint>
#include <string>

#include "core/session/autosave.h"
#include "gui/model/block_list.h"
#include "gui/model/desk_work.h"
#include "gui/model/program_texts.h"

namespace hw::gui {

class KeptTexts {
 public:
  /// All must outlive this object.
  KeptTexts(ProgramTexts& texts, BlockList& blocks, DeskWork& work);

  /// Keeps unsaved texts and blocks under `key` from now on, and restores those of the last session. A fault:
  /// their file was damaged, and nothing was restored.
  Result<> begin(Autosave autosave, std::string key);
  /// Once a frame: keeps edits that are a second old.
  void follow(Instant clock);
  /// Keeps the latest edits without waiting. The worker may still have to write them.
  void keep_now();
  /// Seconds until follow() wants a frame; negative: it does not.
  [[nodiscard]] double due_in(Instant clock) const;

 private:
  [[nodiscard]] std::uint64_t typed() const { return texts_.changes() + blocks_.changes(); }
  [[nodiscard]] bool all_kept() const { return !autosave_.enabled() || typed() == saved_; }

  ProgramTexts& texts_;
  BlockList& blocks_;
  DeskWork& work_;
  Autosave autosave_{UserFolders::none()};
  std::string key_;
  std::uint64_t saved_ = 0;  ///< of typed()
  Instant changed_at_{};
  bool dirty_ = false;
};

}  // namespace hw::gui
