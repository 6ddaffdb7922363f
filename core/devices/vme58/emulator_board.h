#pragma once
// The firmware of the board: characters from the ring to commands, commands to queues, queues to motion; and
// the registers that the host reads.
//
//   ring -> Parser -> obey() -> at once: set, stop, answer
//                        '----> CommandQueue (X..S, AA, AM) -> run_queues() -> Motion
//   Motion -> events -> flags, outputs, queues
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/devices/vme58/board_options.h"
#include "core/devices/vme58/emulator_contour.h"
#include "core/devices/vme58/emulator_flags.h"
#include "core/devices/vme58/emulator_io.h"
#include "core/devices/vme58/emulator_motion.h"
#include "core/devices/vme58/emulator_notes.h"
#include "core/devices/vme58/emulator_parser.h"
#include "core/devices/vme58/emulator_queue.h"
#include "core/devices/vme58/emulator_window.h"

namespace hw::vme58 {

/// Contexts that commands address. The first eight are the axes.
inline constexpr int context_all = most_axes, context_tasks = most_axes + 1, contexts = most_axes + 2;

/// A queue and the board's progress in it.
struct BoardTask {
  CommandQueue queue;
  Move prepared;                      ///< by MA MR MT ML, for the next GO
  unsigned last_axes = 0;             ///< of the last move: ID sets their flags (decision M53)
  unsigned driven = 0;                ///< moved by it since it was last emptied: ST stops them
  unsigned running = 0;               ///< moved by the current command; 0: not under way
  std::size_t looked_ahead = 0;       ///< II and IN behind the current command, done already
  std::optional<Instant> wait_until;  ///< the queue pauses until then
  bool waiting = false;               ///< for WT, the current command
  bool leave_while = false;           ///< CW was received
  Instant turn_began{};               ///< start of the present turn of the innermost loop
  /// Sets done flags once these axes rest: II, and ID and IP in the AM queue, which goes on meanwhile.
  struct Promise {
    unsigned axes;
    bool in_position;  ///< IP: they must also be within HD
  };
  std::vector<Promise> promises;
};

class Board {
 public:
  /// `make` also applies after each reset.
  explicit Board(const BoardOptions& make);

  // Time.
  [[nodiscard]] Instant now() const { return motion_.now(); }
  [[nodiscard]] std::optional<Instant> next_event() const;
  /// Advances to `to`, which must not be later than next_event(), and handles all that is due then.
  void advance(Instant to);

  // Power.
  void power(bool on);
  [[nodiscard]] bool powered() const { return powered_; }

  // The bus (emulator_registers.cpp).
  std::uint8_t read(std::uint16_t offset);
  void write(std::uint16_t offset, std::uint8_t value);
  /// Must be called after the last byte of a write cycle.
  void written(std::uint16_t offset);
  [[nodiscard]] std::optional<std::uint8_t> interrupt() const { return flags_.interrupt(); }
  void acknowledge() { flags_.acknowledge(); }

  // The bench.
  Motion& motion() { return motion_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] const UserIo& io() const { return io_; }
  void pull_line(int line, bool low);
  /// Call after a change on the bench: handles its consequences.
  void settle();
  [[nodiscard]] const Variant& variant() const { return *variant_; }
  /// For tests and rehearsals.
  [[nodiscard]] const BoardTask& task(int context) const { return tasks_[ix(context)]; }
  /// Records events in `notes` from now on; null: stops recording.
  void record_to(Notes* notes) { notes_ = notes; }
  [[nodiscard]] bool booting() const { return boots_until_.has_value(); }
  /// No text or command waits, no command is under way, no axis moves.
  [[nodiscard]] bool idle() const;

 private:
  // Text (emulator_board.cpp).
  void reset();
  void pump();
  [[nodiscard]] unsigned modes() const;
  void flush_replies();
  void command_error();
  /// A command error that also spoils the contour being recorded.
  void text_error();

  // Operands (emulator_operands.cpp).
  void obey(const Command& typed);
  [[nodiscard]] bool resolve(Command& command) const;
  [[nodiscard]] bool resolve_number(const Command& command, int place, double& value) const;
  [[nodiscard]] bool axes_fit(const Command& command) const;
  [[nodiscard]] double unit_of(const Command& command, int place) const;
  [[nodiscard]] int contour_axis(int place) const;
  /// Axes that the command addresses, by its list or by the present mode.
  [[nodiscard]] unsigned addressed(const Command& command) const;
  [[nodiscard]] unsigned context_axes() const { return axes_of(context_); }
  [[nodiscard]] unsigned axes_of(int context) const { return context < most_axes ? 1u << context : fitted_; }
  /// f(axis, number) for each number of a list.
  template <class F>
  void each(const Command& c, int context, F f) {
    if (context < most_axes) return f(context, c.first());
    for (int a = 0; a < most_axes; ++a)
      if (c.number[ix(a)]) f(a, *c.number[ix(a)]);
  }
  template <class F>
  static void each_axis(unsigned axes, F f) {
    for (int a = 0; a < most_axes; ++a)
      if ((axes >> a & 1u) != 0) f(a);
  }

  // Commands at once (emulator_immediate.cpp).
  void do_at_once(const Command& c);
  void set_mode(const Command& c);
  bool set_axis(const Command& c);
  bool set_encoder(const Command& c);
  bool stop_or_clear(Op op);
  void select(int context);
  void stop_axes(unsigned axes);
  void stop_everything();
  void flush(int context);
  void flush_all();
  void force_position(const Command& c);
  void load_positions(const Command& c);
  void set_units(const Command& c);

  // Queues (emulator_queues.cpp).
  void put_in_queue(const Command& c);
  void run_queues();
  bool run_task(int context);
  /// Outcome of the current command of a queue.
  enum class Step : std::uint8_t { done, waits, runs, moved_on };
  Step step(int context, const Command& c);
  /// Axes whose motions the command must wait for.
  [[nodiscard]] unsigned waits_for(int context, const Command& c) const;
  [[nodiscard]] bool any_occupied(unsigned axes) const;
  [[nodiscard]] bool all_in_position(unsigned axes) const;
  void look_ahead(int context);
  void raise_promised_flags(BoardTask& t);
  [[nodiscard]] bool runs_empty(int context) const;
  Step wait_time(BoardTask& t, const Command& c);
  Step open_block(BoardTask& t, const Command& c);
  Step end_block(BoardTask& t, bool again);

  // The effect of a queued command (emulator_queued.cpp).
  Step execute(int context, const Command& c);
  Step motion_began(int context, unsigned axes);
  /// Drops the command: the motion refused it.
  Step refused() {
    command_error();
    return Step::done;
  }
  Step set_speeds(int context, const Command& c);
  Step prepare(int context, const Command& c);
  Step go(int context, bool clear_done);
  Step jog(int context, const Command& c);
  Step home(int context, const Command& c);
  Step staircase(int context, const Command& c);
  Step play_contour(int context);
  Step raise_done(int context, bool in_position);
  Step promise_each(int context);
  Step notify(int context, const Command& c);
  [[nodiscard]] unsigned flagged_axes(int context) const;

  // Contours (emulator_record.cpp).
  void begin_recording(const Command& c);
  void record(const Command& c);

  // Queries (emulator_queries.cpp).
  void answer(const Command& c);
  [[nodiscard]] std::string axis_status(int axis) const;
  [[nodiscard]] std::string encoder_status(int axis) const;
  [[nodiscard]] std::string user_position(int axis) const;

  // Notes (emulator_notes.h).
  void note(Note::What what, int number = 0, bool on = false);
  /// For a command that depends on the line; notes the look.
  [[nodiscard]] bool line_is_true(int line) {
    note(Note::What::looks, line, io_.is_true(line));
    return io_.is_true(line);
  }
  void set_done(unsigned axes);
  void switch_aux(unsigned axes, bool high);
  void drive_line(int line, bool low);
  /// Notes outputs that have changed.
  void note_outputs(unsigned lines_before, unsigned aux_before);

  // Events of the motion, and timed events.
  void take_events();
  void take_event(const MotionEvent& e);
  void empty_queues_of(int axis);
  void look_at_switches();
  void copy_axis_data();
  void take_mail();
  void acknowledge_mail();
  void set_control(std::uint8_t value);

  void set_factory_values();

  BoardOptions make_;
  const Variant* variant_;
  unsigned fitted_;
  bool powered_ = true;
  std::optional<Instant> boots_until_;

  Window window_;
  Flags flags_;
  UserIo io_;
  Parser parser_;
  Motion motion_;
  std::array<BoardTask, contexts> tasks_{};
  int context_ = 0;
  bool echo_ = false;
  std::string replies_;             ///< waiting for room in the ring
  std::optional<Command> held_;     ///< read, but its queue is full
  std::optional<int> waits_empty_;  ///< WQ: context whose queue must run empty

  ContourRecorder recorder_;

  std::optional<Instant> update_due_, mail_due_;
  std::array<std::optional<Instant>, most_axes> power_drops_at_{};
  std::vector<MotionEvent> events_;
  Notes* notes_ = nullptr;
  int source_ = 0;  ///< source of the current command
};

}  // namespace hw::vme58
