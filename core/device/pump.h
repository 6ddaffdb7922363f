#pragma once
// The life of one open controller: connect, perform intents in order, poll in between, publish snapshots, and
// reconnect when the wire is lost. Exactly one procedure of the driver runs at a time; a stop ends it and
// takes its place. Io thread only.
#include <functional>
#include <memory>
#include <optional>

#include "core/device/count_watch.h"
#include "core/device/driver.h"
#include "core/device/ending_watch.h"
#include "core/device/held_jogs.h"
#include "core/device/job_queue.h"
#include "core/device/jog_will.h"
#include "core/device/line.h"
#include "core/device/loaded_texts.h"
#include "core/device/outage.h"
#include "core/device/piece_run.h"
#include "core/device/registry.h"
#include "core/device/rounds.h"
#include "core/device/stop.h"
#include "core/device/tool_guard.h"
#include "core/device/travel_check.h"
#include "core/link/station.h"
#include "core/time/scheduler.h"

namespace hw {

class Pump {
 public:
  struct Callbacks {
    std::function<Task<Result<std::shared_ptr<Link>>>()> open_wire;  ///< returns an open wire, shared or new
    std::function<void(const Snapshot&)> publish;
    std::function<void(Notice)> notify;
    TrafficRing* traffic = nullptr;
    std::function<void(const AxisSample&)> sample = nullptr;
    /// The controllers on the wire; null: the wire is not shared.
    std::shared_ptr<Line> line = nullptr;
    /// An entry that is not a poll was added to `traffic`.
    std::function<void()> recorded = nullptr;
    /// A motion or a program has ended.
    std::function<void(const Ending&)> ended = nullptr;
  };

  Pump(Scheduler& scheduler, const DeviceType& type, const Catalog& catalog, Callbacks callbacks);
  ~Pump();

  void start();
  /// Stops held jogs, lets pending stops reach the controller and the driver clear up, and closes the wire.
  /// The pump may be destroyed when this resumes.
  Task<> shut_down();

  void post(Intent intent);
  /// Sends the maker's broadcast stop, if there is one, before the stops of the single devices on this wire.
  /// False: there is no connection.
  bool stop_wire(bool at_once);
  /// Sends raw text and returns its reply, in the order of intents; a stop is sent first.
  Task<Result<std::string>> query(std::string text, Duration patience);
  [[nodiscard]] TextMeaning meaning_of(const std::string& text) const;
  /// The next unsolicited text, for scripts. False: there is none.
  bool take_unsolicited(std::string& text) { return texts_.take(text); }

  /// See Driver::leaves_behind().
  [[nodiscard]] std::string leaves_behind() const { return driver_->leaves_behind(); }

  /// Resumes after a status round that began after this call, or at once when there is no connection.
  Task<> refresh();
  /// Requests a status round soon; returns the number that rounds_ended() reaches when it is over.
  std::uint64_t want_round();
  /// This round, or a later one, is over, and the controller answered it.
  [[nodiscard]] bool has_seen(std::uint64_t round) const {
    return rounds_.ended() >= round && snapshot_.link.state == LinkState::good;
  }
  [[nodiscard]] std::uint64_t rounds_ended() const { return rounds_.ended(); }
  /// See Driver::watch_inputs().
  void watch_inputs(Instant until) { driver_->watch_inputs(until); }
  void watch_limits(Instant until) { driver_->watch_limits(until); }

  /// The number of writes, which only an emulator knows.
  void know_store_count(std::int32_t writes_used);
  [[nodiscard]] const Snapshot& known() const { return snapshot_; }
  /// A stop of all axes is under way: a second one means "at once, without a ramp".
  [[nodiscard]] bool stops_all() const { return desk_.stops_all(); }
  [[nodiscard]] bool busy() const { return jobs_.performs() || !jobs_.empty() || desk_.any(); }
  /// Notified after each published snapshot.
  [[nodiscard]] Event& published() { return published_; }

  static constexpr Duration dead_man = HeldJogs::patience;
  static constexpr int misses_until_lost = 3;
  static constexpr int misses_until_a_jog_ends = 2;  ///< a third miss may take seconds

 private:
  class Asking;
  /// The states of the pump, in this order.
  enum class Lifecycle : std::uint8_t {
    made,
    runs,
    leaves,  ///< shut_down() has begun: stops only
    closes,
    over
  };

  // ---- pump.cpp: the life of the connection
  Task<> let_end();
  Task<> live();
  Task<bool> open_and_connect();
  Task<bool> connect();
  Task<> serve();
  Task<> run_round();
  [[nodiscard]] Round next_round() const;
  void report_loss();
  void watch_counts();
  void disturbed();
  Task<> wait_for_retry();
  void poll_finished(const Result<>& result);
  void nothing_comes_back();
  [[nodiscard]] bool is_silent() const;
  [[nodiscard]] Fault not_answering() const;
  void connection_made();
  void lose_wire(const Fault& why);
  [[nodiscard]] bool connected() const;
  [[nodiscard]] bool something_may_run() const;
  [[nodiscard]] bool stop_goes_out_again() const;
  [[nodiscard]] bool something_runs() const;
  void publish();
  void warn_of(const std::optional<PastTravel>& past);
  [[nodiscard]] bool runs() const { return lifecycle_ > Lifecycle::made && lifecycle_ < Lifecycle::over; }
  [[nodiscard]] bool leaves() const { return lifecycle_ >= Lifecycle::leaves; }
  [[nodiscard]] bool closes() const { return lifecycle_ >= Lifecycle::closes; }
  void set_outcome(IntentId id, IntentState outcome, std::string_view sentence = {});
  void set_outcome(const IntentOutcome& report);
  void report_fault(IntentId id, const Fault& fault, IntentOutcome report = {});

  // ---- pump_stops.cpp
  void post_stop(StopOrder order);
  StopOrder& ask(StopOrder order);
  void watch_tool();
  [[nodiscard]] bool tool_is_seen_first() const;
  void switch_tool_off();
  Task<Result<>> bring_tool_back();
  void drop_waiting_jobs();
  Task<> send_stop(StopOrder& order);
  void stop_was_sent(StopOrder& order, Result<std::string> sent);
  void follow_words(const StopOrder& words);
  void look_at_stops();
  void look_at_stop(StopOrder& order);
  void stop_failed(StopOrder& order, const Fault& why);
  void close_stop(StopOrder& order);
  void stops_did_not_arrive(const Fault* why = nullptr);
  void keep_stops_at_loss(const Fault& why, bool drew_together);
  void note_broadcast(const std::string& text, const TextMeaning& meaning);
  Task<Result<std::string>> query_stop(std::string text, TextMeaning meaning, Duration patience);

  // ---- pump_intents.cpp: commands for the controller
  void post_text(Intent intent);
  Task<> pass_on(Intent intent, Pump& other);
  void enqueue(std::unique_ptr<Job> job);
  Task<> perform_next();
  Task<Result<>> perform_guarding_tool(const IntentBody& body);
  Task<Result<>> perform_beside_pieces(const IntentBody& body);
  Task<> perform_piece(const IntentBody& body);
  void report_hold_behind_piece();
  void pieces_end(std::string why, bool cuts);
  void words_come_between(const TextMeaning& words);
  bool words_were_sent(const Job& job, const Result<>& performed, const std::optional<PastTravel>& past);
  void broadcast_was_sent(bool sent);
  [[nodiscard]] std::optional<PastTravel> past_travel_of_words(const Job& job);
  [[nodiscard]] std::optional<PastTravel> past_travel_of_text(const std::string& text);
  Result<> trust_position(AxisId axis);
  void recall_positions(const std::vector<KeptPosition>& kept);
  void set_travel(IntentId id, const intent::SetTravel& request);
  void set_backlash(IntentId id, const intent::SetBacklash& request);
  Result<> take_up_backlash(IntentBody& body, IntentOutcome& report) const;
  [[nodiscard]] Result<> admit(Job& job, IntentOutcome& report);
  Task<Result<std::string>> add_late_replies(std::string reply, std::uint64_t since, std::uint64_t epoch,
                                             Duration patience);
  Task<Result<std::string>> wait_for_text(std::uint64_t since, std::uint64_t epoch, Duration patience);
  [[nodiscard]] Result<> may_go_to_all(const Job& job) const;
  void refuse_queued(std::string_view why);
  void refuse(std::unique_ptr<Job> job, std::string_view why);
  void hold_jog(const Intent& intent);
  void keep_will();
  void release_jogs(const StopOrder& order);
  bool withdraw_waiting_jog();
  void jog_not_begun(const Intent& intent);
  void jog_failed(const Intent& intent, FaultKind kind);
  void forget_jogs_that_ended();
  void count_program_change(const Intent& intent);
  void jog_let_go();
  void stop_unseen_jogs();

  Scheduler& scheduler_;
  const Catalog& catalog_;
  Callbacks callbacks_;
  Snapshot snapshot_;
  ScriptTexts texts_;
  StopDesk desk_;
  ToolGuard tool_;
  HeldJogs jogs_;
  JobQueue jobs_;
  PieceRun pieces_;
  Rounds rounds_;
  Outage outage_;
  EndingWatch endings_;
  TravelWatch travel_;
  std::optional<PastTravel> past_by_broadcast_;  ///< of a text that another session sends to all now
  CountWatch counts_;
  LoadedTexts loaded_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<Station> station_;
  std::unique_ptr<JogWill> will_;
  Event wake_, published_, ended_;
  Timer silence_;   ///< repeats an unconfirmed stop to a silent controller
  int asking_ = 0;  ///< number of coroutines that wait for an answer from this pump
  Lifecycle lifecycle_ = Lifecycle::made;
};

}  // namespace hw
