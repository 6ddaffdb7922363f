#pragma once
// One device on a wire, as its driver uses it. A wire with a single controller is a link with one station; on
// a multi-drop line (RS-485) each device has its own station and statistics, and a stop of one leaves the
// queues of the others alone. Io thread only.
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/link/link.h"

namespace hw {

struct StationStatistics {
  std::uint64_t transactions = 0, timeouts = 0, unparsed_bytes = 0;
  Duration last_round_trip{};
  double polls_per_second = 0;
  int misses_in_a_row = 0;
};

class Station {
 public:
  /// `traffic` may be null. The link stays open as long as a station is on it.
  Station(std::shared_ptr<Link> link, TrafficRing* traffic);
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Resumes with the reply (terminator included), or with a fault: no_answer, garbled, lost, stopped. On a
  /// dirty line the transaction waits until the line is clean; a stop is sent at once.
  Task<Result<std::string>> transact(Transaction transaction);
  /// On a window: runs the cycles in order, as one transaction. The caller's span must outlive the call.
  Task<Result<>> bus(std::span<BusCycle> cycles, Priority priority);
  /// On a window the driver itself records the texts that it sends and receives, ...
  void record(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  /// ... and whether the awaited reply came in time.
  void count_answer(Duration round_trip, bool poll, Instant now);
  void count_miss();
  /// Continues a series of misses that the reply to another question has interrupted.
  void resume_misses(int in_a_row) { statistics_.misses_in_a_row = in_a_row; }
  // ---- one procedure at a time: see Pump
  /// Ends the procedure under way for a stop: its waiting transactions, its pauses and all later requests end
  /// at once with Fault{stopped}. The transaction in flight is received to its end, which comes soon
  /// (Link::shorten_for_stop).
  void preempt();
  /// The preempted procedure has ended; the next one may use the wire.
  void begin_procedure() { preempted_ = false; }
  [[nodiscard]] bool preempted() const { return preempted_; }
  /// Releases the wire for the other stations.
  void stop_was_sent();
  /// Waits, unless a stop comes or the wire is lost.
  Task<Result<>> pause(Duration time);

  /// Guards steps that a stop must not interrupt; the stop waits. Each use is bounded in time: a change of
  /// the line rate of VXM, PMX and DMX, until the console has followed.
  class Uncut {
   public:
    explicit Uncut(Station& station) : station_(station) { ++station_.uncut_; }
    ~Uncut() {
      if (--station_.uncut_ == 0 && std::exchange(station_.preempt_due_, false)) station_.preempt();
    }
    Uncut(const Uncut&) = delete;
    Uncut& operator=(const Uncut&) = delete;

   private:
    Station& station_;
  };

  /// Address of this device on a shared wire; -1: it has none.
  int address = -1;
  /// When a byte for this device was last received.
  [[nodiscard]] Instant received_at() const { return received_at_; }
  [[nodiscard]] bool has_received() const { return received_at_ > Instant{}; }
  /// The bytes just received were not from this device: takes back received_at().
  void discount_received() { received_at_ = answered_at_; }
  /// Called when a stop, or the loss of the wire, ends the procedure under way, so that other waits can be
  /// checked.
  std::function<void()> procedure_ended;
  /// Returns whether this device is being stopped; the other stations' questions wait until stop_was_sent().
  std::function<bool()> stops;
  /// Handles bytes that no transaction claimed (at least one). Returns how many at the front it has used;
  /// npos: more bytes are needed to decide, and these are offered again with them. Bytes that no station
  /// understands count as unparsed.
  std::function<std::size_t(std::string_view)> unsolicited;
  /// On a window: called when the controller interrupts its host.
  std::function<void(std::uint8_t vector)> interrupted;
  /// Called when an entry that is not a poll was recorded.
  std::function<void()> recorded;
  /// Called when the wire is gone for all its stations.
  std::function<void(const Fault&)> closed;

  [[nodiscard]] const StationStatistics& statistics() const { return statistics_; }
  [[nodiscard]] bool is_open() const { return link_ != nullptr; }
  // ---- the dirty line: see OutstandingReplies
  /// A question, and a test whether a reply belongs to it.
  struct Unmistakable {
    Transaction question;
    std::function<bool(std::string_view answer)> is_answer;
  };
  /// Set by the driver: returns a question whose reply cannot be mistaken for an outstanding one (another
  /// follows if it may stay silent); none: only time helps. Null: the driver handles late replies itself.
  std::function<std::optional<Unmistakable>(const OutstandingReplies& outstanding, Instant now)> unmistakable;
  /// A reply of this device is outstanding, so that its next reply cannot be trusted.
  [[nodiscard]] bool is_dirty() const;
  /// The reply made no sense. The reply to this question may still come, or come in place of the next one.
  void doubt(ReplyKind reply_kind);
  /// A greeting has shown that all outstanding replies have come.
  void has_caught_up() { outstanding_.clear(); }
  /// Cleans the line now, if it is dirty, by the unmistakable question: to be called before a text that must
  /// not be sent twice or lost.
  Task<Result<>> clean_line(Priority priority);
  [[nodiscard]] const OutstandingReplies& outstanding() const { return outstanding_; }
  /// How this device answers, for the station that replaces this one on the same wire.
  struct ReplyState {
    OutstandingReplies outstanding;
    Duration lateness{};
  };
  [[nodiscard]] ReplyState reply_state() const { return {outstanding_, lateness_}; }
  void take_over(const ReplyState& reply_state) {
    outstanding_.add(reply_state.outstanding);
    lateness_ = reply_state.lateness;
  }
  /// How often the line was cleaned: a reading from before may have been mistaken.
  [[nodiscard]] std::uint32_t times_cleaned() const { return times_cleaned_; }
  /// The extra patience that this device needs because it answers late; 0: it does not.
  [[nodiscard]] Duration lateness() const { return lateness_; }
  /// A reply of another device on this wire is outstanding and may be of this kind: a received reply may be
  /// that one.
  [[nodiscard]] bool others_outstanding(ReplyKind reply_kind = ReplyKind::any) const;
  /// Line rate in baud; 0: the wire has none, or is gone.
  [[nodiscard]] int rate() const { return link_ ? link_->rate() : 0; }
  /// The wire carries whole messages to this device alone (Stream::carries_messages).
  [[nodiscard]] bool carries_messages() const { return link_ && link_->carries_messages(); }
  [[nodiscard]] bool is_window() const { return link_ && link_->is_window(); }
  [[nodiscard]] bool reports_interrupts() const { return link_ && link_->reports_interrupts(); }
  /// Leaves a last will with the watchdog; null: no watchdog runs.
  [[nodiscard]] std::shared_ptr<WillKeeper::Will> leave_will(const LastWill& will) {
    return link_ ? link_->wills_.leave(link_->scheduler_, link_->share(), will) : nullptr;
  }
  [[nodiscard]] JogEnds jog_ends() const { return link_ ? link_->wills_.jog_ends() : JogEnds::never; }
  /// Sets the rate for all stations of the wire.
  Result<> set_rate(int baud);
  /// Time that `bytes` characters take on this wire (0 when it has no rate).
  [[nodiscard]] Duration wire_time(std::size_t bytes) const {
    return link_ ? link_->wire_time(bytes) : Duration::zero();
  }
  /// Leaves the wire; waiting transactions end with Fault{lost}. `closed` is not called.
  void close(const Fault& why);
  /// Leaves a dead wire: bytes that still wait in it must not arrive later.
  void give_up(const Fault& why);

 private:
  friend class Link;
  Task<Result<std::string>> send(Transaction transaction);
  Task<Result<std::string>> transact_when_clean(Transaction transaction);
  Task<Result<>> clean(Priority priority);
  Task<Result<>> clean_by(Unmistakable asked, Priority priority);
  Task<Result<>> outwait(Priority priority);
  Task<Result<>> wait_for_silence();
  void learn_lateness(Duration round_trip);
  void leave(const Fault& why, Link::Leaving how);
  void count(const Result<std::string>& result, bool question, bool poll, Duration round_trip, Instant now);
  void count_burst(bool done);
  void count_polls(Instant now);

  std::shared_ptr<Link> link_;
  TrafficRing* traffic_;
  StationStatistics statistics_;
  OutstandingReplies outstanding_;
  Duration lateness_{};
  std::uint32_t times_cleaned_ = 0;
  Instant count_began_{};
  int polls_counted_ = 0;
  Instant received_at_{}, answered_at_{};
  Event ended_;  ///< notified when a stop, or the end of the wire, ends the waits of this station
  bool preempted_ = false, preempt_due_ = false;
  int uncut_ = 0;
};

}  // namespace hw
