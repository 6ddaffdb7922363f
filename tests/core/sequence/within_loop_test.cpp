// The rest of a sequence from a pass of a loop.
#include "core/sequence/within_loop.h"

#include <gmock/gmock.h>

namespace hw::sequence {
namespace {

using ::testing::HasSubstr;

Move moved(std::size_t axis, double way) {
  Move m;
  m.relative = true;
  m.to[axis] = way;
  return m;
}
Sequence sequence_of(StepList steps) {
  Sequence s;
  s.unit = "mm";
  s.axes = {{"X", 100}, {"Y", 100}};
  s.steps = std::move(steps);
  return s;
}
Step at_zero() {
  Move m;
  m.to[0] = m.to[1] = 0;
  return {m};
}
/// Counted: 0 the move, 1 the loop, 2 and 3 in it, 4 behind it.
Sequence stairs() {
  return sequence_of({at_zero(), {Repeat{3, {{moved(0, 10)}, {moved(1, 5)}}}}, at_zero()});
}

StepList behind(const Rest& rest) {
  return {rest.sequence.steps.begin() + static_cast<std::ptrdiff_t>(rest.leading), rest.sequence.steps.end()};
}

TEST(WithinLoop, TheRestOfThePassIsWrittenOutAndTheOthersStayALoop) {
  ASSERT_TRUE(loops_around(stairs(), 3));
  EXPECT_EQ(loops_around(stairs(), 3)->loop, 1u);
  EXPECT_EQ(loops_around(stairs(), 3)->times, 3);
  const auto rest = rest_within(stairs(), 3, 1);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->rest.start[0], 20);
  EXPECT_EQ(rest->rest.start[1], 5);
  EXPECT_EQ(behind(rest->rest),
            (StepList{{moved(1, 5)}, {Repeat{1, {{moved(0, 10)}, {moved(1, 5)}}}}, at_zero()}));
  EXPECT_THAT(rest->begins, HasSubstr("pass 2 of 3 of the loop of step 2, Move by"));
  EXPECT_EQ(std::get<Comment>(rest->rest.sequence.steps[0].body).text, "From pass 2 of 3 of step 2 on.");
}

TEST(WithinLoop, TheLastPassHasNoLoopBehindIt) {
  const auto rest = rest_within(stairs(), 2, 2);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->rest.start[0], 20);
  EXPECT_EQ(behind(rest->rest), (StepList{{moved(0, 10)}, {moved(1, 5)}, at_zero()}));
}

TEST(WithinLoop, LoopsInLoopsAreOpenedEachAtItsPass) {
  // Counted: 0 move, 1 outer, 2 in it, 3 inner, 4 in that.
  const Sequence s = sequence_of({at_zero(), {Repeat{2, {{moved(1, 1)}, {Repeat{3, {{moved(0, 10)}}}}}}}});
  EXPECT_EQ(loops_around(s, 4)->times, 6);
  const auto rest = rest_within(s, 4, 4);  // the second of the second
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->rest.start[0], 40);
  EXPECT_EQ(rest->rest.start[1], 2);
  EXPECT_EQ(behind(rest->rest), (StepList{{moved(0, 10)}, {Repeat{1, {{moved(0, 10)}}}}}));
}

TEST(WithinLoop, OneWithoutEndGoesOnWithoutEnd) {
  const StepList round{{moved(0, 10)}, {moved(1, 5)}};
  const Sequence s = sequence_of({at_zero(), {Repeat{0, round}}});
  EXPECT_FALSE(loops_around(s, 2)->times);
  const auto rest = rest_within(s, 3, 7);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->rest.start[0], 80);
  EXPECT_EQ(behind(rest->rest), (StepList{{moved(1, 5)}, {Repeat{0, round}}}));
}

TEST(WithinLoop, StepsOutsideLoopsAndMissingPassesAreRefused) {
  EXPECT_FALSE(loops_around(stairs(), 0));
  EXPECT_FALSE(loops_around(stairs(), 1)) << "the loop itself";
  EXPECT_FALSE(loops_around(stairs(), 4));
  EXPECT_FALSE(rest_within(stairs(), 2, 3));
  EXPECT_FALSE(rest_within(stairs(), 2, -1));
}

}  // namespace
}  // namespace hw::sequence
