#pragma once
// Tasks of several intents: running a text that the controller may not hold yet, storing it, uploading a
// program. One job at a time per controller; it continues while other panels are in front. GUI thread.
#include <functional>
#include <string>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/program_texts.h"

namespace hw::gui {

struct RunTerms {
  bool despite_doubt = false;  ///< see intent::RunProgram
  /// Asked when the text is loaded, which may take minutes: why the run must not begin now, as a sentence;
  /// empty: it may.
  std::function<std::string()> why_not_now{};
};

class ProgramJob {
 public:
  enum class Goal : std::uint8_t {
    run,
    run_stepping,  ///< held before its first command
    load,          ///< into the slot only
    store,         ///< into the slot, then into non-volatile memory, unless it is there already
    fetch,         ///< the controller's program into the editor
    clear,         ///< empties the slot in the controller
    make_room,     ///< the same, after fetching its text into the editor
  };
  enum class Stage : std::uint8_t { idle, comparing, asking, loading, starting, storing, fetching, clearing };
  enum class Answer : std::uint8_t { overwrite, fetch_instead, leave };

  using Send = std::function<IntentId(IntentBody)>;
  struct Report {
    Severity severity = Severity::plain;
    std::string sentence;
  };

  /// Begins a job. False, with a sentence in take_report(): not possible (errors in the text, another job, no
  /// text).
  bool begin(Goal goal, int slot, ProgramTexts& texts, const Snapshot& now, const Catalog& catalog,
             const Send& send, RunTerms run = {});
  /// Once a frame, after the tab's notices have reached the texts.
  void update(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, Instant clock,
              const Send& send);
  void answer(Answer answer, ProgramTexts& texts, const Send& send);
  /// A stop was sent: the present step ends normally, and no other follows.
  void give_up();

  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] bool busy() const { return stage_ != Stage::idle; }
  [[nodiscard]] int slot() const { return slot_; }
  /// The last intent of a job that changed the controller's programs; 0: none yet.
  [[nodiscard]] IntentId written_by() const { return written_by_; }
  /// How many jobs were begun.
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  [[nodiscard]] Goal goal() const { return goal_; }
  /// While asking: what would be lost.
  [[nodiscard]] const std::string& question() const { return question_; }
  /// "Loading program 0: 41 of 302 lines, 14 s left": the present step; empty when idle.
  [[nodiscard]] std::string words(const ProgramFacts& facts, const TransferState& transfer) const;
  /// The outcome, reported once; empty sentence: nothing new.
  Report take_report() { return std::exchange(report_, Report()); }

 private:
  void load(const Send& send);
  void after_load(const Send& send);
  void compared(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, const Send& send);
  void done(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, Instant clock,
            const Send& send);
  void empty_kept(ProgramTexts& texts, const Catalog& catalog, const Send& send);
  void refuse(std::string sentence);
  void lose_link(const Snapshot& now);
  void end_given_up(ProgramTexts& texts, Instant clock);
  void fetched(ProgramTexts& texts, const Catalog& catalog);

  Goal goal_ = Goal::run;
  Stage stage_ = Stage::idle;
  int slot_ = 0, start_ = 0;  ///< start_: the program of its text that is run
  IntentId waiting_for_ = 0;
  IntentId written_by_ = 0;
  std::uint64_t begun_ = 0;
  bool given_up_ = false;
  RunTerms run_;
  std::string text_;  ///< the text loaded: as it was when the job began
  std::string question_;
  Report report_;
};

}  // namespace hw::gui
