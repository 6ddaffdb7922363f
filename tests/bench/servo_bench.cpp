// Eight servo axes of a VME58, each with a motor and a loop that is updated every millisecond, against real
// time; and the same moves on ideal plants, which need no updates.
#include <benchmark/benchmark.h>

#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {
namespace {

Motion eight_axes(bool with_motors) {
  Motion motion(*find_variant("8S"));
  for (int a = 0; a < most_axes; ++a) {
    AxisPlace place;
    place.motor = Motor();
    place.motor->present = with_motors;
    (void)motion.place(a, place);
    AxisSettings& s = motion.settings(a);
    s.velocity = 50'000, s.acceleration = 500'000;
    s.gains.proportional = 4, s.gains.differential = 6, s.gains.integral = 1;
    motion.changed(a);
  }
  return motion;
}

void moves(benchmark::State& state, bool with_motors) {
  Motion motion = eight_axes(with_motors);
  std::vector<MotionEvent> reported;
  Instant end{};
  std::int64_t updates = 0, goal = 20'000;
  for (auto _ : state) {
    end += std::chrono::seconds(1);
    // 0.5 s of way for each axis by itself, then a rest.
    for (int a = 0; a < most_axes; ++a) {
      Move move;
      move.goal[ix(a)] = AxisGoal{goal, false};
      motion.start(move);
    }
    goal = -goal;
    for (auto next = motion.next_event(); next && *next <= end; next = motion.next_event()) {
      motion.advance_to(*next);
      ++updates;
    }
    motion.advance_to(end);
    motion.take_events(reported);
    reported.clear();
  }
  const auto simulated = static_cast<double>(state.iterations());
  state.counters["times_real"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  state.counters["updates_per_s"] = static_cast<double>(updates) / simulated;
}

void second_of_eight_servo_loops(benchmark::State& state) { moves(state, true); }
BENCHMARK(second_of_eight_servo_loops)->Unit(benchmark::kMicrosecond);

void second_of_eight_ideal_axes(benchmark::State& state) { moves(state, false); }
BENCHMARK(second_of_eight_ideal_axes)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hw::vme58
