#pragma once
// A controller just good enough to run programs on: values that hold what was written, axes that move at
// their high speed without ramps, a record of what was asked of it. Time stands where the test puts it.
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/vm.h"

namespace hw::arcus::language {

class FakeController final : public VmHost {
 public:
  explicit FakeController(const Dialect& dialect) : dialect_(dialect) {}

  // What a test sees and sets
  std::map<std::pair<Quantity, int>, std::int32_t> values;
  std::vector<std::string> done;  ///< "move X1000 Y2000", "home X+ limit", "store" ...
  std::array<bool, max_axes> error{};
  bool refuses_moves = false, busy = false, returns_to_start = false;
  Instant now{};
  [[nodiscard]] std::int32_t position(int axis) const;
  void set(std::string_view name, std::int32_t value);  ///< by the maker's name
  [[nodiscard]] std::int32_t get(std::string_view name) const;
  /// When the first of the axes that move now comes to rest.
  [[nodiscard]] std::optional<Instant> next_rest() const;
  /// Time up to which nothing happens by itself.
  void settle();

  // VmHost
  [[nodiscard]] std::int32_t read(Quantity quantity, int index) const override;
  Outcome write(Quantity quantity, int index, std::int32_t value) override;
  Outcome move(const Move& move) override;
  Outcome arc(const Arc& arc) override;
  Outcome home(int axis, HomeMode mode, Sign direction) override;
  Outcome jog(int axis, Sign direction) override;
  void stop(AxisSet axes) override;
  void abort(AxisSet axes) override;
  void set_absolute(bool absolute) override;
  [[nodiscard]] bool moving(int axis) const override { return axes_[axis].moving; }
  [[nodiscard]] bool in_error(int axis) const override { return error[axis]; }
  [[nodiscard]] AxisSet moved_with(int axis) const override { return axes_[axis].with; }
  void clear_error(int axis) override;
  void arm_sync(int axis, bool on) override;
  void store() override { done.emplace_back("store"); }
  [[nodiscard]] bool error_returns_to_start() const override { return returns_to_start; }

 private:
  struct Axis {
    bool moving = false, endless = false, homing = false;
    std::int32_t from = 0, to = 0;
    Instant began{}, ends{};
    AxisSet with;
  };
  void begin(int axis, std::int32_t to);
  void together(AxisSet axes);
  void halt(AxisSet axes, const char* word);
  [[nodiscard]] std::string letter_of(int axis) const { return std::string(1, dialect_.axes[axis]); }

  const Dialect& dialect_;
  std::array<Axis, max_axes> axes_;
  bool absolute_ = true;
};

/// A controller, an interpreter and a clock: a program at work.
struct Workbench {
  explicit Workbench(const Dialect& d) : dialect(d), host(d) {}
  /// Compiles and loads; the compilation is kept. Does not start anything.
  void load(const std::string& text);
  void start(int program = 0) { vm.control(program, 1, now); }
  void run_for(Duration time);
  void run_ms(std::int64_t ms) { run_for(std::chrono::milliseconds(ms)); }
  [[nodiscard]] int source_line(int program) const;  ///< from 1

  const Dialect& dialect;
  FakeController host;
  Vm vm;
  Compilation compiled;
  Instant now{};
  std::int64_t turns = 0;
};

}  // namespace hw::arcus::language
