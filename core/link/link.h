#pragma once
// One wire. The transactions of all its stations wait in four queues: stop before intent before program
// transfer before poll, first come first served in each. One is in flight at a time, and each has a deadline.
// Unsolicited bytes go to the station that understands them. A wire is a stream of bytes, or a window onto a
// bus, where a transaction is a burst of cycles. Io thread only.
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/link/framing.h"
#include "core/link/link_wills.h"
#include "core/link/outstanding_replies.h"
#include "core/link/reply_times.h"
#include "core/link/stream.h"
#include "core/link/traffic.h"
#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

class Station;

enum class Priority : std::uint8_t { stop, intent, transfer, poll };

struct Transaction {
  std::string bytes;
  ReplyShape reply;
  Priority priority = Priority::intent;
  /// Time allowed from the first byte sent to the end of the reply, in addition to the time on the wire of
  /// `bytes` and a reply of usual length.
  Duration patience = Millis(200);
  /// A question that is answered at once or not at all. On a shared wire the deadline is then three times the
  /// slowest recent answer of this kind, so that a device that is switched off does not delay the others;
  /// never below 50 ms, never above `patience`.
  bool prompt = false;
  /// The form of its reply: a late reply is never taken for one of a different form.
  ReplyKind reply_kind = ReplyKind::any;
  /// Sent even while the line is dirty: the sender handles late replies, or cleans the line with this one.
  bool on_dirty_line = false;
  /// Silence does not count as a miss: the controller may be in a state in which it does not answer.
  bool may_be_silent = false;
  /// The next text is more urgent than this reply: no longer patience where replies are late.
  bool impatient = false;
  /// A status question of the console's own: recorded as a poll, whatever its priority.
  bool own_question = false;
  /// Returns how many bytes at the front of the received ones are not part of the reply (a prompt that
  /// crossed the question); they go to `unsolicited`. npos: more bytes are needed to decide. Null: none.
  std::function<std::size_t(std::string_view received)> unsolicited_length;

  Transaction() = default;
  Transaction(std::string b, ReplyShape r, Priority p) : bytes(std::move(b)), reply(r), priority(p) {}
};

/// The fault of a procedure that a stop has ended.
Fault stop_came_first();

class Link final : public std::enable_shared_from_this<Link>,
                   private Stream::Listener,
                   private Window::Listener {
 public:
  Link(Scheduler& scheduler, std::unique_ptr<Stream> stream);
  Link(Scheduler& scheduler, std::unique_ptr<Window> window);
  ~Link() override;

  [[nodiscard]] bool is_open() const { return stream_ || window_; }
  /// The wire is a window: bus cycles, not bytes.
  [[nodiscard]] bool is_window() const { return window_ != nullptr; }
  [[nodiscard]] bool reports_interrupts() const { return window_ && window_->reports_interrupts(); }
  /// Line rate in baud; 0: the wire has none, or is gone.
  [[nodiscard]] int rate() const { return stream_ ? stream_->rate() : 0; }
  [[nodiscard]] bool carries_messages() const { return stream_ && stream_->carries_messages(); }
  /// Time that `bytes` characters take on this wire (0 when it has no rate).
  [[nodiscard]] Duration wire_time(std::size_t bytes) const;
  [[nodiscard]] std::size_t station_count() const { return stations_.size(); }

  /// `keeper` carries out last wills; null: no watchdog runs. `emulated`: the controller ends with this
  /// program.
  void entrust_to(std::shared_ptr<WillKeeper> keeper, bool emulated) {
    wills_.entrust_to(std::move(keeper), emulated, share().how != WireShare::How::none);
  }

  /// Called when the wire has followed a controller to another rate.
  std::function<void(int baud)> rate_set;

 private:
  friend class Station;
  struct Pending;
  static constexpr Duration settle_time = Millis(50);
  /// For a reply, beyond its time on the wire.
  static constexpr Duration longest_wait_of_a_stop = Millis(200);

  // called by stations
  void join(Station& station);
  enum class Leaving : bool { in_order, given_up };
  void leave(Station& station, const Fault& why, Leaving leaving);
  Task<Result<std::string>> transact(Station& station, Transaction transaction);
  Task<Result<>> run(Station& station, std::span<BusCycle> cycles, Priority priority);
  [[nodiscard]] WireShare share() const;
  void give_up_soon(Fault why);
  void drop_waiting(const Station& station, const Fault& why);
  void shorten_for_stop();
  [[nodiscard]] Duration patience_for(const Station& station, const Transaction& transaction) const;
  [[nodiscard]] bool outstanding_by_others(const Station& asking, ReplyKind reply_kind) const;

  void bytes_arrived(std::string_view bytes) override;
  void stream_closed(const Fault& why) override;
  void window_closed(const Fault& why) override;
  void interrupted(std::uint8_t vector) override;
  void close_all(const Fault& why);
  [[nodiscard]] bool may_go_out(const Pending& pending) const;
  [[nodiscard]] bool nothing_waits() const;
  void start_next();
  void finish(Result<std::string> result);
  void end(Pending& pending, Result<std::string> result);
  void on_deadline();
  void take_received();
  void receive_to_end();
  bool take_unsolicited();
  std::size_t give_unsolicited(std::string_view bytes);
  std::size_t offer(std::string_view bytes, const Station*& took);
  void give_up_on(std::string_view bytes);
  void give_up_waiting();
  void end_overlong_reply();

  /// Bytes kept of an unfinished message. The longest reply, a listing, has some 4,000.
  static constexpr std::size_t longest_unfinished = 1 << 16;

  Scheduler& scheduler_;
  std::unique_ptr<Stream> stream_;  ///< this or `window_`; both null: the wire is gone
  std::shared_ptr<Window> window_;  ///< shared with the burst under way
  std::vector<Station*> stations_;
  Station* last_sender_ =
      nullptr;  ///< station of the latest transaction; unintelligible bytes are counted there
  std::array<std::vector<Pending*>, 4> waiting_;  ///< by priority; short, and their memory is reused
  Pending* in_flight_ = nullptr;
  std::string received_;
  Instant sent_at_{}, deadline_at_{};
  Instant latest_end_ = Instant::max();  ///< latest end of the transaction in flight, once a stop waits
  ReplyTimes reply_times_;
  Instant settle_until_{};               ///< after a miss: a late reply must not be taken for the next one
  OutstandingReplies left_outstanding_;  ///< replies outstanding to stations that have left
  LinkWills wills_;
  Timer deadline_;
  Timer settled_;
  Timer unfinished_;
};

}  // namespace hw
