// The pace of a motion is one that the controller has, or the motion is refused: a number that means "its own
// speed" to the controller may be much faster than what was asked for.
#include "tests/contract/rig.h"

namespace hw {
namespace {

using testing::HasSubstr;

class PaceContract : public ContractTest {
 protected:
  /// Moves, a jog and a jog to a place at this pace.
  std::vector<IntentBody> motions(const intent::Pace& pace) const {
    const std::vector<AxisTarget> target{{AxisId{0}, Steps(400)}};
    intent::MoveTo to(target, pace.speed);
    intent::MoveBy by(target, pace.speed);
    intent::JogStart jog(AxisId{0}, Sign::plus, pace.speed, false);
    to.acceleration = by.acceleration = jog.acceleration = pace.acceleration;
    intent::JogStart up_to = jog;
    up_to.up_to = Steps(400);
    return {to, by, jog, up_to};
  }
  void expect_refused(const intent::Pace& pace, std::string_view why) {
    for (const IntentBody& body : motions(pace)) {
      const IntentOutcome outcome = perform(IntentBody(body));
      EXPECT_EQ(outcome.state, IntentState::refused) << body.index();
      EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr(std::string(why))) << body.index();
    }
    run(Millis(500));
    EXPECT_FALSE(now().any_axis_moving());
    EXPECT_EQ(now().axes[0].commanded(), Steps(0));
  }
};

INSTANTIATE_TEST_SUITE_P(Every, PaceContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(PaceContract, ASpeedThatRoundsToNoneIsRefused) {
  expect_refused({Pps(0.4)}, "A speed of 0.4 is not possible. The range is ");
}

TEST_P(PaceContract, ASpeedBelowZeroIsRefused) {
  expect_refused({Pps(-400)}, "A speed of -400 is not possible. The range is ");
}

TEST_P(PaceContract, ASpeedThatIsTooHighIsRefused) {
  const double above = session->catalog().jog_speed_max.value + 1;
  expect_refused({Pps(above)}, "is not possible. The range is ");
}

TEST_P(PaceContract, AnAccelerationThatTheControllerDoesNotHaveIsRefused) {
  const AccelerationUnit& unit = find_device_type(session->catalog().model)->acceleration;
  expect_refused({Pps(), unit.maximum + 1},
                 unit.maximum == 0 ? "one ramp for all motions" : "is not possible. The range is ");
}

}  // namespace
}  // namespace hw
