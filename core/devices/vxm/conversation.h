#pragma once
// Sends questions and commands to the controller, and receives replies and unsolicited messages. No other
// part of the driver looks at bytes.
#include <functional>
#include <optional>
#include <string>

#include "core/base/asio.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/link/station.h"

namespace hw::vxm {

/// True: the question may be asked again.
inline bool worth_another_try(const Fault& fault) {
  return fault.kind == FaultKind::no_answer || fault.kind == FaultKind::garbled;
}

inline constexpr const char* check_line =
    "Check the cable, the baud rate, and whether another program talks to the controller.";

class Conversation {
 public:
  /// `listening`: see listens(). `on_unsolicited`: receives unsolicited messages.
  Conversation(Scheduler& scheduler, std::function<Listening()> listening,
               std::function<void(const Message&)> on_unsolicited);

  void attach(Station& station);
  void lost();
  /// Null: no wire.
  [[nodiscard]] Station* station() const { return station_; }
  /// True while the controller is being opened: questions are repeated more often.
  void use_long_deadlines(bool patient) { patient_ = patient; }

  // ---- questions
  Task<Result<char>> state(Priority priority);
  Task<Result<Steps>> position(int motor, Priority priority);
  Task<Result<std::int64_t>> number(std::string question, Priority priority);
  /// Sends a text whose last question must be answered by `number`. Otherwise the text is sent once more, so
  /// it must be harmless when received twice.
  Task<Result<>> confirm(std::string text, std::int64_t number, Priority priority);
  Task<Result<std::string>> text(std::string question, Priority priority);
  Task<Result<Listing>> listing(Priority priority);
  /// A listing of `commands` commands: ends at its last line, not by a silence.
  Task<Result<Listing>> listing_of(std::size_t commands, Priority priority);
  /// ?, ~ or $. The reply may be any byte. It counts only once a later question has been answered and
  /// unexpected() has not changed meanwhile.
  Task<Result<unsigned char>> raw(char question, Priority priority);
  /// D, in Local mode only.
  Task<Result<std::string>> places(ReplyShape shape, Priority priority);
  /// Asks V, even while late replies may come. Returns all bytes received until the line is quiet.
  Task<Result<std::string>> greet(std::uint16_t quiet_ms);
  /// Asks V of a controller that usually does not answer. Silence does not count as a miss.
  Task<Result<std::string>> ask_while_silent();
  /// Any other question. Without a given kind of reply, its reply may have any form.
  Task<Result<std::string>> ask(std::string question, AnswerShape answer, Priority priority);
  Task<Result<std::string>> kill(Priority priority, Duration patience);

  // ---- commands without a reply
  Task<Result<>> transmit(std::string text, Priority priority);
  /// Sent even while replies are outstanding: begins the conversation anew.
  Task<Result<>> transmit_anyway(std::string text);
  /// Call after a reply that made no sense. Bytes still to come must not be taken for the next reply, and
  /// nothing may be sent while the controller sends (the overrun of the manual's p.30 locks it until
  /// power-off). It does not wait for the end of endless noise, which no VXM sends.
  Task<Result<>> wait_for_quiet();

  /// The state that decides which commands the controller takes now, as far as known.
  [[nodiscard]] Listening listens() const { return listening_(); }
  [[nodiscard]] Instant received_at() const { return received_at_; }
  /// When the question answered last was sent: its reply may be that old.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// Number of bytes received that belong to no reply and no message.
  [[nodiscard]] std::uint32_t unexpected() const { return unexpected_; }
  /// How often a question was repeated: text sent with it may have been received garbled.
  [[nodiscard]] std::uint32_t repeats() const { return repeats_; }
  /// How often the line was cleaned.
  [[nodiscard]] std::uint32_t times_cleaned() const { return station_ ? station_->times_cleaned() : 0; }
  [[nodiscard]] bool echoes() const { return echoes_; }
  void set_echoes(bool echoes) { echoes_ = echoes; }

 private:
  Task<Result<std::string>> exchange(Transaction transaction);
  template <class T>
  Task<Result<T>> decoded(Transaction question, std::function<std::optional<T>(std::string_view)> decode);
  std::size_t receive_unsolicited(std::string_view bytes);
  [[nodiscard]] bool believes(const Message& message) const;

  Scheduler& scheduler_;
  std::function<Listening()> listening_;
  std::function<void(const Message&)> on_unsolicited_;
  Station* station_ = nullptr;
  bool patient_ = false;
  int prompt_greetings_ = 0;  ///< in a row
  std::string unsolicited_;   ///< an unfinished message
  Instant received_at_{}, asked_at_{};
  std::string asked_;  ///< sent last; received back unchanged, it is an echo
  bool echoes_ = false;
  std::uint32_t unexpected_ = 0, repeats_ = 0;
  bool raw_asked_ = false;
  std::optional<char> second_raw_;
};

}  // namespace hw::vxm
