#pragma once
// The guard of held jogs, which the controller runs in its own thread (decision AMB-142): installed and
// removed at the user's request, at work only while a jog is held. Between jogs no thread runs and TOC has
// its former value.
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/guard_text.h"
#include "core/devices/arcus/stored_lines.h"

namespace hw::arcus {

class GuardThread {
 public:
  GuardThread(const Console& console, const language::Dialect& dialect, Conversation& conversation,
              CodeAtWork& code, BorrowedSetting& borrowed, SetUp& setup, Threads& threads,
              StoredLines& stored)
      : console_(console),
        dialect_(dialect),
        conversation_(conversation),
        code_(code),
        borrowed_(borrowed),
        setup_(setup),
        threads_(threads),
        stored_(stored) {}

  Task<Result<>> install();
  Task<Result<>> remove();

  /// Call before the first byte of a held jog. Sends nothing if no guard is installed.
  Task<Result<>> watch(int axis);
  /// Stops watching axes that stand. Call each round, and before anything else that may move an axis.
  Task<Result<>> let_go();
  /// At rest: reads a few lines a round, until the content of program memory is known.
  Task<Result<>> look();

  /// Call before a user's command: refuses one that would change or store what the guard uses.
  [[nodiscard]] Result<> allows(std::string_view command) const;
  /// Call before a command is sent: it may change the stored code. Watched axes and TOC still have to be put
  /// back.
  void goes_out(std::string_view command);
  /// The guard's state is unknown until look() has read it.
  void forget();
  [[nodiscard]] bool at_work() const { return watched_ != 0; }
  /// Refuses to write the program memory while the guard watches a jog.
  [[nodiscard]] Result<> may_be_overwritten() const;

 private:
  Task<Result<>> may_install();
  Task<Result<std::int64_t>> try_time_out();
  Task<Result<>> start(unsigned axes);
  Task<Result<>> still_there();
  Task<Result<>> confirm_time_out_unchanged();
  Task<Result<>> take_over();
  void is_installed(std::vector<std::string> lines, std::int64_t time_out);
  void is(JogGuard::State state);
  void watches(unsigned axes);
  [[nodiscard]] std::chrono::milliseconds silence() const;
  Task<Result<>> set(std::string name, std::int64_t value);

  const Console& console_;
  const language::Dialect& dialect_;
  Conversation& conversation_;
  CodeAtWork& code_;
  BorrowedSetting& borrowed_;
  SetUp& setup_;
  Threads& threads_;
  StoredLines& stored_;
  std::vector<std::string> lines_;  ///< of the guard; during the search those read so far
  std::int64_t time_out_ = 0;       ///< TOC while no jog is held
  unsigned watched_ = 0;            ///< a bit per axis
};

}  // namespace hw::arcus
