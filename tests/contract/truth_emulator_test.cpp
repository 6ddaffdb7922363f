// The emulated machine itself: what it does does not depend on how often it is looked at.
#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

/// All that can be seen of a machine from outside, as text that can be compared.
std::string look_of(Emulator& machine) {
  BenchView view;
  machine.look(view);
  std::string all;
  machine.take_output(all);
  all += fmt::format("\nmemory {} of version {}, rate {}, next {}", machine.save_memory(),
                     machine.memory_version(), machine.rate(),
                     machine.next_event() ? machine.next_event()->time_since_epoch().count() : -1);
  for (const Steps at : view.load_position) all += fmt::format(" at {}", at.value);
  all += fmt::format("\nlamps {} outputs {} limits {} {} homes {}", view.lamps, view.outputs,
                     view.limits_minus, view.limits_plus, view.homes);
  for (const TriggerPulse& pulse : machine.pulses())
    all += fmt::format("\npulse on {} at {}", pulse.output, pulse.at.time_since_epoch().count());
  if (BusTarget* bus = machine.bus())
    for (std::uint16_t offset = 0; offset < bus_window_bytes; offset += 2)
      all += fmt::format(" {:x}", bus->read16(offset));
  return all;
}

class StrideTest : public TruthTest {
 protected:
  /// Compared now and then on the way, with one machine that was taken there in one stride.
  std::optional<std::string> first_difference(Duration stride) {
    const auto start = session->bench()->emulator().clone();
    const auto often = start->clone();
    Instant t = time.now();
    for (int part = 1; part <= 40; ++part) {
      const Instant end = time.now() + part * Millis(211);
      for (t += stride; t < end; t += stride) often->advance_to(t);
      often->advance_to(t = end);
      const auto once = start->clone(), seen = often->clone();  // looking may change what is looked at
      once->advance_to(end);
      if (const std::string a = look_of(*once), b = look_of(*seen); a != b)
        return fmt::format("after {} ms\n{}\n{}", part * 211, a, b);
    }
    return std::nullopt;
  }
};
INSTANTIATE_TEST_SUITE_P(Every, StrideTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(StrideTest, TwoMillisecondsShow) {
  session->send(intent::MoveBy({{id(0), Steps(3000)}}, Pps(1500)));
  run(Millis(500));
  const auto now_it_is = session->bench()->emulator().clone(), later = now_it_is->clone();
  later->advance_to(time.now() + Millis(2));
  EXPECT_NE(look_of(*now_it_is), look_of(*later)) << "else the tests below would see nothing";
}

TEST_P(StrideTest, OneStrideOfMovesEqualsMany) {
  for (int i = 0; i < axes(); ++i) session->send(intent::MoveBy({{id(i), Steps(1500 + 700 * i)}}, Pps(1500)));
  run(Millis(150));
  EXPECT_EQ(first_difference(std::chrono::microseconds(700)).value_or(""), "");
  EXPECT_EQ(first_difference(Millis(37)).value_or(""), "");
}

TEST_P(StrideTest, OneStrideIntoALimitEqualsMany) {
  place(0, Steps(-900), Steps(900));
  session->send(intent::JogStart(id(0), Sign::minus, Pps(1500), false));
  run(Millis(100));
  EXPECT_EQ(first_difference(std::chrono::microseconds(700)).value_or(""), "");
  EXPECT_EQ(first_difference(Millis(37)).value_or(""), "");
}

TEST_P(StrideTest, OneStrideOfAProgramEqualsMany) {
  if (session->catalog().program.slots == 0) GTEST_SKIP() << "it has no programs";
  must(intent::LoadProgram(0, session->catalog().program.example));
  must(intent::RunProgram(0));
  run(Millis(100));
  EXPECT_EQ(first_difference(std::chrono::microseconds(700)).value_or(""), "");
  EXPECT_EQ(first_difference(Millis(37)).value_or(""), "");
}

}  // namespace
}  // namespace hw
