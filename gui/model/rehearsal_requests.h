#pragma once
// Dry runs that the user has requested for the program texts of one controller. Values that the controller
// has never told are read first, and programs that a dry run reaches are read after it. GUI thread.
#include <functional>
#include <map>
#include <string>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "gui/model/desk_work.h"
#include "gui/model/program_job.h"
#include "gui/model/program_texts.h"
#include "gui/model/rehearsals.h"
#include "gui/model/unread_programs.h"

namespace hw::gui {

class RehearsalRequests {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// All must outlive this object. `language` null: nothing can be rehearsed.
  RehearsalRequests(const Catalog& catalog, const Language* language, ProgramTexts& texts,
                    const ProgramJob& job, Rehearsals& rehearsals, DeskWork& work);

  /// Starts a dry run of the chosen text as Run would start it, from the present positions. Set-up values
  /// that were never read are read first, and so are other programs that the run reaches, unless Run
  /// has been pressed: the dry run then begins with the run. Does nothing when there is no text or a dry run
  /// is under way.
  void rehearse(const Snapshot& now, const BenchView& bench);
  /// Some values of the set-up were never read.
  [[nodiscard]] bool can_read_more(const Snapshot& now) const;
  /// Once a frame: reads what is missing, and starts the dry runs that waited for it.
  void follow(const Snapshot& now, const BenchView& bench, const Send& send);

 private:
  void start(int slot, const std::string& text, const Snapshot& now, const BenchView& bench);
  void look_for_unread_programs(const Snapshot& now);
  [[nodiscard]] bool reads_set_up(const Snapshot& now, const Send& send);

  const Catalog& catalog_;
  const Language* language_;
  ProgramTexts& texts_;
  const ProgramJob& job_;
  Rehearsals& rehearsals_;
  DeskWork& work_;
  std::map<int, std::string> prepared_;  ///< texts by program: to be rehearsed once the set-up is read
  IntentId set_up_read_by_ = 0;
  UnreadPrograms unread_;
  int latest_slot_ = -1;  ///< program whose other programs may be read; -1: none
};

}  // namespace hw::gui
