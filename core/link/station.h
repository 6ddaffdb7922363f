#pragma once
// One device's place on a wire: what its driver talks through. A wire with a single controller is a link with
// one station; on a multi-drop line (RS-485) each device has its own, with its own record of how well it
// answers, and a stop of one does not touch what the others have waiting. Io thread only.
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
  /// dirty line it goes out only once the line is clean again; a stop goes out at once.
  Task<Result<std::string>> transact(Transaction transaction);
  /// On a window: runs the cycles in their order, as one transaction. The span belongs to the caller and
  /// outlives the call.
  Task<Result<>> bus(std::span<BusCycle> cycles, Priority priority);
  /// On a window cycles say nothing by themselves: whoever speaks by them records what it said and heard, ...
  void record(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  /// ... and whether what it waited for came in time.
  void count_answer(Duration round_trip, bool poll, Instant now);
  void count_miss();
  // ---- one procedure at a time: see Pump
  /// A stop has come. The procedure under way ends: what it has waiting, its pauses, and whatever it asks for
  /// from now on end at once with Fault{stopped}. The transaction in flight is heard to its end, which comes
  /// soon (Link::hurry_for_a_stop).
  void preempt();
  /// It has ended; the next one may use the wire.
  void begin_procedure() { preempted_ = false; }
  [[nodiscard]] bool preempted() const { return preempted_; }
  /// The others may use the wire again.
  void stop_was_sent();
  /// Waits, unless a stop comes or the wire is lost.
  Task<Result<>> pause(Duration time);

  /// Steps that must not be cut apart: a stop waits for them. Each use is bounded in time; they are
  ///   VXM, PMX, DMX: a change of the line rate, until the console's end has followed.
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

  /// Of this device on a wire of several; -1: it has none.
  int address = -1;
  /// When any byte came in for this device last.
  [[nodiscard]] Instant heard_at() const { return heard_at_; }
  [[nodiscard]] bool was_heard() const { return heard_at_ > Instant{}; }
  /// What has just come tells nothing of this device: whoever listens has said it.
  void has_not_heard_it() { heard_at_ = answered_at_; }
  /// The procedure under way is ended, by a stop or with the wire: whoever waits for something else looks
  /// again.
  std::function<void()> procedure_ended;
  /// Its device is being stopped: what the others on the wire ask waits meanwhile. stop_was_sent() when it is
  /// over.
  std::function<bool()> stops;
  /// Bytes that no transaction claimed, at least one. The handler returns how many at the front are its own
  /// and done with; npos: they may be, more must come to tell (they are offered again with what follows).
  /// What no station on the wire understands counts as unparsed.
  std::function<std::size_t(std::string_view)> unsolicited;
  /// On a window: the controller has interrupted its host.
  std::function<void(std::uint8_t vector)> interrupted;
  /// Something that is no poll stands in the record now.
  std::function<void()> recorded;
  /// The wire is gone for everybody on it.
  std::function<void(const Fault&)> closed;

  [[nodiscard]] const StationStatistics& statistics() const { return statistics_; }
  [[nodiscard]] bool is_open() const { return link_ != nullptr; }
  // ---- the dirty line: see OwedAnswers
  /// A question, and whether what came is its answer.
  struct Unmistakable {
    Transaction question;
    std::function<bool(std::string_view answer)> is_answer;
  };
  /// The driver's: one whose answer cannot be mistaken for any of those (where it may be silent, the next one
  /// follows); none: only time helps. Null: the driver sees to late answers by itself.
  std::function<std::optional<Unmistakable>(const OwedAnswers& owed, Instant now)> unmistakable;
  /// This device was asked and has not answered in time: what comes from it now is not believed.
  [[nodiscard]] bool is_dirty() const;
  /// What was answered means nothing. What was asked may still be answered, or be answered with what is next.
  void doubt(Look look);
  /// What a greeting has shown: whatever was owed has come before.
  void has_caught_up() { owed_.clear(); }
  /// Asks the unmistakable question now, if the line is dirty: for one whose next text must not be taken for
  /// sent when it was not.
  Task<Result<>> come_clean(Priority priority);
  [[nodiscard]] const OwedAnswers& owed() const { return owed_; }
  /// What is known of this device's answers, for the station that takes this one's place on the same wire.
  struct Manner {
    OwedAnswers owed;
    Duration lateness{};
  };
  [[nodiscard]] Manner manner() const { return {owed_, lateness_}; }
  void take_over(const Manner& manner) {
    owed_.add(manner.owed);
    lateness_ = manner.lateness;
  }
  /// How often the line has become clean again: what was read before and what is read now may differ for
  /// another reason than that it has changed.
  [[nodiscard]] std::uint32_t times_cleaned() const { return times_cleaned_; }
  /// What the answers of this device are late by, as far as more patience is needed for it; 0: it is not
  /// slow.
  [[nodiscard]] Duration lateness() const { return lateness_; }
  /// Another device on this wire owes an answer that may look like this: what is heard may be that.
  [[nodiscard]] bool others_owe(Look look = Look::any) const;
  /// Line rate in baud; 0: the wire has none, or is gone.
  [[nodiscard]] int rate() const { return link_ ? link_->rate() : 0; }
  /// The wire carries whole messages to this one device (Stream::carries_messages).
  [[nodiscard]] bool carries_messages() const { return link_ && link_->carries_messages(); }
  [[nodiscard]] bool is_window() const { return link_ && link_->is_window(); }
  [[nodiscard]] bool tells_interrupts() const { return link_ && link_->tells_interrupts(); }
  /// What must reach the wire when this program cannot say it any more; null: nobody keeps it.
  [[nodiscard]] std::shared_ptr<WillKeeper::Will> leave_will(const LastWill& will) {
    return link_ ? link_->leave_will(will) : nullptr;
  }
  [[nodiscard]] JogEnds jog_ends() const { return link_ ? link_->jog_ends() : JogEnds::by_nobody; }
  /// For everybody on the wire.
  Result<> set_rate(int baud);
  /// Time that `bytes` characters take on this wire (0 when it has no rate).
  [[nodiscard]] Duration wire_time(std::size_t bytes) const {
    return link_ ? link_->wire_time(bytes) : Duration::zero();
  }
  /// Leaves the wire; waiting transactions end with Fault{lost}. `closed` is not called.
  void close(const Fault& why);
  /// The same of a wire that carries nothing any more: what waits in it must not arrive later.
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
  OwedAnswers owed_;
  Duration lateness_{};
  std::uint32_t times_cleaned_ = 0;
  Instant count_began_{};
  int polls_counted_ = 0;
  Instant heard_at_{}, answered_at_{};
  Event ended_;  ///< notified when a stop, or the end of the wire, ends what waits here
  bool preempted_ = false, preempt_due_ = false;
  int uncut_ = 0;
};

}  // namespace hw
