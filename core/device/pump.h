#pragma once
// The life of one open controller: connect, perform intents in order, poll in between, publish what is known;
// when the wire is lost say so, and come back. A stop never waits behind anything here. Io thread only.
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/device/driver.h"
#include "core/device/held_jogs.h"
#include "core/device/loss_report.h"
#include "core/device/owed_stop.h"
#include "core/device/registry.h"
#include "core/link/station.h"
#include "core/time/scheduler.h"

namespace hw {

class Pump {
 public:
  struct Ways {
    std::function<Task<Result<std::shared_ptr<Link>>>()> open_wire;  ///< an open one, shared or new
    std::function<void(const Snapshot&)> publish;
    std::function<void(Notice)> notify;
    TrafficRing* traffic = nullptr;
    std::function<void(const AxisSample&)> sample = nullptr;
    /// The wire as others on it have it open, whether or not this one is on it; null: nobody, or not shared.
    std::function<std::shared_ptr<Link>()> open_link = nullptr;
    /// Something that is no poll stands in `traffic` now.
    std::function<void()> recorded = nullptr;
  };

  Pump(Scheduler& scheduler, const DeviceType& type, const Catalog& catalog, Ways ways);
  ~Pump();

  void start();
  /// Stops what the console holds, lets every stop under way reach the controller and the driver clear up,
  /// closes the wire. The pump may be destroyed when it resumes.
  Task<> shut_down();

  void post(Intent intent);
  /// Before the stops of all devices on this wire: the maker's one message to all, if there is one. False:
  /// there is no connection.
  bool stop_wire(bool at_once);
  /// Raw text and its reply, in the order of intents.
  Task<Result<std::string>> query(std::string text, Duration patience);

  /// Resumes after a round of status that began after this call, or at once when there is no connection.
  Task<> refresh();
  /// Hurries the next round of status; its number, which rounds_ended() reaches when it is over.
  std::uint64_t want_round();
  [[nodiscard]] std::uint64_t rounds_ended() const { return rounds_ended_; }

  /// What the controller itself cannot tell, and its emulator can.
  void know_store_count(std::int32_t writes_used);
  [[nodiscard]] const Snapshot& known() const { return draft_; }
  [[nodiscard]] Driver& driver() { return *driver_; }
  /// A stop of all axes is under way: another one would mean "at once, without a ramp".
  [[nodiscard]] bool stops_all() const { return stops_of_all_ > 0; }
  [[nodiscard]] bool busy() const { return performing_ || !queue_.empty() || stops_under_way_ > 0; }
  /// Notified after each publication.
  [[nodiscard]] Event& published() { return published_; }

  static constexpr Duration dead_man = Millis(250);
  static constexpr int misses_until_lost = 3;

 private:
  struct Job;  // an intent, or a query with its waiting coroutine

  Task<> live();
  Task<> serve();
  Task<> perform_next();
  Result<> trust_position(AxisId axis);
  Task<Result<>> stop_as_asked(const IntentBody& body);
  // These two run beside live(); whoever starts one counts it in stops_under_way_ first.
  Task<> stop_and_report(Intent intent);
  Task<> run_stop_wire(bool at_once);
  Task<bool> open_and_connect();
  Task<> leave_wire();
  Task<> wait_for_retry();
  void post_stop(Intent intent);
  [[nodiscard]] bool stops_by_text(const std::string& text) const;
  void enqueue(std::unique_ptr<Job> job);
  [[nodiscard]] std::shared_ptr<Link> shared_wire() const;
  void tell_wire_of_stop(Addressees whom);
  void begin_stop(Addressees whom);
  void drop_what_waits();
  void end_stop();
  Task<> perform_stop_text(Intent intent);
  void owe_stop_of_all(const Fault& why);
  Task<Result<std::string>> query_stop(std::string text, Duration patience);
  void refuse_queued(std::string_view why);
  void refuse(std::unique_ptr<Job> job, std::string_view why);
  bool try_to_recover(const std::string& text);
  void answer_recovery();
  void hold_jog(const Intent& intent);
  void release_jogs(const IntentBody& stop);
  bool withdraw_waiting_jog();
  void jog_not_begun(const Intent& intent);
  void jog_failed(const Intent& intent, FaultKind kind);
  void disarm_if_none_is_held();
  [[nodiscard]] bool connected() const;
  [[nodiscard]] bool something_runs() const;
  void owe_stop(const IntentBody& stop);
  void make_good_the_stop();
  void forget_jogs_that_ended();
  void count_program_change(const Intent& intent);
  void jog_let_go();
  void poll_finished(const Result<>& result);
  void tell_what_came_of_the_loss();
  void lose_wire(const Fault& why);
  void set_fate(IntentId id, Fate fate, std::string_view sentence = {});
  void set_fate(const IntentFate& told);
  void tell_fault(IntentId id, const Fault& fault, std::uint32_t doubtful = 0);
  void publish();

  Scheduler& scheduler_;
  const Catalog& catalog_;
  Ways ways_;
  Snapshot draft_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<Station> station_;
  std::deque<std::unique_ptr<Job>> queue_;
  Event wake_, published_, ended_;
  Timer dead_man_;
  Instant next_poll_{};
  std::uint64_t rounds_begun_ = 0, rounds_ended_ = 0, round_wanted_ = 0;
  int fast_polls_ = 0;
  int stops_under_way_ = 0;
  int stops_of_all_ = 0;     ///< of them
  int answers_awaited_ = 0;  ///< of stops in the controller's words that may have gone out long ago
  std::uint64_t stops_begun_ = 0;
  int attempt_ = 0;
  bool performing_ = false;
  HeldJogs jogs_;
  OwedStop owed_stop_;  ///< to be made good when the wire is back
  /// The round of status in which a stop of all went out that nothing answers, until a later one has ended
  /// well: the wire may have swallowed it.
  std::optional<std::uint64_t> unanswered_stop_;
  LossReport loss_;
  bool ran_when_lost_ = false;
  std::uint32_t restarts_when_lost_ = 0;
  bool down_ = false;     ///< since the loss of the wire, through all attempts
  bool leaving_ = false;  ///< shut_down() has begun: stops only
  bool running_ = false, closing_ = false, retry_now_ = false;
  bool recovering_ = false;  ///< what waits may be what makes the controller answer again
};

}  // namespace hw
