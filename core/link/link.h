#pragma once
// One wire and its order: transactions of all its stations wait in four queues, stop before intent before
// program transfer before poll, first come first served in each; one is in flight at a time; each has a
// deadline. Bytes nobody asked for go to the station that understands them. A wire is a stream of bytes or a
// window onto a bus, where a transaction is a burst of cycles. Io thread only.
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/link/framing.h"
#include "core/link/last_will.h"
#include "core/link/owed_answers.h"
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
  /// Time allowed from the first byte sent to the end of the reply, beyond what the wire itself needs at its
  /// rate for `bytes` and an answer of usual length.
  Duration patience = Millis(200);
  /// A question that is answered at once or not at all. On a wire that several share, silence is taken for
  /// the answer as soon as it has lasted three times as long as the slowest such answer of late, so that one
  /// that is switched off does not hold up the others; never before 50 ms, never after `patience`.
  bool prompt = false;
  /// What its answer looks like: one that comes too late is taken for no other's that looks different.
  Look look = Look::any;
  /// Goes out while the line is dirty too: whoever asks sees to late answers, or cleans with it.
  bool on_dirty_line = false;
  /// Silence says nothing against the link: the controller is in a state in which it does not answer.
  bool may_be_silent = false;
  /// The next text is more urgent than its answer: not waited for longer where answers are late.
  bool impatient = false;
  /// What the console asks for itself about the state: recorded as a poll, however urgent it is.
  bool own_question = false;
  /// How many bytes at the front of what came in are messages of their own and no part of the reply (a prompt
  /// that crossed the question): they are given to `unsolicited`. npos: more must come to tell. Null: none.
  std::function<std::size_t(std::string_view received)> stranger;

  Transaction() = default;
  Transaction(std::string b, ReplyShape r, Priority p) : bytes(std::move(b)), reply(r), priority(p) {}
};

/// What a procedure is told that a stop has ended.
Fault stop_came_first();

class Link final : public std::enable_shared_from_this<Link>,
                   private Stream::Listener,
                   private Window::Listener {
 public:
  Link(Scheduler& scheduler, std::unique_ptr<Stream> stream);
  Link(Scheduler& scheduler, std::unique_ptr<Window> window);
  ~Link() override;

  [[nodiscard]] bool is_open() const { return stream_ || window_; }
  /// It is a window: spoken to by bus cycles, not by bytes.
  [[nodiscard]] bool is_window() const { return window_ != nullptr; }
  [[nodiscard]] bool tells_interrupts() const { return window_ && window_->tells_interrupts(); }
  /// Line rate in baud; 0: the wire has none, or is gone.
  [[nodiscard]] int rate() const { return stream_ ? stream_->rate() : 0; }
  [[nodiscard]] bool carries_messages() const { return stream_ && stream_->carries_messages(); }
  /// Time that `bytes` characters take on this wire (0 when it has no rate).
  [[nodiscard]] Duration wire_time(std::size_t bytes) const;
  [[nodiscard]] std::size_t station_count() const { return stations_.size(); }

  /// Who carries out last wills; null: nobody. `emulated`: what is at the other end ends with this program.
  void entrust_to(std::shared_ptr<WillKeeper> keeper, bool emulated) {
    keeper_ = std::move(keeper);
    emulated_here_ = emulated;
    shared_ = share().how != WireShare::How::none;
  }

  /// A controller was told another rate, and the wire follows it.
  std::function<void(int baud)> rate_set;

 private:
  friend class Station;
  struct Pending;
  static constexpr Duration settle_time = Millis(50);
  static constexpr Duration least_patience = Millis(50);           ///< adapters hand bytes over in pieces
  static constexpr Duration longest_wait_of_a_stop = Millis(200);  ///< for an answer beyond its bytes
  static constexpr int prompt_answers_needed = 16;                 ///< before the wire is known

  // for stations
  void join(Station& station);
  enum class Leaving : bool { in_order, given_up };
  void leave(Station& station, const Fault& why, Leaving leaving);
  Task<Result<std::string>> transact(Station& station, Transaction transaction);
  Task<Result<>> run(Station& station, std::span<BusCycle> cycles, Priority priority);
  std::shared_ptr<WillKeeper::Will> leave_will(const LastWill& will);
  [[nodiscard]] JogEnds jog_ends() const;
  [[nodiscard]] WireShare share() const;
  [[nodiscard]] bool a_will_may_be_carried_out();
  void give_up_soon(Fault why);
  void drop_waiting(const Station& station, const Fault& why);
  void hurry_for_a_stop();
  [[nodiscard]] Duration patience_for(const Station& station, const Transaction& transaction) const;
  [[nodiscard]] bool owed_by_others(const Station& asking, Look look) const;
  void learn_from_answer(const Transaction& transaction, std::size_t answer_bytes, Instant now);

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
  void hear_it_out();
  bool strip_strangers();
  std::size_t give_unsolicited(std::string_view bytes);
  std::size_t offer(std::string_view bytes, const Station*& took);
  void give_up_on(std::string_view bytes);
  void give_up_waiting();
  void end_babble();

  /// Of what has come in and is no whole message yet. The longest answer of all, a listing, has some 4,000.
  static constexpr std::size_t longest_unfinished = 1 << 16;

  Scheduler& scheduler_;
  std::unique_ptr<Stream> stream_;  ///< this or the window; both null: the wire is gone
  std::shared_ptr<Window> window_;  ///< also held by the burst that is under way
  std::vector<Station*> stations_;
  Station* spoke_last_ =
      nullptr;  ///< whose transaction was last on the wire; what makes no sense is told to it
  std::array<std::vector<Pending*>, 4> waiting_;  ///< by priority; few, and they keep their memory
  Pending* in_flight_ = nullptr;
  std::string received_;
  Instant sent_at_{}, deadline_at_{};
  Instant latest_end_ = Instant::max();  ///< of what is in flight: a stop has come
  /// From the end of the question to the answer, beyond its bytes; forgets slowly.
  Duration slowest_prompt_{};
  int prompt_answers_ = 0;
  int silent_in_a_row_ = 0;  ///< questions that nobody on the wire has answered
  Instant settle_until_{};   ///< after a miss: a late reply must not be taken for the next one's
  OwedAnswers left_owed_;    ///< by stations that have left
  std::shared_ptr<WillKeeper> keeper_;
  bool emulated_here_ = false, shared_ = false;
  std::vector<std::weak_ptr<WillKeeper::Will>> wills_;
  Timer deadline_;
  Timer settled_;
  Timer unfinished_;
};

}  // namespace hw
