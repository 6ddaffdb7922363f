#pragma once
// The threads that run the stored programs: the state of each as last read, and which may be running.
#include <chrono>
#include <string>
#include <string_view>

#include "core/device/in_turn.h"
#include "core/devices/arcus/restart_watch.h"

namespace hw::arcus {

class Threads {
 public:
  Threads(const Console& console, Conversation& conversation, CodeAtWork& code, SetUp& setup,
          RestartWatch& watch)
      : console_(console), conversation_(conversation), code_(code), setup_(setup), watch_(watch) {}

  /// Reads all threads; or those that run, and one of the others in turn.
  Task<Result<>> read(bool all, Priority priority);

  /// Call before the command is sent: it may start code even if it is not confirmed.
  void may_start(std::string_view command);
  /// A command to a thread (SR0=1) may change its state.
  void command_sent(std::string_view command);
  /// A program may run; within a second the status shows whether it still does.
  void program_runs(Duration at_most = std::chrono::seconds(1));

  /// Until `until` the thread is the console's own, and is not shown as a program of the user.
  void keep_apart(int thread, Instant until) { apart_ = thread, apart_until_ = until; }

  /// Whether the thread may run, as far as is known.
  [[nodiscard]] bool may_run(int thread) const;
  [[nodiscard]] bool any_may_run() const;
  /// The stored code may be written.
  [[nodiscard]] Result<> none_runs() const;
  /// `done`: "Nothing was sent."
  [[nodiscard]] tl::unexpected<Fault> no_program(int number, std::string done) const;
  /// For the state RunState::error.
  [[nodiscard]] static std::string error_sentence(int program, int line);

 private:
  Task<Result<>> read_one(int thread, Priority priority);
  void show_program() const;
  [[nodiscard]] bool is_apart(int thread) const {
    return thread == apart_ && console_.scheduler.now() < apart_until_;
  }

  const Console& console_;
  Conversation& conversation_;
  CodeAtWork& code_;
  SetUp& setup_;
  RestartWatch& watch_;
  InTurn first_;
  int apart_ = -1;
  Instant apart_until_{};
};

}  // namespace hw::arcus
