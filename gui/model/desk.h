#pragma once
// The user's work with one controller: records of what happened, programs, blocks, edited set-up, typed
// commands. One per tab, whichever panels are in front. GUI thread.
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/registry.h"
#include "gui/model/block_list.h"
#include "gui/model/command_help.h"
#include "gui/model/desk_work.h"
#include "gui/model/kept_texts.h"
#include "gui/model/position_memory.h"
#include "gui/model/program_desk.h"
#include "gui/model/records.h"
#include "gui/model/setup_edits.h"

namespace hw::gui {

class ListRun;
class StepRecorder;

class Desk {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  Desk(const Catalog& catalog, const Language* language, TrafficLog::Explain explain);
  ~Desk();

  DeskWork work;
  Records records;
  ProgramDesk programs;
  BlockList blocks;
  KeptTexts kept;                                     ///< of programs and blocks
  const std::unique_ptr<ListRun> list_run;            ///< a list of the contour panel, loaded and started
  const std::unique_ptr<StepRecorder> step_recorder;  ///< steps of a servo axis and their recordings
  PositionMemory places;
  SetupEdits setup;
  SetupWrite setup_write;
  const CommandHelp help;
  std::vector<std::string> history;  ///< typed commands, oldest first
  /// Files dropped on the window, by the panel that is to open them (PanelEntry::opens).
  std::map<std::string, std::vector<std::filesystem::path>, std::less<>> dropped;
  [[nodiscard]] std::vector<std::filesystem::path> take_dropped(std::string_view panel);

  /// Before the desk is destroyed: keeps the latest edits and positions without waiting. The worker may still
  /// have to write them.
  void keep_now(Instant clock);
  /// Seconds until the latest edits or positions are to be kept, which wants a frame; negative: none are.
  [[nodiscard]] double autosave_due_in(Instant clock) const;

  /// An intent was sent: a reset makes the programs doubtful, a stop ends the job.
  void sent(const IntentBody& body);
  /// A stop is sent: nothing begun before it is continued.
  void stopped();
  /// Expires with the next stop: take one when beginning something that is continued later.
  [[nodiscard]] std::weak_ptr<void> until_stopped() const { return until_stopped_; }
  /// Once a frame, after the snapshot and its notices were taken.
  void refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send);

 private:
  const Catalog& catalog_;
  std::shared_ptr<int> until_stopped_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
