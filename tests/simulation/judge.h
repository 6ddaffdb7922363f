#pragma once
// Who sees only what was asked, what the screen would show, and what the machine really does, and knows the
// laws (README of this folder). The first broken one ends the session.
//
// Every bound stands here with its reason. What the wire could not carry is taken off; what a law cannot know
// it does not judge.
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "tests/simulation/models.h"
#include "tests/simulation/trace.h"
#include "tests/simulation/wire_faults.h"
#include "tests/simulation/witness.h"

namespace hw::simulation {

struct Finding {
  std::string law;
  Instant at{};
  std::string sentence;
};

enum class StopKind : std::uint8_t {
  ramp,     ///< a Stop of the console
  at_once,  ///< an Abort
  typed     ///< the maker's word
};

class Judge final : public Witness {
 public:
  static constexpr std::uint32_t all_axes = ~0u;

  /// Where answers come at once, at 9,600 baud: the transaction on the wire (25 ms), STOP, the end of four
  /// programs, STOP again (14 ms each); a VXM's 20 ms for one letter.
  static constexpr Duration stop_on_prompt_wire = Millis(150);
  /// Where a memory window is written at once, and the board obeys its mailbox: that does not wait for the
  /// ring, which is used when nothing has come of a mailed stop within 100 ms.
  static constexpr Duration stop_in_window = Millis(60);
  /// For each neighbour on the line: its transaction, and its own stop where all are stopped (on a doubtful
  /// wire 60 ms of silence behind each of the first two texts of it).
  static constexpr Duration other_device_stops = Millis(150);
  /// Where an answer may be missing the stop waits 0.2 s for it, and 60 ms for that of each of its texts.
  static constexpr Duration stop_on_doubtful_wire = Millis(500);
  static constexpr Duration wire_is_prompt_again = std::chrono::seconds(5);
  /// After a hurt wire: tried every 250 ms, a port takes as long to open, a lost answer is waited for (0.2
  /// s), then as above.
  static constexpr Duration stop_after_hurt = Millis(1500);
  /// The same where the controller had not answered yet since it was opened: a stop goes out three times,
  /// then with each attempt to connect, the second of which may take 2 s and the third 4 s.
  static constexpr Duration stop_of_the_unseen = std::chrono::seconds(5);
  /// After a break the console opens the port again and asks who is there, each answer at 9,600 baud.
  static constexpr Duration longest_connect = std::chrono::seconds(20);
  /// A switch, an input or an output that has changed is shown so in the next rounds of status.
  static constexpr Duration line_shows = std::chrono::seconds(3);
  /// Each of them may be as late as the wire: set-up is read, a jog's leg is written.
  static constexpr int questions_between_rounds = 20;
  /// A motion that was asked for begins: legs of homing, queued commands, an answer awaited in between.
  static constexpr Duration excuse_lasts = Millis(1500);
  /// Each of them may be as late as the wire: where the leg before has ended, what is written for the next.
  static constexpr int questions_between_motions = 8;
  /// Nothing goes out on a dirty line: its questions take 0.6 s three times, and 3 s.
  static constexpr Duration line_is_cleaned = std::chrono::seconds(5);
  /// An intent waits for those before it, each of them for its deadlines and their repetitions.
  static constexpr Duration longest_outcome = std::chrono::seconds(30);
  /// A stop is over when all stands: it takes a few rounds of status to see that.
  static constexpr Duration stop_is_over = std::chrono::seconds(3);
  /// What stands with its tool on is seen to do so by a whole round, and switched off by the next text.
  static constexpr Duration tool_is_off = std::chrono::seconds(4);
  /// Longer where a subroutine was called: no command ends it, and its next line may move again (AMB-046).
  static constexpr Duration subroutine_rests = std::chrono::seconds(5);
  static constexpr Duration longest_close = std::chrono::seconds(15);
  /// Between the moment when the controller read its counter and the last byte of the answer, at 9,600 baud
  /// with a collision or a repetition on the line.
  static constexpr Duration answer_on_wire = Millis(250);
  /// A byte that is lost or doubled may leave a number that looks right; the next rounds of status show it.
  static constexpr Duration spoilt_number_shows = Millis(1500);
  /// A controller without power leaves answers owed: the questions that clean its line take 0.6 s and 3 s,
  /// then its positions are read, and once more.
  static constexpr Duration restart_shows = std::chrono::seconds(8);

  /// What a session may take beside what it began with, its record and its texts included.
  static constexpr std::size_t most_memory = 64u << 20;

  Judge(Scheduler& scheduler, const WireFaults& faults, const ModelFacts& facts, bool obeys_mailbox);

  [[nodiscard]] const std::optional<Finding>& finding() const { return finding_; }
  /// Of all bytes on all wires with their times: the same plan gives the same.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

  /// That law is not judged: its known breaks would hide others.
  void leave_out(std::string law) { left_out_ = std::move(law); }
  void trace_to(Trace* trace) { trace_ = trace; }
  void remark(std::string_view what) const {
    if (trace_ != nullptr) trace_->line(scheduler_.now(), what);
  }

  // ---- what is asked
  void opened(std::vector<std::shared_ptr<Session>> sessions);
  void closing();
  void ended();
  void intent_sent(int device, IntentId id);
  void stop_sent(int device, IntentId id);
  /// What a question was told to be answered by.
  void answered(std::string_view question, std::string_view answer);
  /// It has to reach the controller as it was typed, or to be refused.
  void text_typed(int device, IntentId id, std::string text);
  void motion_asked(int device, std::uint32_t axes, IntentId id, Steps distance, bool homes = false);
  void motion_asked_elsewhere(int device) { motion_asked(device, all_axes, 0, Steps()); }
  void stop_asked(int device, std::uint32_t axes, StopKind kind, bool by_hand = false);
  /// In a tab that closes; nobody opens it again meanwhile.
  void stop_asked_closing(int device);
  /// Of its program: a motion may go on, but a second stop is one more.
  void halt_asked(int device) { count_stop(device, all_axes, false); }
  /// By a text that may do anything, or another host.
  void anything_asked(int device) { at(device).stop_drawn = scheduler_.now(); }
  /// The hand has gone; the console knows it at once, or `after` (the dead-man).
  void jog_let_go(int device, AxisId axis, IntentId jog, Duration after);
  /// Now, or when it is done: behind a stop that waits it may be a while.
  void position_set(int device, std::uint32_t axes, IntentId id);
  /// A program is being loaded, of a tool or not: from its end on the console minds that tool.
  void program_loaded(int device, IntentId id, bool of_tool) {
    at(device).tool.loading.emplace_back(id, of_tool);
  }
  void output_set(int device) { at(device).tool.by_hand = true, at(device).tool.run_asked = false; }
  void draws_with_tool(int device) { at(device).tool.draws = true; }
  /// Of a program, or of what is left of it.
  void run_asked(int device) { at(device).tool.run_asked = true; }
  void restarted(int device);
  void others_talk(int device);
  int call_begun(std::string what, Duration longest);
  void call_ended(int call);
  /// A call that must succeed has failed, or the other way round.
  void call_went_wrong(std::string what) { accuse("end", std::move(what)); }
  /// A warning of its session.
  void reported(int device, std::string_view sentence) { at(device).reported += sentence; }
  /// The console has closed without a word, and this stands in the controller's set-up or programs.
  void left_behind(int device, std::string_view question, std::string_view word);
  /// A wait that was begun then has said that nothing moves or runs.
  void reported_idle(int device, Instant begun);

  // ---- what happens
  void controller_received(int device, std::string_view bytes) override;
  void controller_sent(int device, std::string_view bytes) override;
  void register_written(int device, std::uint16_t offset, std::uint16_t value) override;
  void machine_is(int device, const MachineTruth& truth) override;
  void bench_is(int device, const BenchView& view) override;

 private:
  struct Stopped {
    Instant at{};
    Duration ramp{};
    bool doubtful = false;    ///< the wire was not prompt then
    bool of_program = false;  ///< one ran, and moved it perhaps
  };
  struct AxisCase {
    AxisTruth truth;
    Steps began_at{};
    std::optional<Stopped> stopped;  ///< the latest stop in whose scope it is
    struct Stand {
      Instant at;
      Steps position;
    };
    std::deque<Stand> stands;          ///< where it stood, oldest first; the first reaches back to the start
    std::optional<Instant> restarted;  ///< since its last reference
    Instant limit_operated{};          ///< last, either side
    Instant jammed{};                  ///< last
    Instant began_moving{};            ///< last
    Instant ended_motion_began{};      ///< of the last that has ended
    Instant counts_anew{};             ///< since its position was set last
    std::optional<bool> whole;         ///< what it did last was what one command asked for, to its end
    EndedBy reported = EndedBy::nothing;  ///< why it had ended, when last looked at
    struct Doubted {
      Instant since;
      Instant spoilt;  ///< the latest word to the controller that was, when that was first seen
    };
    Doubted doubted{};
  };
  /// Somebody wants these axes to move.
  struct Excuse {
    IntentId id = 0;
    std::uint32_t axes = 0;
    Instant asked{}, alive{};
    Steps distance{};
    bool homes = false;  ///< or may, by a text of the user's
  };
  struct Intended {
    IntentId id;
    Instant at;
    std::string text;                          ///< that was typed
    std::size_t received = 0;                  ///< bytes that the controller had received then
    std::uint32_t counts_anew = 0;             ///< axes whose position it sets
    std::optional<Instant> stands_since = {};  ///< of a stop: nothing moves or runs, and the wire carries
  };
  struct DeviceCase {
    std::shared_ptr<Session> session;
    MachineTruth truth;
    std::array<AxisCase, max_axes> axes;
    std::vector<Excuse> excuses;
    std::deque<Intended> intents;
    struct Tool {
      std::vector<std::pair<IntentId, bool>> loading;  ///< whether it is a program of it
      bool guarded = false;      ///< a program of it was loaded last, and not by an earlier session
      bool half_loaded = false;  ///< one of it, perhaps
      bool clouded = false;      ///< nobody knows which programs are its own
      bool draws = false;        ///< act by act, in what several controllers draw together
      bool by_hand = true;       ///< since the latest run its output was switched by something else
      bool run_asked = false;    ///< since it was switched by hand: not every program that runs is a move
      Instant rests_since{};
    } tool;
    std::map<std::int64_t, int> made;  ///< whole ways of that distance
    Instant moved_last{};              ///< or ran a program
    Instant cut_off{};                 ///< last restart while something moved or ran
    Instant stop_drawn{};              ///< last, by anybody; a text of the user's may be one
    bool ever_restarted = false;
    bool subroutine_called = false;
    bool stands_unseen = false;  ///< a program that a tab has found at rest, where not all axes can be seen
    Instant goes_on_unseen{};    ///< first, since then
    Instant unconnected_since{};
    std::optional<Instant> first_connected;  ///< since it was opened
    // Inputs and outputs: how the bench stood, and how each stand of it is shown when the wire is good.
    using Bench = std::pair<std::uint32_t, std::uint32_t>;
    struct Lines {
      std::uint32_t values = 0, known = 0;
    };
    std::deque<std::pair<Instant, Bench>> benches;
    std::uint32_t limits = 0;  ///< a bit for each axis that stands at one
    std::map<Bench, std::array<Lines, 2>> looks;
    std::array<Lines, 2> lines;
    Instant lines_unread{};
    struct Asked {
      std::uint32_t axes;
      bool at_once;
    };
    std::vector<Asked> stops;   ///< since everything stood
    std::string received;       ///< its end
    std::size_t forgotten = 0;  ///< bytes before those
    std::string reported;       ///< what was said: of all that failed, and in warnings
  };
  struct Call {
    std::string what;
    Instant deadline;
  };

  void tick();
  void accuse(std::string law, std::string sentence);
  [[nodiscard]] DeviceCase& at(int device) { return devices_.at(static_cast<std::size_t>(device)); }
  [[nodiscard]] const DeviceCase& at(int device) const {
    return devices_.at(static_cast<std::size_t>(device));
  }
  void note(int device, char way, std::string_view bytes);
  void count_stop(int device, std::uint32_t axes, bool at_once);

  // judge_motion.cpp
  void began(int device, int axis);
  void rested(int device, int axis);
  [[nodiscard]] std::optional<bool> was_whole(const DeviceCase& device, int axis, std::int64_t made) const;
  void remember(AxisCase& axis, Steps position) const;
  void keep_excuses(DeviceCase& device) const;
  [[nodiscard]] bool excused(const DeviceCase& device, int axis) const;
  void judge_stops(int device);
  void judge_kill(int device);
  [[nodiscard]] Instant latest_stop(int device, const AxisCase& axis) const;
  [[nodiscard]] Instant carries_a_stop(const Stopped& stopped) const;
  [[nodiscard]] bool prompt() const;
  [[nodiscard]] Duration lateness() const;

  // judge_screen.cpp
  void judge_memory();
  void judge_text(int device, const Intended& typed, IntentState outcome);
  void judge_outcomes(int device);
  void judge_open_stops(int device);
  void judge_positions(int device);
  void note_doubts(int device);
  void judge_trust(int device);
  void judge_limits(int device);
  void judge_lines(int device);
  void judge_link(int device);
  void judge_reasons(int device);
  void judge_tool(int device);

  Scheduler& scheduler_;
  const WireFaults& faults_;
  const ModelFacts& facts_;
  Timer timer_;
  std::vector<DeviceCase> devices_;
  std::map<int, Call> calls_;
  int next_call_ = 1;
  std::optional<Finding> finding_;
  Trace* trace_ = nullptr;
  const Duration stop_when_prompt_;
  std::size_t memory_at_start_;
  int ticks_ = 0;
  std::string left_out_;
  std::uint64_t fingerprint_ = 1469598103934665603u;
};

}  // namespace hw::simulation
