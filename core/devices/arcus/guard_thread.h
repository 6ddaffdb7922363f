#pragma once
// The guard of held jogs that the controller runs in a thread of its own (decision AMB-142): installed and
// taken away when its user says so; at work only while a hand holds a jog. Between jogs no thread runs and
// TOC is as it was.
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/guard_text.h"
#include "core/devices/arcus/stored_lines.h"

namespace hw::arcus {

class GuardThread {
 public:
  GuardThread(const Console& console, const language::Dialect& dialect, Conversation& talk, CodeAtWork& code,
              BorrowedSetting& borrowed, SetUp& setup, Threads& threads, StoredLines& stored)
      : console_(console),
        dialect_(dialect),
        talk_(talk),
        code_(code),
        borrowed_(borrowed),
        setup_(setup),
        threads_(threads),
        stored_(stored) {}

  Task<Result<>> install();
  Task<Result<>> remove();

  /// Before the first byte of a jog that a hand holds. Where none is installed nothing is sent.
  Task<Result<>> watch(int axis);
  /// Axes that stand are watched no more: each round, and before anything else that may move one.
  Task<Result<>> let_go();
  /// At rest: a few lines a round, until it is known what the program memory holds.
  Task<Result<>> look();

  /// Before a command of the user's: none may take from it what it works with, or store that.
  [[nodiscard]] Result<> allows(std::string_view command) const;
  /// Before a command goes out: the stored code is another then. What it owes it owes all the same.
  void goes_out(std::string_view command);
  /// What it is doing shows when it is looked at again.
  void forget();
  [[nodiscard]] bool at_work() const { return watched_ != 0; }

 private:
  Task<Result<>> may_install();
  Task<Result<std::int64_t>> try_time_out();
  Task<Result<>> start(unsigned axes);
  Task<Result<>> still_there();
  Task<Result<>> time_out_is_as_it_was();
  Task<Result<>> take_over();
  void is_installed(std::vector<std::string> lines, std::int64_t time_out);
  void is(JogGuard::State state);
  void watches(unsigned axes);
  [[nodiscard]] std::chrono::milliseconds silence() const;
  Task<Result<>> set(std::string name, std::int64_t value);

  const Console& console_;
  const language::Dialect& dialect_;
  Conversation& talk_;
  CodeAtWork& code_;
  BorrowedSetting& borrowed_;
  SetUp& setup_;
  Threads& threads_;
  StoredLines& stored_;
  std::vector<std::string> lines_;  ///< of the guard; while it is looked for: those that were read
  std::int64_t time_out_ = 0;       ///< TOC while no jog is held
  unsigned watched_ = 0;            ///< a bit per axis
};

}  // namespace hw::arcus
