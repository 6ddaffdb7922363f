#pragma once
// What is read in the window: the registers, and the board's copy of its axis data. Reading the done and slip
// registers clears them, for everybody: they are not read here (decisions M31, M32). Reading the limit
// register clears only a hit that is over, and is remembered.
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

/// Its status register reports a command error behind `text`.
tl::unexpected<Fault> rejected_by_board(std::string_view text);

class Readings {
 public:
  /// Whoever makes something of it.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void registers_read(const Registers& registers) = 0;
    /// Three values of each axis, and all of axis `whole`.
    virtual void axes_read(int whole, Instant at) = 0;
  };
  /// When the board is told to copy its axis data: with the reading of the registers, or by itself.
  enum class Copy : std::uint8_t { is_asked_for, ask };

  Readings(Wire& wire, const Catalog& catalog, Snapshot& draft, Listener& listener)
      : wire_(wire), catalog_(catalog), draft_(draft), listener_(listener) {}

  // ---- registers
  /// With `ask_for_data` the board is told to copy the axis data, in the same burst.
  Task<Result<Registers>> read_registers(Priority priority, bool ask_for_data);
  void take(const Registers& registers);
  Task<Result<>> look_at_registers(Priority priority, bool ask_for_data = false);
  /// The status register, as last read.
  [[nodiscard]] std::uint8_t status() const { return status_; }
  /// A command error stays until the status register is read, which clears it: it is asked for here, and told
  /// to one asker.
  Task<Result<bool>> was_rejected(Priority priority);
  bool take_command_error();
  void put_back_command_error() { command_error_ = true; }
  void forget_command_error() { command_error_ = false; }

  // ---- data area
  /// Waits for the board's copy. Three values of each axis, and all of one axis in turn.
  Task<Result<>> read_axes(Priority priority, Copy copy = Copy::ask);
  Task<Result<>> read_all(Priority priority);
  /// All of this axis comes next.
  void next_is(int axis) { whole_.jump_to(axis); }
  /// How soon a copy is looked for: a recording wants each one.
  void look_after(Duration time) { first_look_ = time; }
  [[nodiscard]] std::int64_t value(int axis, AxisValue v) const;
  /// It is known before it comes to be read in turn.
  void know(int axis, AxisValue v, std::int64_t value);
  /// By its velocity, and only where that has been read since the connection.
  [[nodiscard]] bool moving(int axis) const;
  /// Before the reading that is being told of.
  [[nodiscard]] bool seen() const { return seen_; }
  /// The connection is gone, or the board was reset.
  void forget();

  /// For whoever looks into the memory: rings, indexes and mailbox.
  Task<Result<>> read_rings(Priority priority);
  static constexpr Duration copy_time = std::chrono::microseconds(1000);  ///< decision M26: about 1 ms

 private:
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  void take_values(const std::vector<BusCycle>& cycles);
  tl::unexpected<Fault> nobody_answers();

  Wire& wire_;
  const Catalog& catalog_;
  Snapshot& draft_;
  Listener& listener_;
  std::uint8_t status_ = 0;
  bool command_error_ = false;  ///< seen in the status register and not told yet
  std::array<AxisData, max_axes> data_{};
  bool seen_ = false;  ///< they have been read since the connection
  InTurn whole_;       ///< the axis that is read whole
  Duration first_look_ = copy_time;
};

}  // namespace hw::vme58
