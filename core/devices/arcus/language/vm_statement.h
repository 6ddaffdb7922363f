#pragma once
// One statement of a thread while it runs. Part of the interpreter (vm.cpp).
#include "core/devices/arcus/language/vm.h"

namespace hw::arcus::language {

/// A statement that waits for these axes would find them at rest, or in error.
[[nodiscard]] bool can_go_on(AxisSet axes, const VmHost& host);

class Vm::Statement {
 public:
  Statement(Vm& vm, Thread& thread, Turn turn, VmHost& host)
      : vm_(vm), thread_(thread), turn_(turn), host_(host) {}
  Next run();

 private:
  using Kind = Next::Kind;
  [[nodiscard]] Next go_to(int line) const { return {Kind::go, static_cast<std::uint16_t>(line), {}, {}}; }
  [[nodiscard]] Next go_on() const { return go_to(thread_.line + i_->lines); }
  [[nodiscard]] Next wait_for(AxisSet axes) const { return {Kind::wait, 0, axes, {}}; }
  [[nodiscard]] Next fail(Trouble trouble) const { return {Kind::fail, 0, {}, trouble}; }
  Next outcome(Outcome outcome, AxisSet axes);
  /// Check before a motion statement starts (AMB-113). None: nothing in its way; else what to do instead.
  [[nodiscard]] std::optional<Next> obstacle(AxisSet axes) const;

  std::int32_t value(const Operand& operand);
  void put(int variable, std::int32_t value);

  Next run_effect();
  Next end();
  Next call();
  Next return_from_sub();
  Next control();
  Next test(const Instruction& condition, int if_true);
  Next go_round();
  Next set();
  Next compute_value();
  Next wait();
  Next delay();
  Next move();
  Next arc();
  Next home(HomeMode mode);
  Next jog();

  Vm& vm_;
  Thread& thread_;
  Turn turn_;
  VmHost& host_;
  const Instruction* i_ = nullptr;
};

}  // namespace hw::arcus::language
