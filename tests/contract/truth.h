#pragma once
// What a controller's driver says was done is compared with what the emulated machine did.
#include <algorithm>

#include <fmt/format.h>

#include "core/emulation/emulator.h"
#include "tests/contract/rig.h"

namespace hw {

class TruthTest : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::SetUp();
    const auto& infos = session->catalog().axes;
    if (std::any_of(infos.begin(), infos.end(), [](const AxisInfo& a) { return a.switchable; })) {
      must(intent::SetPower(-1, true));
      run(std::chrono::seconds(1));
    }
  }
  void reopen() {
    TearDown();
    session.reset();
    SetUp();
  }
  static AxisId id(int i) { return AxisId{static_cast<std::uint8_t>(i)}; }
  [[nodiscard]] int axes() const { return now().axis_count; }
  [[nodiscard]] const AxisState& axis_at(int i) const { return now().axes[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Steps load_of(int i) const {
    return seen_on_bench().load_position[static_cast<std::size_t>(i)];
  }
  void must(IntentBody body) {
    const IntentOutcome outcome = perform(std::move(body), std::chrono::seconds(60));
    ASSERT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
  }
  /// All parameters are read from the controller.
  void read_params() { must(intent::ReadParams()); }
  [[nodiscard]] std::int64_t param(std::string_view mnemonic) const {
    return now().params[static_cast<std::size_t>(session->catalog().find_param(mnemonic))].value;
  }
  [[nodiscard]] BenchView seen_on_bench() const {
    BenchView view;
    session->bench()->look(view);
    return view;
  }
  void place(int i, Steps minus, Steps plus) {
    AxisPlace travel;
    travel.minus = minus;
    travel.plus = plus;
    operate(bench::Place(id(i), travel));
  }
};

}  // namespace hw
