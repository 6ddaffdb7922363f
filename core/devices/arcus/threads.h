#pragma once
// The threads that run the stored programs: what each does, as it was read, and what may be running.
#include <chrono>
#include <string_view>

#include "core/device/in_turn.h"
#include "core/devices/arcus/restart_watch.h"

namespace hw::arcus {

class Threads {
 public:
  Threads(const Console& console, Conversation& talk, CodeAtWork& code, SetUp& setup, RestartWatch& watch)
      : console_(console), talk_(talk), code_(code), setup_(setup), watch_(watch) {}

  /// All, or those that run and one of the others in turn.
  Task<Result<>> read(bool all, Priority priority);

  /// Before it goes out: code runs then, whether or not it is confirmed.
  void may_start(std::string_view command);
  /// What is told to a thread (SR0=1) may change what it does.
  void are_told(std::string_view command);
  /// Whether it still runs shows in the next second.
  void program_runs(Duration at_most = std::chrono::seconds(1));

  /// Until then it is the console's own, which is no program of the user's and is shown as none.
  void keep_apart(int thread, Instant until) { apart_ = thread, apart_until_ = until; }

  /// As far as is known.
  [[nodiscard]] bool may_run(int thread) const;
  [[nodiscard]] bool any_may_run() const;
  /// The stored code may be written.
  [[nodiscard]] Result<> none_runs() const;

 private:
  Task<Result<>> read_one(int thread, Priority priority);
  void show_program() const;
  [[nodiscard]] bool is_apart(int thread) const {
    return thread == apart_ && console_.scheduler.now() < apart_until_;
  }

  const Console& console_;
  Conversation& talk_;
  CodeAtWork& code_;
  SetUp& setup_;
  RestartWatch& watch_;
  InTurn first_;
  int apart_ = -1;
  Instant apart_until_{};
};

}  // namespace hw::arcus
