#pragma once
// Readings of the window: the registers, and the board's copy of its axis data. Reading the done and slip
// registers clears them for all hosts, so they are not read here (decisions M31, M32). Reading the limit
// register clears only a hit that is over, which is remembered.
#include <array>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/in_turn.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/wire.h"

namespace hw::vme58 {

struct Registers {
  std::uint8_t control = 0, status = 0, limit = 0, home = 0;
  std::uint16_t io = 0, mark = 0;
  int input_put = 0, output_get = 0, output_put = 0;
  [[nodiscard]] bool started() const { return (status & status::initialized) != 0; }
};

/// The fault for a command error reported after `text`.
tl::unexpected<Fault> rejected_by_board(std::string_view text);

class Readings {
 public:
  /// Receives the readings.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void registers_read(const Registers& registers) = 0;
    /// Three values of each axis were read, and all of axis `whole`.
    virtual void axes_read(int whole, Instant at) = 0;
  };
  /// Whether the board was already asked to copy its axis data, with the registers, or must be asked now.
  enum class Copy : std::uint8_t { is_asked_for, ask };

  Readings(Wire& wire, const Catalog& catalog, Snapshot& snapshot, Listener& listener)
      : wire_(wire), catalog_(catalog), snapshot_(snapshot), listener_(listener) {}

  // ---- registers
  /// `ask_for_data`: asks the board in the same burst to copy the axis data.
  Task<Result<Registers>> read_registers(Priority priority, bool ask_for_data);
  void take(const Registers& registers);
  Task<Result<>> look_at_registers(Priority priority, bool ask_for_data = false);
  /// The status register, as last read.
  [[nodiscard]] std::uint8_t status() const { return status_; }
  /// Reads the status register, which clears the command error in the board, and returns whether one was
  /// pending. Each error is reported to one caller only.
  Task<Result<bool>> was_rejected(Priority priority);
  bool take_command_error();
  void put_back_command_error() { command_error_ = true; }
  void forget_command_error() { command_error_ = false; }

  // ---- data area
  /// Waits for the board's copy, then reads three values of each axis and all of one axis in turn.
  Task<Result<>> read_axes(Priority priority, Copy copy = Copy::ask);
  Task<Result<>> read_all(Priority priority);
  /// The next read_axes() reads all values of this axis.
  void next_is(int axis) { whole_.jump_to(axis); }
  /// Time before the first look for a copy; a recording needs every copy.
  void look_after(Duration time) { first_look_ = time; }
  [[nodiscard]] std::int64_t value(int axis, AxisValue v) const;
  /// Sets a value known before its turn to be read.
  void know(int axis, AxisValue v, std::int64_t value);
  /// Whether the axis moves, by its velocity; false until that has been read since the connection.
  [[nodiscard]] bool moving(int axis) const;
  /// Whether the axes had been read since the connection, before the reading now being reported.
  [[nodiscard]] bool seen() const { return seen_; }
  /// The connection was lost, or the board was reset.
  void forget();

  /// Reads rings, indexes and mailbox, for the memory map.
  Task<Result<>> read_rings(Priority priority);
  static constexpr Duration copy_time = std::chrono::microseconds(1000);  ///< decision M26: about 1 ms

 private:
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  void take_values(const std::vector<BusCycle>& cycles);
  tl::unexpected<Fault> unanswered();

  Wire& wire_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
  Listener& listener_;
  std::uint8_t status_ = 0;
  bool command_error_ = false;  ///< seen in the status register, not yet reported
  std::array<AxisData, max_axes> data_{};
  bool seen_ = false;  ///< data_ was read since the connection
  InTurn whole_;       ///< the axis that is read whole
  Duration first_look_ = copy_time;
};

}  // namespace hw::vme58
