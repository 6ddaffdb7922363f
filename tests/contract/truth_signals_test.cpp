// Inputs, outputs, switches and encoders: what is shown is what they are.
#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

TEST_P(TruthTest, AnInputIsShownWhileItIsOperated) {
  const auto& inputs = session->catalog().inputs;
  int operated = 0;
  for (std::size_t place = 0; place < inputs.size(); ++place) {
    const int number = static_cast<int>(place) + 1;
    const std::uint32_t at_rest = now().inputs;
    if (inputs[place].of_output || !session->bench()->operate(bench::Input(number, true))) continue;
    EXPECT_TRUE(now().inputs_known >> place & 1u) << inputs[place].name;
    run(seconds(2));
    EXPECT_EQ(now().inputs ^ at_rest, 1u << place) << inputs[place].name;
    operate(bench::Input(number, false));
    run(seconds(2));
    EXPECT_EQ(now().inputs, at_rest) << inputs[place].name;
    ++operated;
  }
  EXPECT_TRUE(inputs.empty() || operated > 0);
}

TEST_P(TruthTest, AnOutputIsSwitchedOnTheMachine) {
  const Catalog& c = session->catalog();
  int tried = 0;
  for (std::size_t place = 0; place < c.outputs.size(); ++place) {
    if (!c.outputs[place].settable) continue;
    for (const std::string& duty : c.outputs[place].duty.while_not_zero)
      if (c.find_param(duty) >= 0) must(intent::SetParam(duty, 0, true));
    for (const bool on : {true, false}) {
      const IntentOutcome set = perform(intent::SetOutput(c.output_number(place), on));
      if (set.state == IntentState::refused) break;
      run(seconds(1));
      EXPECT_EQ((seen_on_bench().outputs >> place & 1u) != 0, on) << c.outputs[place].name;
      EXPECT_EQ((now().outputs >> place & 1u) != 0, on) << c.outputs[place].name;
      ++tried;
    }
  }
  EXPECT_TRUE(c.outputs.empty() || tried > 0);
}

TEST_P(TruthTest, AnAnalogInputIsReadNow) {
  const auto& inputs = session->catalog().analog;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    for (const int eighths : {2, 5}) {
      const std::int32_t value = inputs[i].minimum + (inputs[i].maximum - inputs[i].minimum) / 8 * eighths;
      const int number = static_cast<int>(i) + 1;
      operate(bench::Analog(number, value));
      perform(intent::ReadAnalog(number));  // refused where a round of status reads it anyway
      run(seconds(2));
      EXPECT_NEAR(now().analog[i], value, (inputs[i].maximum - inputs[i].minimum) / 100) << inputs[i].name;
    }
}

TEST_P(TruthTest, AHomeSwitchIsShownWhileItIsOperated) {
  for (int i = 0; i < axes(); ++i) {
    if (!session->catalog().axes[static_cast<std::size_t>(i)].home_input) continue;
    for (const bool on : {true, false}) {
      operate(bench::HomeSwitch(id(i), on));
      run(seconds(2));
      for (int k = 0; k < axes(); ++k) EXPECT_EQ(axis_at(k).home, on && k == i) << k << " of " << i;
    }
  }
}

TEST_P(TruthTest, AnEncoderFollowsTheLoadAndNotTheCount) {
  const Catalog& c = session->catalog();
  if (c.find_param("SL") >= 0) must(intent::SetParam("SL", 0, true));  // else the encoder is what counts
  for (int i = 0; i < axes(); ++i) {
    const AxisInfo& info = c.axes[static_cast<std::size_t>(i)];
    if (!info.encoder || info.servo) continue;
    run(seconds(1));
    const Steps counted = axis_at(i).position, encoder = axis_at(i).encoder;
    operate(bench::Slip(id(i), Steps(250)));
    run(seconds(1));
    EXPECT_EQ(axis_at(i).position, counted) << info.name;
    EXPECT_EQ(axis_at(i).encoder, encoder + Steps(250)) << info.name;
  }
}

}  // namespace
}  // namespace hw
