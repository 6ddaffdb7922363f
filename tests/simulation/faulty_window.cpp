#include "tests/simulation/faulty_window.h"

namespace hw::simulation {
namespace {

class FaultyWindow final : public Window {
 public:
  FaultyWindow(Scheduler& scheduler, std::unique_ptr<Window> inner, WireFaults& faults)
      : scheduler_(scheduler), inner_(std::move(inner)), faults_(faults) {}

  void listen(Listener* listener) override { inner_->listen(listener); }
  void abandon() override { inner_->abandon(); }
  [[nodiscard]] bool reports_interrupts() const override { return inner_->reports_interrupts(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

  Task<Result<>> run(std::span<BusCycle> cycles) override {
    if (scheduler_.now() < faults_.slow_until) co_await scheduler_.sleep_for(faults_.slow_by);
    if (faults_.cycle_faults > 0) {
      --faults_.cycle_faults;
      faults_.out.held_until(scheduler_.now());
      co_return fail(FaultKind::no_answer, "The board did not answer a bus cycle.");
    }
    if (scheduler_.now() >= faults_.silent_until) co_return co_await inner_->run(cycles);
    for (BusCycle& cycle : cycles)
      if (!cycle.write) cycle.value = 0xFFFFFFFFu >> (32 - 8 * cycle.width);
    co_return Result<>();
  }

 private:
  Scheduler& scheduler_;
  std::unique_ptr<Window> inner_;
  WireFaults& faults_;
};

}  // namespace

std::unique_ptr<Window> make_faulty_window(Scheduler& scheduler, std::unique_ptr<Window> inner,
                                           WireFaults& faults) {
  return std::make_unique<FaultyWindow>(scheduler, std::move(inner), faults);
}

}  // namespace hw::simulation
