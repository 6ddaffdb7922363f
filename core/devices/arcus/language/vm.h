#pragma once
// The interpreter of stored programs: up to four program threads, and one for GS. A passive value without a
// clock: next_turn tells when the next turn is due, and the owner calls run_turn at that instant.
//
// Turns fall on whole milliseconds. In a turn each thread that is due runs one statement, program 0 first,
// the GS thread last (AMB-127). A statement that has to wait (WAIT, a move whose axis still moves) is retried
// on the first turn after the axis came to rest; until then its thread needs no turns. Nor does a thread that
// only loops reading inputs and variables (loop_watch.h). So the host calls next_turn again after each of its
// own events, commands and hands on the bench:
//
//   while (auto turn = vm.next_turn(now, host); turn && *turn <= until) {
//     advance motion to *turn (and ask again when something came to rest before); now = *turn;
//     vm.run_turn(now, host);
//   }
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/devices/arcus/language/loop_watch.h"
#include "core/devices/arcus/language/program.h"
#include "core/devices/arcus/language/vm_host.h"
#include "core/time/clock.h"

namespace hw::arcus::language {

/// The values of SASTAT.
enum class ThreadState : std::uint8_t { stopped = 0, running = 1, paused = 2, error = 4 };

/// Why a thread last went into SUB 31 or into error; for people.
enum class Trouble : std::uint8_t {
  none,
  axis_in_error,
  refused,  ///< the host refused a motion or a value
  division_by_zero,
  undefined_sub,
  too_deep,
  bad_line,  ///< the line holds no program
};

class Vm {
 public:
  /// Replaces the program and stops all threads. Variables stay.
  void load(std::shared_ptr<const Program> program);
  [[nodiscard]] const Program& program() const { return *program_; }

  /// SRn=command: 0 stop, 1 run, 2 pause, 3 continue (AMB-115). False: there is no such command or program
  /// number for any model; a program that is not loaded is no error and stays stopped.
  bool control(int program, int command, Instant now);
  enum class Call { started, busy, undefined };
  /// GSn: runs subroutine n in the GS thread (AMB-046).
  Call call(int sub, Instant now);
  void stop_all();

  [[nodiscard]] ThreadState state(int program) const { return threads_[program].state; }
  [[nodiscard]] ThreadState call_state() const { return threads_[gs_thread].state; }
  /// SPCn: the low-level line of the statement that runs next, that waits, or that failed; of a DELAY until
  /// its time has passed.
  [[nodiscard]] int line(int program, Instant now) const;
  /// The low-level line of the statement being run, while the host is called; -1: none.
  [[nodiscard]] int line_at_work() const { return line_at_work_; }
  [[nodiscard]] Trouble trouble(int program) const { return threads_[program].trouble; }

  [[nodiscard]] std::int32_t variable(int n) const { return variables_[n]; }
  void set_variable(int n, std::int32_t value) { variables_[n] = value; }

  /// When the next turn is due, not before `now`; none while every thread waits for an axis, is paused or
  /// stopped.
  [[nodiscard]] std::optional<Instant> next_turn(Instant now, const VmHost& host) const;
  /// One turn. A second call within the same millisecond does nothing.
  void run_turn(Instant now, VmHost& host);

 private:
  static constexpr int gs_thread = max_programs;

  struct Frame {
    std::uint16_t return_line = 0;
    std::uint8_t sub = 0;
    bool after_error = false;  ///< SUB 31, entered because something failed
  };
  struct Thread {
    ThreadState state = ThreadState::stopped;
    Trouble trouble = Trouble::none;
    std::uint8_t depth = 0;  ///< frames in use
    AxisSet waits_for;       ///< the statement at `line` waits until these are at rest
    std::uint16_t line = 0;
    std::uint16_t first_line = 0;
    Turn due = 0;                           ///< not before this turn
    std::optional<std::uint16_t> delay_at;  ///< line of the DELAY whose time has not passed
    LoopWatch loop;
    std::array<Frame, max_call_depth + 2> frames;  ///< one more for GS and one for SUB 31
    [[nodiscard]] bool handles_error() const;      ///< somewhere in SUB 31
  };
  /// The result of a statement.
  struct Next {
    enum class Kind : std::uint8_t { go, wait, fail, leave } kind = Kind::go;
    std::uint16_t line = 0;  ///< go
    AxisSet axes;            ///< wait
    Trouble trouble{};       ///< fail
  };
  class Statement;  // one statement being run (vm_statement.cpp)

  void start(Thread& thread, std::uint16_t line, Turn turn);
  void run_thread(Thread& thread, Turn turn, VmHost& host);
  /// Brings an idle thread up to date, as if it had run until just before `turn`.
  void catch_up(Thread& thread, Turn turn) const;
  void fail(Thread& thread, Trouble trouble, Turn turn);
  [[nodiscard]] std::int32_t value_of(const Operand& operand, const VmHost& host) const;
  [[nodiscard]] bool idles(const Thread& thread, const VmHost& host) const;
  [[nodiscard]] Turn first_turn(Instant now) const;

  std::shared_ptr<const Program> program_ = std::make_shared<const Program>();
  std::array<Thread, max_programs + 1> threads_;
  std::array<std::int32_t, variables> variables_{};
  Turn last_turn_ = -1;
  int line_at_work_ = -1;
};

}  // namespace hw::arcus::language
