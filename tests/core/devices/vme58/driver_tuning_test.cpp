// Recordings for the tuning view: how often, and the output that the console works out, against the true
// 12-bit output of the emulated board's servo loop.
#include <cmath>

#include "core/devices/vme58/emulator_vme58.h"
#include "core/motion/servo.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using std::chrono::microseconds;
using test::Seconds;

class Vme58Tuning : public test::Vme58Rig {
 protected:
  void SetUp() override {
    Vme58Rig::SetUp();
    AxisPlace place;
    place.motor = Motor();
    operate(bench::Place(AxisId{0}, place));
    ASSERT_TRUE(query("AX VL1000000 AC2000000"));
  }
  double true_percent() {
    auto& emulator = dynamic_cast<vme58::Vme58Emulator&>(const_cast<Emulator&>(host->bench()->emulator()));
    return 100 * emulator.board().motion().axis(0).loop.volts() * motion::output_steps_per_volt /
           motion::output_limit;
  }
  struct Recording {
    std::vector<AxisSample> samples;
    std::vector<double> truth;  ///< beside each sample: when the board made its copy
  };
  Recording record(int step) {
    Recording r;
    session->samples().drain([](const AxisSample&) {});
    session->send(intent::Sample(AxisId{0}, Millis(300)));
    run(Millis(20));
    session->send(intent::MoveBy({AxisTarget{AxisId{0}, Steps(step)}}));
    std::vector<double> output;
    const Instant began = time.now();
    for (const Instant end = time.now() + Millis(400); time.now() < end; run(tick))
      output.push_back(true_percent());
    session->samples().drain([&](const AxisSample& s) {
      if (s.at - copied_before < began) return;
      r.samples.push_back(s);
      r.truth.push_back(output.at(static_cast<std::size_t>((s.at - copied_before - began) / tick)));
    });
    return r;
  }
  void expect_like_the_truth(const Recording& r) {
    ASSERT_GT(r.samples.size(), 200u);
    double largest = 0, mean = 0, peak = 0;
    for (std::size_t i = 0; i < r.samples.size(); ++i) {
      ASSERT_TRUE(r.samples[i].output_known);
      const double off = std::abs(static_cast<double>(r.samples[i].output_percent) - r.truth[i]);
      largest = std::max(largest, off);
      mean += off / static_cast<double>(r.samples.size());
      peak = std::max(peak, std::abs(r.truth[i]));
    }
    EXPECT_GT(peak, 10) << "nothing much to compare with";
    EXPECT_LT(largest, 3) << "percent of the output";
    EXPECT_LT(mean, 0.3) << "percent of the output";
  }
  static constexpr Duration tick = microseconds(50);
  static constexpr Duration copied_before = microseconds(50);  // the board copies before the console reads
};

TEST_F(Vme58Tuning, ARecordingGivesASampleForEachUpdate) {
  session->send(intent::Sample(AxisId{0}, Millis(500)));
  perform(intent::MoveBy({AxisTarget{AxisId{0}, Steps(2000)}}, Pps{8000}));
  run(Seconds(2));
  std::vector<AxisSample> samples;
  session->samples().drain([&](const AxisSample& s) { samples.push_back(s); });
  EXPECT_GT(samples.size(), 450u);
  EXPECT_LT(samples.size(), 520u) << "it ends";
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [](const AxisSample& s) { return s.moving; }));
}

TEST_F(Vme58Tuning, TheOutputIsWorkedOutAsTheLoopHasIt) {
  ASSERT_TRUE(query("AX KP2 KD6"));
  run(Seconds(2));
  expect_like_the_truth(record(400));
  expect_like_the_truth(record(-400));
}

TEST_F(Vme58Tuning, WithAllGainsToo) {
  for (const auto& [name, value] : {std::pair{"KPX", 400},
                                    {"KDX", 600},
                                    {"KIX", 400},
                                    {"KVX", 20},
                                    {"KAX", 250},
                                    {"KOX", 500},
                                    {"KNX", 0}})
    ASSERT_EQ(perform(intent::SetParam(name, value)).state, IntentState::done) << name;
  run(Seconds(2));
  expect_like_the_truth(record(1000));
}

TEST_F(Vme58Tuning, NoOutputIsShownWhileAGainIsNotKnown) {
  ASSERT_TRUE(query("AX KP2 KD6 KI4"));
  run(Seconds(2));
  ASSERT_TRUE(now().params[static_cast<std::size_t>(session->catalog().find_param("KIX"))].known);
  const Recording r = record(400);
  ASSERT_FALSE(r.samples.empty());
  for (const AxisSample& s : r.samples) ASSERT_FALSE(s.output_known) << "KN shows nowhere";
  ASSERT_EQ(perform(intent::SetParam("KNX", 0)).state, IntentState::done);
  EXPECT_TRUE(record(400).samples.front().output_known);
}

}  // namespace
}  // namespace hw
