#pragma once
// The user's work with the programs of one controller: their texts, jobs on them, dry runs, the place of a
// running one. GUI thread.
#include <cstdint>
#include <functional>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "gui/model/program_job.h"
#include "gui/model/program_source.h"
#include "gui/model/program_texts.h"
#include "gui/model/rehearsal_requests.h"
#include "gui/model/rehearsals.h"
#include "gui/model/run_follower.h"

namespace hw::gui {

class ProgramDesk {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// `catalog` and `work` must outlive this object. `language` null: this model has none.
  ProgramDesk(const Catalog& catalog, const Language* language, DeskWork& work);
  ProgramDesk(const ProgramDesk&) = delete;
  ProgramDesk& operator=(const ProgramDesk&) = delete;

  ProgramTexts texts;
  ProgramSource source;
  ProgramJob job;
  Rehearsals rehearsals;
  RehearsalRequests requests;
  RunFollower follower;
  int wanted_line = -1;  ///< line of the chosen text, from 0, for the editor to show
  int caret_line = -1;   ///< line of its caret; -1: not shown yet

  /// Null: this model has no program language.
  [[nodiscard]] const Language* language() const { return language_; }
  /// Grows when a text is edited, sent or started: earlier messages about it are then out of date.
  [[nodiscard]] std::uint64_t text_turns() const { return texts.changes() + job.begun() + starts_; }
  /// Once a frame, after the snapshot and its notices were taken.
  void refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send);

 private:
  void doubt_texts(const Snapshot& now);
  void notice_changes(const Snapshot& now);

  const Catalog& catalog_;
  const Language* language_;
  DeskWork& work_;
  std::uint32_t changes_ = 0;  ///< last seen of Snapshot::program_changes
  std::uint64_t starts_ = 0;
  Instant started_at_{};
};

}  // namespace hw::gui
