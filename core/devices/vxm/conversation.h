#pragma once
// What is said to the controller and what it says: questions with their answers, and messages that nobody
// asked for. Nothing else of the driver looks at bytes.
#include <functional>
#include <optional>
#include <string>

#include "core/base/asio.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/text_pieces.h"
#include "core/link/station.h"

namespace hw::vxm {

/// A question may be asked again.
inline bool worth_another_try(const Fault& fault) {
  return fault.kind == FaultKind::no_answer || fault.kind == FaultKind::garbled;
}

class Conversation {
 public:
  /// `listening`: see listens(). `heard`: a message that came unasked.
  Conversation(Scheduler& scheduler, std::function<Listening()> listening,
               std::function<void(const Message&)> heard);

  void attach(Station& station);
  void lost();
  /// Null: there is no wire.
  [[nodiscard]] Station* station() const { return station_; }
  /// While the controller is being opened its questions are asked more often.
  void be_patient(bool patient) { patient_ = patient; }

  // ---- questions
  Task<Result<char>> state(Priority priority);
  Task<Result<Steps>> position(int motor, Priority priority);
  Task<Result<std::int64_t>> number(std::string question, Priority priority);
  /// What is sent has had its effect when its last question is answered by this number; else it is sent once
  /// more, and so must do no harm when it comes twice.
  Task<Result<>> confirm(std::string text, std::int64_t number, Priority priority);
  Task<Result<std::string>> text(std::string question, Priority priority);
  Task<Result<Listing>> listing(Priority priority);
  /// One of so many commands, without the silence that ends it else.
  Task<Result<Listing>> listing_of(std::size_t commands, Priority priority);
  /// ?, ~ or $. Its answer may be any byte: it is to be believed when what was asked after it was answered,
  /// and no stray() has come meanwhile.
  Task<Result<unsigned char>> raw(char question, Priority priority);
  /// D, in Local mode only.
  Task<Result<std::string>> places(ReplyShape shape, Priority priority);
  /// V, also while late answers of others may come: all that comes back until it is quiet.
  Task<Result<std::string>> greet(std::uint16_t quiet_ms);
  /// V, of a controller that usually does not answer; no miss.
  Task<Result<std::string>> whether_it_hears();
  /// Anything else that is answered; a look that is not told may be any.
  Task<Result<std::string>> ask(std::string question, AnswerShape answer, Priority priority);
  Task<Result<std::string>> kill(Priority priority, Duration patience);

  // ---- what is not answered
  Task<Result<>> say(std::string text, Priority priority);
  /// Whatever the line owes: it begins the conversation anew.
  Task<Result<>> say_anyway(std::string text);
  /// After an answer that made no sense: whatever still comes must not be taken for the next one, and nothing
  /// may be sent while the controller sends (the overrun of the manual's p.30 locks it until power-off). What
  /// babbles on is no VXM: it is not waited for.
  Task<Result<>> wait_for_quiet();

  /// What the controller takes now, as far as is known.
  [[nodiscard]] Listening listens() const { return listening_(); }
  [[nodiscard]] Instant heard_at() const { return heard_at_; }
  /// When the question that was answered last had gone out: what it told may be as old.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// How many bytes have come that belong to no answer and to no message.
  [[nodiscard]] std::uint32_t strays() const { return strays_; }
  /// How often a question was asked once more: what went with it may have arrived as something else.
  [[nodiscard]] std::uint32_t repeats() const { return repeats_; }
  /// How often the line was cleaned.
  [[nodiscard]] std::uint32_t times_cleaned() const { return station_ ? station_->times_cleaned() : 0; }
  [[nodiscard]] bool echoes() const { return echoes_; }
  void set_echoes(bool echoes) { echoes_ = echoes; }

 private:
  Task<Result<std::string>> exchange(Transaction transaction);
  template <class T>
  Task<Result<T>> decoded(Transaction question, std::function<std::optional<T>(std::string_view)> decode);
  std::size_t hear(std::string_view bytes);
  [[nodiscard]] bool believes(const Message& message) const;

  Scheduler& scheduler_;
  std::function<Listening()> listening_;
  std::function<void(const Message&)> heard_;
  Station* station_ = nullptr;
  bool patient_ = false;
  int prompt_greetings_ = 0;  ///< one behind the other
  std::string unasked_;       ///< a message that has not come to its end
  Instant heard_at_{}, asked_at_{};
  std::string asked_;  ///< last: what comes back of it unchanged is an echo
  bool echoes_ = false;
  std::uint32_t strays_ = 0, repeats_ = 0;
  bool raw_asked_ = false;
  std::optional<char> second_raw_;
};

}  // namespace hw::vxm
