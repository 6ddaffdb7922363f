#pragma once
// One wire and its order: transactions wait in four queues, stop before intent before program transfer before
// poll; one is in flight at a time; each has a deadline. Bytes nobody asked for go to the owner's
// `unsolicited` handler. Io thread only.
#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "core/base/asio.h"
#include "core/link/framing.h"
#include "core/link/stream.h"
#include "core/link/traffic.h"
#include "core/time/scheduler.h"

namespace hw {

enum class Priority : std::uint8_t { stop, intent, transfer, poll };

struct Transaction {
  std::string bytes;
  ReplyShape reply;
  Priority priority = Priority::intent;
  /// Time allowed from the first byte sent to the end of the reply, beyond what the wire itself needs at its
  /// rate for `bytes` and an answer of usual length.
  Duration patience = Millis(200);
  /// How many bytes at the front of what came in are messages of their own and no part of the reply (a prompt
  /// that crossed the question): they are given to `unsolicited`. npos: more must come to tell. Null: none.
  std::size_t (*stranger)(std::string_view received) = nullptr;

  Transaction() = default;
  Transaction(std::string b, ReplyShape r, Priority p) : bytes(std::move(b)), reply(r), priority(p) {}
};

struct LinkStatistics {
  std::uint64_t transactions = 0, timeouts = 0, bytes_sent = 0, bytes_received = 0, unparsed_bytes = 0;
  Duration last_round_trip{};
  double polls_per_second = 0;
  int misses_in_a_row = 0;
};

class Link final : private Stream::Listener {
 public:
  Link(Scheduler& scheduler, std::unique_ptr<Stream> stream, TrafficRing* traffic);
  ~Link() override;

  /// Resumes with the reply (terminator included), or with a fault: no_answer, lost, stopped.
  Task<Result<std::string>> transact(Transaction transaction);
  /// From now until end_stop() intents and transfers, waiting or new, end with Fault{stopped}, so that no
  /// procedure that was under way can send its next step behind the stop. The one in flight goes on.
  void begin_stop();
  void end_stop() { stopping_ = false; }

  /// Bytes that no transaction claimed. The handler returns how many it understood; the rest counts as
  /// unparsed. Called with at least one byte.
  std::function<std::size_t(std::string_view)> unsolicited;
  std::function<void(const Fault&)> closed;

  [[nodiscard]] const LinkStatistics& statistics() const { return statistics_; }
  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] Stream& stream() { return *stream_; }
  /// Time that `bytes` characters take on this wire (0 when it has no rate).
  [[nodiscard]] Duration wire_time(std::size_t bytes) const;
  /// Closes the stream; waiting transactions end with Fault{lost}.
  void close(const Fault& why);

 private:
  struct Pending;
  static constexpr Duration settle_time = Millis(50);
  void bytes_arrived(std::string_view bytes) override;
  void stream_closed(const Fault& why) override;
  void start_next();
  void finish(Result<std::string> result);
  void on_deadline();
  void take_received();
  bool strip_strangers();
  void give_unsolicited(std::string_view bytes);
  void record(Way way, TrafficKind kind, std::string_view bytes);

  Scheduler& scheduler_;
  std::unique_ptr<Stream> stream_;
  TrafficRing* traffic_;
  std::array<std::deque<Pending*>, 4> waiting_;
  Pending* in_flight_ = nullptr;
  std::string received_;
  Instant sent_at_{};
  Instant settle_until_{};  ///< after a miss: a late reply must not be taken for the next one's
  Timer deadline_;
  Timer settled_;
  Instant second_began_{};
  int polls_this_second_ = 0;
  LinkStatistics statistics_;
  bool open_ = true;
  bool stopping_ = false;
};

}  // namespace hw
