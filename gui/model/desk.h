#pragma once
// The user's work with one controller: recorded traffic, program texts and jobs on them, edited set-up, typed
// commands. One per tab, whichever panels are in front. GUI thread.
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/registry.h"
#include "core/session/autosave.h"
#include "gui/model/block_list.h"
#include "gui/model/command_help.h"
#include "gui/model/event_log.h"
#include "gui/model/position_memory.h"
#include "gui/model/position_trace.h"
#include "gui/model/program_job.h"
#include "gui/model/program_source.h"
#include "gui/model/program_texts.h"
#include "gui/model/rehearsals.h"
#include "gui/model/run_follower.h"
#include "gui/model/setup_edits.h"
#include "gui/model/stop_times.h"
#include "gui/model/traffic_log.h"
#include "gui/model/unread_programs.h"
#include "gui/model/worker.h"

namespace hw::gui {

class ListRun;
class StepRecorder;

class Desk {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  Desk(const Catalog& catalog, const Language* language, TrafficLog::Explain explain);
  ~Desk();

  TrafficLog traffic;
  EventLog events;
  StopTimes stop_times;
  ProgramTexts texts;
  BlockList blocks;
  ProgramSource source;
  ProgramJob job;
  Rehearsals rehearsals;
  const std::unique_ptr<ListRun> list_run;            ///< a list of the contour panel, loaded and started
  const std::unique_ptr<StepRecorder> step_recorder;  ///< steps of a servo axis and their recordings
  RunFollower follower;
  PositionTrace trace;
  PositionMemory places;
  SetupEdits setup;
  SetupWrite setup_write;
  const CommandHelp help;
  std::vector<std::string> history;  ///< typed commands, oldest first
  int wanted_line = -1;              ///< line of the chosen text, from 0, for the editor to show
  int caret_line = -1;               ///< line of its caret; -1: not shown yet
  /// Files dropped on the window, by the panel that is to open them (PanelEntry::opens).
  std::map<std::string, std::vector<std::filesystem::path>, std::less<>> dropped;
  [[nodiscard]] std::vector<std::filesystem::path> take_dropped(std::string_view panel);

  /// Null: this model has no program language.
  [[nodiscard]] const Language* language() const { return language_; }
  /// Runs long jobs; without one they run within the frame.
  void use(Worker* worker) { worker_ = worker; }
  [[nodiscard]] Worker& worker() { return worker_ ? *worker_ : own_worker_; }
  /// For Worker::run: results are dropped once this desk is gone.
  [[nodiscard]] std::weak_ptr<void> alive() const { return alive_; }
  /// Keeps unsaved texts and blocks under `key` from now on, and restores those of the last session. A fault:
  /// their file was damaged, and nothing was restored.
  Result<> keep_texts(Autosave autosave, std::string key);
  /// Before the desk is destroyed: keeps the latest edits without waiting. The worker may still have to write
  /// them.
  void keep_now(Instant clock);
  /// Grows when a text is edited, sent or started: earlier messages about it are then out of date.
  [[nodiscard]] std::uint64_t text_turns() const { return texts.changes() + job.begun() + starts_; }
  /// Seconds until the autosave wants a frame; negative: it does not.
  [[nodiscard]] double autosave_due_in(Instant clock) const;

  /// Starts a dry run of the chosen text as Run would start it, from the present positions. Set-up values
  /// that were never read are read first, and so are other programs that the run reaches, unless Run has been
  /// pressed: the dry run then begins with the run. Does nothing when there is no text or a dry run is under
  /// way.
  void rehearse(const Snapshot& now, const BenchView& bench);
  /// Some values of the set-up were never read.
  [[nodiscard]] bool can_read_more(const Snapshot& now) const;
  /// The known state of the controller, including its programs as far as known.
  [[nodiscard]] ControllerState state_of(const Snapshot& now) const;
  /// A listing was uploaded from the controller.
  void listed(const Notice& notice) { texts.listed(notice.slot, notice.text, notice.at, notice.whole); }
  /// An intent was sent: a reset makes the programs doubtful, a stop ends the job.
  void sent(const IntentBody& body);
  /// A stop is sent: nothing begun before it is continued.
  void stopped();
  /// Expires with the next stop: take one when beginning something that is continued later.
  [[nodiscard]] std::weak_ptr<void> until_stopped() const { return until_stopped_; }
  /// Once a frame, after the snapshot and its notices were taken.
  void refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send);

 private:
  void autosave(Instant clock);
  void keep_texts_now();
  [[nodiscard]] std::uint64_t typed() const { return texts.changes() + blocks.changes(); }
  void doubt_texts(const Snapshot& now);
  void notice_program_changes(const Snapshot& now);
  void start_rehearsal(int slot, const std::string& text, const Snapshot& now, const BenchView& bench);
  void rehearse_prepared(const Snapshot& now, const BenchView& bench, const Send& send);
  [[nodiscard]] bool reads_set_up(const Snapshot& now, const Send& send);
  void look_for_unread_programs(const Snapshot& now);

  const Catalog& catalog_;
  const Language* language_;
  Worker own_worker_;
  Worker* worker_ = nullptr;
  struct Kept {
    Autosave autosave{UserFolders::none()};
    std::string key;
    std::uint64_t saved = 0;  ///< of typed()
    Instant changed_at{};
    bool dirty = false;
  };
  Kept kept_;
  std::uint32_t program_changes_ = 0;
  std::uint64_t starts_ = 0;
  std::map<int, std::string> prepared_;  ///< texts by program: to be rehearsed once the set-up is read
  IntentId set_up_read_by_ = 0;
  UnreadPrograms unread_;
  int rehearsed_slot_ = -1;  ///< program whose other programs may be read; -1: none
  Instant started_at_{};
  std::shared_ptr<int> alive_ = std::make_shared<int>(0), until_stopped_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
