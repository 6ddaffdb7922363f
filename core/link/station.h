#pragma once
// One device's place on a wire: what its driver talks through. A wire with a single controller is a link with
// one station; on a multi-drop line (RS-485) each device has its own, with its own record of how well it
// answers, and a stop of one does not touch what the others have waiting. Io thread only.
#include <functional>
#include <memory>
#include <string>

#include "core/link/link.h"

namespace hw {

struct StationStatistics {
  std::uint64_t transactions = 0, timeouts = 0, unparsed_bytes = 0;
  Duration last_round_trip{};
  double polls_per_second = 0;
  int misses_in_a_row = 0;
};

/// What another station's user says to this device, as it goes on: before it goes out; when it has been done,
/// as far as the device tells; when it was refused or never went out.
enum class Hearsay : std::uint8_t { said, done, refused };

class Station {
 public:
  /// `traffic` may be null. The link stays open as long as a station is on it.
  Station(std::shared_ptr<Link> link, TrafficRing* traffic);
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Resumes with the reply (terminator included), or with a fault: no_answer, garbled, lost, stopped.
  Task<Result<std::string>> transact(Transaction transaction);
  /// On a window: runs the cycles in their order, as one transaction. The span belongs to the caller and
  /// outlives the call.
  Task<Result<>> bus(std::span<BusCycle> cycles, Priority priority);
  /// On a window cycles say nothing by themselves: whoever speaks by them records what it said and heard, ...
  void record(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  /// ... and whether what it waited for came in time.
  void count_answer(Duration round_trip, bool poll, Instant now);
  void count_miss();
  /// From now until end_stop() intents and transfers of this station, waiting or new, end with
  /// Fault{stopped}, so that no procedure that was under way can send its next step behind the stop. The one
  /// in flight goes on.
  void begin_stop();
  void end_stop() { stopping_ = false; }

  /// Link::stops_said() of those whom the user's text that is under way is for, when it was asked for.
  std::uint64_t stops_before = 0;
  /// A stop of this device is under way: nobody else sets it in motion.
  bool being_stopped = false;
  /// Of this device on a wire of several; -1: it has none.
  int address = -1;
  /// Bytes that no transaction claimed, at least one. The handler returns how many at the front are its own
  /// and done with; npos: they may be, more must come to tell (they are offered again with what follows).
  /// What no station on the wire understands counts as unparsed.
  std::function<std::size_t(std::string_view)> unsolicited;
  /// On a window: the controller has interrupted its host.
  std::function<void(std::uint8_t vector)> interrupted;
  /// Another station of this wire says something for its user that may be meant for this device.
  std::function<void(std::string_view, Hearsay)> overheard;
  void let_others_hear(std::string_view text, Hearsay what) const;
  /// Something that is no poll stands in the record now.
  std::function<void()> recorded;
  /// The wire is gone for everybody on it.
  std::function<void(const Fault&)> closed;

  [[nodiscard]] const StationStatistics& statistics() const { return statistics_; }
  [[nodiscard]] bool is_open() const { return link_ != nullptr; }
  /// This device was asked and did not answer in time: the answer may still come, and look like another's.
  [[nodiscard]] bool owes_answer() const;
  /// The same of any device on this wire: what is heard now may be somebody else's, or of an older question.
  [[nodiscard]] bool answer_owed_on_wire() const;
  /// This device has said what only it could say, now: whatever it owed has come before.
  void has_caught_up() { owes_until_ = {}; }
  /// Line rate in baud; 0: the wire has none, or is gone.
  [[nodiscard]] int rate() const { return link_ ? link_->rate() : 0; }
  /// The wire carries whole messages to this one device (Stream::carries_messages).
  [[nodiscard]] bool carries_messages() const { return link_ && link_->carries_messages(); }
  [[nodiscard]] bool is_window() const { return link_ && link_->is_window(); }
  [[nodiscard]] bool tells_interrupts() const { return link_ && link_->tells_interrupts(); }
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
  void count(const Result<std::string>& result, bool question, bool poll, Duration round_trip, Instant now);
  void count_burst(bool done);
  void count_polls(Instant now);

  std::shared_ptr<Link> link_;
  TrafficRing* traffic_;
  StationStatistics statistics_;
  Instant owes_until_{};
  Instant count_began_{};
  int polls_counted_ = 0;
  bool stopping_ = false;
};

}  // namespace hw
