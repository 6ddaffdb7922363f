// A saved place, or a script, may name an axis of another controller: a profile goes by the port.
#include "tests/contract/rig.h"

namespace hw {
namespace {

using testing::HasSubstr;

class AbsentAxisContract : public ContractTest {};

INSTANTIATE_TEST_SUITE_P(Every, AbsentAxisContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(AbsentAxisContract, IsRefusedWithASentenceAndNothingIsSent) {
  const std::size_t axes = session->catalog().axes.size();
  if (axes == max_axes) GTEST_SKIP() << "it has every axis that there can be";
  for (std::size_t i = axes; i < max_axes; ++i) {
    const AxisId absent{static_cast<std::uint8_t>(i)};
    const AxisTarget target{absent, Steps(400)}, present{AxisId{0}, Steps(400)};
    for (const IntentBody& body :
         {IntentBody(intent::MoveTo({target})), IntentBody(intent::MoveBy({target})),
          IntentBody(intent::MoveTo({present, target})), IntentBody(intent::MoveTo({target}, Pps(500))),
          IntentBody(intent::JogStart(absent, Sign::plus, Pps(400), false)),
          IntentBody(intent::Home(absent, Sign::minus)), IntentBody(intent::Stop(static_cast<int>(i))),
          IntentBody(intent::SetTravel(absent, Travel())),
          IntentBody(intent::SetBacklash(absent, Backlash())), IntentBody(intent::TrustPosition(absent))}) {
      const IntentOutcome outcome = perform(IntentBody(body));
      EXPECT_EQ(outcome.state, IntentState::refused) << body.index() << " of axis " << i;
      EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("There is no")) << body.index();
    }
  }
  run(Millis(500));
  EXPECT_FALSE(now().any_axis_moving());
  EXPECT_EQ(now().axes[0].commanded(), Steps(0)) << "of several, none has moved";
}

}  // namespace
}  // namespace hw
