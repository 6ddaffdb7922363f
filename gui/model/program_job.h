#pragma once
// What takes several intents: running a text that the controller may not hold yet, storing it, bringing a
// program up. One job at a time per controller; it goes on while other panels are in front. GUI thread.
#include <functional>
#include <string>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "gui/model/program_texts.h"

namespace hw::gui {

class ProgramJob {
 public:
  enum class Goal : std::uint8_t {
    run,
    run_stepping,  ///< held before its first command
    load,          ///< into the slot, no more
    store,         ///< into the slot, then into non-volatile memory, where it is not there already
    fetch,         ///< the controller's program into the editor
    clear,         ///< empties the slot in the controller
    make_room,     ///< the same, after its text was brought into the editor
  };
  enum class Stage : std::uint8_t { idle, comparing, asking, loading, starting, storing, fetching, clearing };
  enum class Answer : std::uint8_t { overwrite, fetch_instead, leave };

  using Send = std::function<IntentId(IntentBody)>;
  struct Told {
    Mood mood = Mood::plain;
    std::string sentence;
  };

  /// Begins; false with a sentence in take_told() when it cannot (errors in the text, another job, no text).
  bool begin(Goal goal, int slot, ProgramTexts& texts, const Snapshot& now, const Catalog& catalog,
             const Send& send);
  /// Once a frame, after the tab's notices have reached the texts.
  void update(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, Instant clock,
              const Send& send);
  void answer(Answer answer, ProgramTexts& texts, const Send& send);
  /// A stop came: the present step ends as it does, and nothing follows it.
  void give_up();

  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] bool busy() const { return stage_ != Stage::idle; }
  [[nodiscard]] int slot() const { return slot_; }
  /// The last intent of a job that wrote into the controller; 0: none yet.
  [[nodiscard]] IntentId written_by() const { return written_by_; }
  /// How often something was begun.
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  [[nodiscard]] Goal goal() const { return goal_; }
  /// While asking: what would be lost.
  [[nodiscard]] const std::string& question() const { return question_; }
  /// "Loading program 0: 41 of 302 lines, 14 s left": what is under way; empty when nothing is.
  [[nodiscard]] std::string words(const ProgramFacts& facts, const TransferState& transfer) const;
  /// What came of it, told once; empty sentence: nothing new.
  Told take_told() { return std::exchange(told_, Told()); }

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
  int slot_ = 0;
  IntentId waiting_for_ = 0;
  IntentId written_by_ = 0;
  std::uint64_t begun_ = 0;
  bool given_up_ = false;
  std::string text_;  ///< as it was when the job began: this is what is loaded
  std::string question_;
  Told told_;
};

}  // namespace hw::gui
