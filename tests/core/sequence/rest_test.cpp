// From a step on: what leads there, and what nobody can know.
#include "core/sequence/rest.h"

#include <gmock/gmock.h>

namespace hw::sequence {
namespace {

using ::testing::HasSubstr;

Move to(std::optional<double> x, std::optional<double> y, std::optional<double> z = {}) {
  Move m;
  m.to[0] = x, m.to[1] = y, m.to[2] = z;
  return m;
}
Move by(double x) {
  Move m = to(x, {});
  m.relative = true;
  return m;
}
Sequence of(StepList steps) {
  Sequence s;
  s.unit = "mm";
  s.axes = {{"X", 100}, {"Y", 100}, {"Z", 100}};
  s.steps = std::move(steps);
  return s;
}
/// A pen that an output lowers, and two squares.
Sequence drawn() {
  Sequence s = of({{Speed{{20, 1, 100}}},
                   {Pen{false}},
                   {to(10, 10)},
                   {Pen{true}},
                   {to(20, {})},
                   {to({}, 20)},
                   {Pen{false}},
                   {to(0, 0)}});
  s.pen_up = {{Output{3, false}}};
  s.pen_down = {{Output{3, true}}, {Delay{200}}};
  return s;
}
template <class Body>
const Body* leading(const Rest& rest, int nth = 0) {
  for (std::size_t i = 0; i < rest.leading; ++i)
    if (const auto* body = std::get_if<Body>(&rest.sequence.steps[i].body); body && nth-- == 0) return body;
  return nullptr;
}

TEST(Rest, ComesToItsBeginningWithTheToolUpAndLowersItThere) {
  const auto rest = rest_from(drawn(), 5);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(words_of_leading(*rest),
            "Tool up. Speed 20 from 1 mm/s, 100 ms. Move to X 20, Y 10 mm. Tool down.");
  EXPECT_EQ(rest->start[0], 20);
  EXPECT_EQ(rest->start[1], 10);
  const StepList& steps = rest->sequence.steps;
  ASSERT_EQ(steps.size(), rest->leading + 3);
  EXPECT_EQ(steps[rest->leading], drawn().steps[5]);
  EXPECT_EQ(steps.back(), drawn().steps.back());
  EXPECT_EQ(rest->sequence.pen_down, drawn().pen_down);
}

TEST(Rest, DoesNotLowerAToolThatIsUpThere) {
  const auto rest = rest_from(drawn(), 7);
  ASSERT_TRUE(rest);
  EXPECT_EQ(words_of_leading(*rest), "Tool up. Speed 20 from 1 mm/s, 100 ms. Move to X 20, Y 20 mm.");
}

TEST(Rest, FollowsDistancesArcsAndRounds) {
  Sequence s = of({{to(10, 0)}, {Repeat{3, {{by(5)}}}}, {Arc{0, 0, 90, {}}}, {to(0, 0)}});
  const auto rest = rest_from(s, 3);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_NEAR(*rest->start[0], 0, 1e-9);
  EXPECT_NEAR(*rest->start[1], 25, 1e-9);
  EXPECT_FALSE(rest->start[2]) << "nothing has moved it";
  EXPECT_FALSE(leading<Move>(*rest)->to[2]);
}

TEST(Rest, WhereNoToolIsSpokenOfOutputsAreOffOnTheWay) {
  Sequence s = of({{Output{2, true}}, {to(10, 0)}, {to(20, 0)}, {Output{2, false}}});
  const auto rest = rest_from(s, 2);
  ASSERT_TRUE(rest);
  EXPECT_EQ(words_of_leading(*rest), "Output 2 off. Move to X 10, Y 0 mm. Output 2 on.");
  EXPECT_EQ(*leading<Output>(*rest, 1), (Output{2, true}));
}

TEST(Rest, TheToolsOutputsAreOffOnTheWayThere) {
  // Its routine to lift it has been forgotten, and a step switches it by itself.
  Sequence s = drawn();
  s.pen_up.clear();
  EXPECT_EQ(words_of_leading(*rest_from(s, 5)),
            "Output 3 off. Tool up. Speed 20 from 1 mm/s, 100 ms. Move to X 20, Y 10 mm. Tool down.");
  s = drawn();
  s.steps[3] = {Output{3, true}};
  s.steps.insert(s.steps.begin(), {Output{4, true}});
  EXPECT_EQ(words_of_leading(*rest_from(s, 6)),
            "Tool up. Speed 20 from 1 mm/s, 100 ms. Move to X 20, Y 10 mm. Output 4 on. Output 3 on.")
      << "output 4 may hold the workpiece";
}

TEST(Rest, ALaserThatStepsSwitchIsOffOnTheWayAlsoWhereTheToolIsAnAxis) {
  Sequence s = of({{Pen{false}}, {to(10, 0)}, {Pen{true}}, {Output{2, true}}, {to(20, 0)}, {to(30, 0)}});
  s.pen_up = {{to({}, {}, 5)}};
  s.pen_down = {{to({}, {}, 0)}};
  EXPECT_EQ(words_of_leading(*rest_from(s, 5)),
            "Output 2 off. Tool up. Move to X 20, Y 0 mm. Tool down. Output 2 on.")
      << "it burns at the height at which it did";
  s.steps[3] = {Output{-1, false, 6}};
  s.steps.insert(s.steps.begin() + 4, {Output{1, false}});
  EXPECT_EQ(words_of_leading(*rest_from(s, 6)),
            "Output all: 0. Tool up. Move to X 20, Y 0 mm. Tool down. Output all: 6. Output 1 off.");
}

TEST(Rest, OutputsComeOnBeforeTheToolIsLoweredOrBehindItAsTheyDid) {
  Sequence s = of({{Output{1, true}},
                   {Pen{false}},
                   {to(10, 0)},
                   {Pen{true}},
                   {Output{2, true}},
                   {to({}, {}, -3)},
                   {to(20, 0)},
                   {to(30, 0)}});
  s.pen_up = {{to({}, {}, 5)}};
  s.pen_down = {{to({}, {}, 0)}};
  EXPECT_EQ(words_of_leading(*rest_from(s, 7)),
            "Output 1 off. Output 2 off. Tool up. Move to X 20, Y 0 mm. Output 1 on. Tool down. Move to Z "
            "\u22123 mm. Output 2 on.")
      << "the spindle turns before it is lowered, the laser burns behind that";
  s.steps.insert(s.steps.begin() + 6, {{Pen{false}}, {Pen{true}}});
  EXPECT_EQ(words_of_leading(*rest_from(s, 9)),
            "Output 1 off. Output 2 off. Tool up. Move to X 20, Y 0 mm. Output 1 on. Output 2 on. Tool down.")
      << "both were on when it came down last";
}

TEST(Rest, MotorsHavePowerBeforeTheToolIsLiftedAndLoseItBehindTheWay) {
  Sequence s = of({{Enable{2, true}}, {Pen{false}}, {to(10, 0)}, {Enable{0, false}}, {to({}, 5)}});
  s.pen_up = {{to({}, {}, 5)}};
  EXPECT_EQ(words_of_leading(*rest_from(s, 4)),
            "Motor power X on. Motor power Z on. Tool up. Move to X 10, Y 0 mm. Motor power X off.");
  s = of({{to(10, 0)}, {Enable{2, false}}, {to({}, 5)}});
  EXPECT_EQ(words_of_leading(*rest_from(s, 2)), "Move to X 10, Y 0 mm. Motor power Z off.")
      << "nothing moves it";
}

TEST(Rest, AxesComeToWhereTheSequenceIsBegunTooWhatTheToolMovesExcepted) {
  Sequence s = of({{to(5, {})}, {by(5)}, {to({}, 7)}});
  EXPECT_EQ(words_of_leading(*rest_from(s, 1, {1.0, 2.0})), "Move to X 5, Y 2 mm.");
  EXPECT_EQ(words_of_leading(*rest_from(of({{by(5)}, {to(1, 1)}}), 1, {3.0})), "Move to X 8 mm.")
      << "a distance counts from there";
  s.steps.push_back({Pen{true}});
  s.pen_up = {{to({}, {}, 5)}};
  EXPECT_EQ(words_of_leading(*rest_from(s, 1, {1.0, 2.0, 0.0})), "Tool up. Move to X 5, Y 2 mm.");
}

TEST(Rest, BehindAContourThatEndsRampedItIsKnownWhereARehearsalShowsItAndNothingElseIsLeftOpen) {
  Contour c;
  c.steps = {{to(10, 0)}};
  const Sequence s = of({{Speed{{10, 0, 500}}}, {c}, {to({}, 0)}, {to(0, 0)}});
  const auto from = rest_from(s, 2, {}, Rehearsed::yes);
  ASSERT_TRUE(from) << from.error().sentence();
  EXPECT_NEAR(*from->start[0], 12.5, 1e-9);
  EXPECT_FALSE(rest_from(of({{c}, {to(0, 0)}}), 1, {}, Rehearsed::yes)) << "nobody has said how it ramps";
  const auto unseen = rest_from(s, 3);
  ASSERT_FALSE(unseen);
  EXPECT_THAT(unseen.error().sentence(),
              HasSubstr("position of X before step 4 is unknown: the machine decides where step 2 (Contour"));
  EXPECT_TRUE(rest_from(of({{c}, {to(0, 0)}, {to(5, 5)}}), 2)) << "it was sent to a place since";
}

TEST(Rest, AnAxisOfTheToolIsLiftedBeforeTheWayAndComesDownBehindIt) {
  Sequence s = of({{Pen{false}}, {to(10, 10)}, {Pen{true}}, {to({}, {}, -3)}, {to(30, 10)}});
  s.pen_up = {{to({}, {}, 5)}};
  s.pen_down = {{to({}, {}, -1)}};
  const auto rest = rest_from(s, 4);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(words_of_leading(*rest), "Tool up. Move to X 10, Y 10 mm. Tool down. Move to Z \u22123 mm.");
  s.pen_up = {{by(5)}};
  EXPECT_THAT(rest_from(s, 4).error().sentence(), HasSubstr("lifted by a distance"));
}

TEST(Rest, RefusesAnUnknownState) {
  const auto why = [](Sequence s, std::size_t step) {
    const auto rest = rest_from(s, step);
    return rest ? "" : rest.error().sentence();
  };
  EXPECT_THAT(why(of({{by(5)}, {to(1, 1)}}), 1), HasSubstr("step 1 (Move by X 5)"));
  EXPECT_THAT(why(of({{Home{1}}, {to(1, {})}}), 1), HasSubstr("position of Y before step 2 is unknown"));
  EXPECT_EQ(why(of({{Home{1}}, {to(1, 1)}, {to(2, 2)}}), 2), "") << "it was sent to a place since";
  EXPECT_THAT(why(of({{Repeat{0, {{by(5)}}}}, {to(1, 1)}}), 1), HasSubstr("never reached"));
  EXPECT_THAT(why(of({{to(1, 1)}, {Custom{"", "X5"}}, {to(1, {})}}), 2), HasSubstr("step 2 (Own text X5)"));
}

TEST(Rest, ReportsThatHomingIsLeftOut) {
  const Sequence s = of({{Home{0}}, {to(1, 1)}, {to(2, 2)}});
  EXPECT_TRUE(rest_from(s, 2)->leaves_homing_out);
  EXPECT_FALSE(rest_from(s, 0)->leaves_homing_out);
  MoveOnInput perhaps;
  perhaps.kind = MoveOnInput::Kind::home;
  EXPECT_TRUE(rest_from(of({{perhaps}, {to(1, 1)}, {to(2, 2)}}), 2)->leaves_homing_out);
}

TEST(Rest, ALongLoopThatSendsToPlacesIsFollowedAndOneByDistancesIsNot) {
  const Sequence places = of({{Repeat{1'000'000, {{to(3, 0)}, {to(4, 0)}}}}, {to(9, 9)}});
  ASSERT_TRUE(rest_from(places, 1));
  EXPECT_EQ(rest_from(places, 1)->start[0], 4);
  const Sequence distances = of({{to(0, 0)}, {Repeat{1'000'000, {{by(3)}}}}, {to(9, 9)}});
  EXPECT_FALSE(rest_from(distances, 2));
}

TEST(Rest, BeginsAtAStepOfTheListAndNeverWithinALoop) {
  Contour c;
  c.steps = {{to(1, 0)}, {to(2, 0)}};
  const Sequence s = of({{to(0, 0)}, {Repeat{2, {{by(1)}, {by(2)}}}}, {c}, {to(5, 5)}});
  EXPECT_EQ(*step_to_begin_at(s, 0), 0u);
  EXPECT_THAT(step_to_begin_at(s, 3).error().sentence(), HasSubstr("within the loop of step 2"));
  EXPECT_EQ(*step_to_begin_at(s, 1), 1u);
  EXPECT_EQ(*step_to_begin_at(s, 6), 2u) << "a contour goes in one";
  EXPECT_EQ(*step_to_begin_at(s, 7), 3u);
  EXPECT_FALSE(step_to_begin_at(s, 8));
  EXPECT_FALSE(step_to_begin_at(s, -1));
}

}  // namespace
}  // namespace hw::sequence
