#pragma once
// The traffic with one device: questions, commands, broadcasts, unsolicited messages. Bytes become texts only
// here. Late replies: the station records outstanding replies by their kinds, and asks for the device's name,
// product or version before anything else is sent. Replies carry no address (except with RT=1), so while a
// reply of the same kind from another device on the line is outstanding, a reply is accepted only if this
// device's own name follows it.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/console.h"
#include "core/devices/arcus/reply_kinds.h"
#include "core/link/station.h"

namespace hw::arcus {

/// The text was never sent.
inline bool was_kept_back(const Fault& fault) {
  return fault.kind == FaultKind::stopped || fault.kind == FaultKind::refused;
}

/// After such a fault a question may be asked again.
inline bool worth_another_try(const Fault& fault) {
  return fault.kind == FaultKind::no_answer || fault.kind == FaultKind::garbled;
}

/// Wait for the reply to each text of a stop; then the next is sent, even if this controller's replies are
/// late.
inline constexpr Duration until_next_of_stop = Millis(60);

/// Bytes in printable form, for sentences.
std::string printable(std::string_view bytes);

class Conversation {
 public:
  explicit Conversation(const Console& console) : console_(console) {}

  void attach(Station& station);
  void wire_lost() { station_ = nullptr; }
  [[nodiscard]] bool is_open() const { return station_ != nullptr; }
  /// Null: the wire is lost.
  [[nodiscard]] Station* station() const { return station_; }
  [[nodiscard]] Framing framing() const;
  /// Replies not received in time, in total.
  [[nodiscard]] std::uint64_t misses() const { return station_ ? station_->statistics().timeouts : 0; }

  /// When the question answered last was sent: its value may be that old.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// How often the line has become clean again.
  [[nodiscard]] std::uint32_t times_cleaned() const { return station_ ? station_->times_cleaned() : 0; }

  /// `goes_out` is called with each command to this device just before it is sent, `not_done` if the command
  /// was refused or not sent.
  std::function<void(std::string_view command)> goes_out, not_done;

  /// A question more urgent than a status round: when due, it is asked before the next question of the round.
  struct Urgent {
    std::function<bool()> is_due;
    std::function<Task<>()> ask;
  };
  Urgent urgent;

  // ---- questions: asked twice if the reply is missing or makes no sense
  Task<Result<std::string>> ask(std::string question, Priority priority, bool again = false);
  Task<Result<std::string>> ask_for(std::string question, std::function<bool(std::string_view)> makes_sense,
                                    Priority priority);
  Task<Result<std::int64_t>> ask_number(std::string question, Priority priority);
  Task<Result<std::vector<std::int64_t>>> ask_numbers(std::string question, std::size_t count,
                                                      Priority priority);
  /// A digit lost or doubled on the line leaves another plausible number: the question for a value other than
  /// `expected` is repeated until two replies agree.
  using Decode = std::function<std::optional<std::int64_t>(std::string_view)>;
  Task<Result<std::int64_t>> ask_confirmed(std::string question, Decode decode,
                                           std::optional<std::int64_t> expected, Priority priority);
  // ---- commands: sent once
  Task<Result<>> command(std::string text, Priority priority, Duration patience = Millis(200));
  /// One command or question and its reply, refusals included.
  Task<Result<Reply>> exchange(std::string text, Priority priority, Duration patience,
                               bool own_question = false);
  /// If a reply is outstanding, asks the device for its name. The next reply then belongs to the next text.
  Task<bool> clean_line(Priority priority);
  /// Sent to every device of the line; none replies.
  Task<Result<>> broadcast(std::string text, Priority priority);

  // ---- finding devices
  /// Sent on a dirty line too; the name in the reply is not checked.
  Task<Result<Reply>> greet(Duration patience);
  Task<> wait_for_quiet();
  void forget_unexpected() { unexpected_ = line_feeds_ = 0; }
  /// Unsolicited texts, and line feeds that something on the line adds to replies (CR LF).
  [[nodiscard]] int unexpected() const { return unexpected_; }
  [[nodiscard]] int line_feeds() const { return line_feeds_; }
  /// The device's name; empty: it does not know the question.
  void know_name(std::string_view name);
  void know_product(bool known) { product_known_ = known; }

  [[nodiscard]] tl::unexpected<Fault> no_connection() const;
  [[nodiscard]] tl::unexpected<Fault> refusal(std::string_view sent, std::string_view reply) const;
  [[nodiscard]] tl::unexpected<Fault> two_devices_answer() const;

 private:
  Task<Result<Reply>> transmit(std::string text, Priority priority, Duration patience, bool own_question,
                               bool on_dirty_line);
  Task<Result<Reply>> exchange_question(std::string question, Priority priority, bool again);
  Task<Result<>> may_go_out(std::string_view text, Priority priority);
  Task<Result<>> receive_its_name(Priority priority);
  [[nodiscard]] std::optional<Station::Unmistakable> unmistakable(const OutstandingReplies& outstanding,
                                                                  Instant now) const;
  [[nodiscard]] Station::Unmistakable identity_question(std::string_view question,
                                                        std::function<bool(std::string_view)> is_it) const;
  [[nodiscard]] std::string framed(std::string_view text, Priority priority, int address) const;
  [[nodiscard]] bool others_may_reply(ReplyKind reply_kind) const;
  [[nodiscard]] bool is_its_name(std::string_view text) const;
  [[nodiscard]] bool is_other_devices_name(std::string_view bytes) const;
  std::size_t receive_unsolicited(std::string_view bytes);

  const Console& console_;
  Station* station_ = nullptr;
  Instant received_at_{}, asked_at_{};
  int texts_received_ = 0;  ///< unsolicited texts, late replies included
  int unexpected_ = 0;      ///< those that no late reply explains
  int line_feeds_ = 0;
  std::optional<int> also_called_;  ///< another number for its name, until a power cycle
  bool named_ = true;               ///< its name has a number
  bool product_known_ = true;       ///< it answers ID with the expected product
};

}  // namespace hw::arcus
