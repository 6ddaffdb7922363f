#pragma once
// The interpreter's interface to a controller. The emulator implements it, and so do tests, with a controller
// of their own. All calls come from within Vm::run_turn and Vm::next_turn, on the caller's thread.
#include <array>
#include <cstdint>

#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

enum class Outcome {
  done,
  busy,   ///< not now: the thread stays at this statement and tries again (an axis still moves, AMB-113)
  error,  ///< refused, as by an error reply on the wire; the thread goes to SUB 31 (AMB-118)
};

enum class HomeMode : std::uint8_t { switch_only, limit, switch_and_index, index_only, switch_slow };

/// A move of one axis, or of several on a straight line. Targets as the program gives them: the host
/// applies ABS and INC.
struct Move {
  AxisSet axes;
  std::array<std::int32_t, max_axes> target{};  ///< by axis
};
/// An XY arc about an absolute centre (AMB-063 to 067).
struct Arc {
  bool clockwise = true;
  bool full_circle = false;  ///< CIR: the two angles are ignored
  std::int32_t centre_x = 0, centre_y = 0;
  std::int32_t end_angle = 0, swept_angle = 0;  ///< thousandths of a degree
};

class VmHost {
 public:
  virtual ~VmHost() = default;

  // Values. `index`: axis (0 = X) or the maker's number (DI1: 1); 0 without one.
  [[nodiscard]] virtual std::int32_t read(Quantity quantity, int index) const = 0;
  virtual Outcome write(Quantity quantity, int index, std::int32_t value) = 0;

  // Motion. The VM asks `in_error` and `moving` first; a host may still say `busy` (a joystick has the axis).
  virtual Outcome move(const Move& move) = 0;
  virtual Outcome arc(const Arc& arc) = 0;
  virtual Outcome home(int axis, HomeMode mode, Sign direction) = 0;
  virtual Outcome jog(int axis, Sign direction) = 0;
  virtual void stop(AxisSet axes) = 0;
  virtual void abort(AxisSet axes) = 0;
  virtual void set_absolute(bool absolute) = 0;
  /// The axis is pulsing, or its StepNLoop still corrects (AMB-114).
  [[nodiscard]] virtual bool moving(int axis) const = 0;
  /// A limit, alarm or StepNLoop error is latched (AMB-035, AMB-118; IERR clears it).
  [[nodiscard]] virtual bool in_error(int axis) const = 0;

  /// The axes of this axis's last motion that have had no other motion since.
  [[nodiscard]] virtual AxisSet moved_with(int axis) const = 0;

  // Other effects.
  virtual void clear_error(int axis) = 0;
  virtual void arm_sync(int axis, bool on) = 0;
  /// STORE: parameters and V50 to V99 (from Vm::variable) into flash.
  virtual void store() = 0;
  /// SAP (PMX), POL bit 11 (DMX): SUB 31 returns to the first line instead of the one that failed (AMB-117).
  [[nodiscard]] virtual bool error_returns_to_start() const = 0;
};

}  // namespace hw::arcus::language
