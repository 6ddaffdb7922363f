#pragma once
// What is said to one device and what it answers: questions, commands, texts for all, what comes unasked.
// Only here bytes become texts. Late answers: the station owes them by their looks, and asks for the device's
// name, product or version before anything else goes out. Replies carry no address (but with RT=1), so while
// another device of the line owes one that looks alike, an answer is believed only with this device's own
// name behind it.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/console.h"
#include "core/devices/arcus/looks.h"
#include "core/link/station.h"

namespace hw::arcus {

/// It never went out.
inline bool was_kept_back(const Fault& fault) {
  return fault.kind == FaultKind::stopped || fault.kind == FaultKind::refused;
}

/// A question may be asked again.
inline bool worth_another_try(const Fault& fault) {
  return fault.kind == FaultKind::no_answer || fault.kind == FaultKind::garbled;
}

/// Of each text of a stop: then the next goes out, whether or not the answers of this controller are late.
inline constexpr Duration until_next_of_stop = Millis(60);

/// Bytes as a sentence can show them.
std::string printable(std::string_view bytes);

class Conversation {
 public:
  explicit Conversation(const Console& console) : console_(console) {}

  void attach(Station& station);
  void wire_lost() { station_ = nullptr; }
  [[nodiscard]] bool is_open() const { return station_ != nullptr; }
  /// Null: the wire is gone.
  [[nodiscard]] Station* station() const { return station_; }
  [[nodiscard]] Framing framing() const;
  /// Answers that have not come in time, ever.
  [[nodiscard]] std::uint64_t misses() const { return station_ ? station_->statistics().timeouts : 0; }

  /// When the question that was answered last had gone out: what it told may be as old.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// How often the line has become clean again.
  [[nodiscard]] std::uint32_t times_cleaned() const { return station_ ? station_->times_cleaned() : 0; }

  /// Told of each command of this device just before it goes out; and when it was refused, or did not go out.
  std::function<void(std::string_view command)> goes_out, not_done;

  /// What somebody waits for more than for a round of status: where it is due it is asked in front of the
  /// next question of the round.
  struct Urgent {
    std::function<bool()> is_due;
    std::function<Task<>()> ask;
  };
  Urgent urgent;

  // ---- questions: asked twice where nothing or nonsense comes
  Task<Result<std::string>> ask(std::string question, Priority priority, bool again = false);
  Task<Result<std::string>> ask_for(std::string question, std::function<bool(std::string_view)> makes_sense,
                                    Priority priority);
  Task<Result<std::int64_t>> ask_number(std::string question, Priority priority);
  Task<Result<std::vector<std::int64_t>>> ask_numbers(std::string question, std::size_t count,
                                                      Priority priority);
  /// A digit that is lost or doubled on the way leaves another number that looks right: what differs from
  /// `expected` is asked for until two answers agree.
  using Decode = std::function<std::optional<std::int64_t>(std::string_view)>;
  Task<Result<std::int64_t>> ask_surely(std::string question, Decode decode,
                                        std::optional<std::int64_t> expected, Priority priority);
  // ---- commands: sent once
  Task<Result<>> command(std::string text, Priority priority, Duration patience = Millis(200));
  /// One command or question and its reply, whatever it says.
  Task<Result<Reply>> exchange(std::string text, Priority priority, Duration patience,
                               bool own_question = false);
  /// Asks who it is, if an answer is owed: what comes then is the answer to what is sent then.
  Task<bool> come_clean(Priority priority);
  /// To every device of the line; none answers.
  Task<Result<>> broadcast(std::string text, Priority priority);

  // ---- finding out who is there
  /// Also on a dirty line, and whoever answers.
  Task<Result<Reply>> greet(Duration patience);
  Task<> wait_for_quiet();
  void forget_strays() { strays_ = line_feeds_ = 0; }
  /// Texts that nobody asked for, and whatever something on the way has made of the ends of answers (CR LF).
  [[nodiscard]] int strays() const { return strays_; }
  [[nodiscard]] int line_feeds() const { return line_feeds_; }
  /// What it calls itself; empty: it does not know the question.
  void know_name(std::string_view name);
  void know_product(bool known) { product_known_ = known; }

  [[nodiscard]] tl::unexpected<Fault> no_connection() const;
  [[nodiscard]] tl::unexpected<Fault> refusal(std::string_view sent, std::string_view reply) const;
  [[nodiscard]] tl::unexpected<Fault> two_answer() const;

 private:
  Task<Result<Reply>> say(std::string text, Priority priority, Duration patience, bool own_question,
                          bool on_dirty_line);
  Task<Result<Reply>> exchange_question(std::string question, Priority priority, bool again);
  Task<Result<>> may_go_out(std::string_view text, Priority priority);
  Task<Result<>> hear_its_name(Priority priority);
  [[nodiscard]] std::optional<Station::Unmistakable> unmistakable(const OwedAnswers& owed, Instant now) const;
  [[nodiscard]] Station::Unmistakable asks_who(std::string_view question,
                                               std::function<bool(std::string_view)> is_it) const;
  [[nodiscard]] std::string framed(std::string_view text, Priority priority, int address) const;
  [[nodiscard]] bool others_may_say(Look look) const;
  [[nodiscard]] bool is_its_name(std::string_view text) const;
  [[nodiscard]] bool is_anothers_name(std::string_view bytes) const;
  std::size_t hear(std::string_view bytes);

  const Console& console_;
  Station* station_ = nullptr;
  Instant heard_at_{}, asked_at_{};
  int texts_heard_ = 0;  ///< that nobody waited for, be they late
  int strays_ = 0;       ///< of those, what no late answer explains
  int line_feeds_ = 0;
  std::optional<int> also_called_;  ///< beside its address: until it is switched off and on
  bool named_ = true;               ///< its name has a number
  bool product_known_ = true;       ///< it answers ID as it should
};

}  // namespace hw::arcus
