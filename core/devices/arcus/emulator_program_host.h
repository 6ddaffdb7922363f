#pragma once
// The controller as its stored programs see it; carries out their statements.
#include <string>

#include "core/devices/arcus/emulator_controller.h"
#include "core/devices/arcus/language/vm_host.h"

namespace hw::arcus {

class ProgramHost final : public language::VmHost {
 public:
  explicit ProgramHost(Controller& controller) : seen_(controller), controller_(&controller) {}
  /// For reading only.
  explicit ProgramHost(const Controller& controller) : seen_(controller) {}

  [[nodiscard]] std::int32_t read(language::Quantity quantity, int index) const override;
  language::Outcome write(language::Quantity quantity, int index, std::int32_t value) override;
  language::Outcome move(const language::Move& move) override;
  language::Outcome arc(const language::Arc& arc) override;
  language::Outcome home(int axis, language::HomeMode mode, Sign direction) override;
  language::Outcome jog(int axis, Sign direction) override;
  void stop(language::AxisSet axes) override;
  void abort(language::AxisSet axes) override;
  void set_absolute(bool absolute) override { controller_->set_incremental(!absolute); }
  [[nodiscard]] bool moving(int axis) const override { return axis < seen_.axes() && seen_.moving(axis); }
  [[nodiscard]] bool in_error(int axis) const override;
  [[nodiscard]] language::AxisSet moved_with(int axis) const override;
  void clear_error(int axis) override { controller_->clear_errors(axis); }
  void arm_sync(int axis, bool on) override;
  void store() override { controller_->store(); }
  [[nodiscard]] bool error_returns_to_start() const override { return seen_.error_returns_to_start(); }

 private:
  /// Records the read of an input in the rehearsal's trace.
  [[nodiscard]] std::int32_t noted(const std::string& input, std::int32_t value) const;

  const Controller& seen_;
  Controller* controller_ = nullptr;
};

}  // namespace hw::arcus
