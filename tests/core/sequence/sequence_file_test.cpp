// A sequence as a file: what is written reads back as the same, and what is wrong is told with its line.
#include "core/sequence/sequence_file.h"

#include <gmock/gmock.h>

namespace hw::sequence {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view beginning = R"(handwheel_sequence = 1
unit = "mm"
axes = [ { name = "X", per_unit = 400 }, { name = "Y", per_unit = 200.5 } ]
)";

std::string with_steps(std::string_view steps) {
  return std::string(beginning) + "steps = [\n" + std::string(steps) + "\n]\n";
}

Sequence one_of_each() {
  Sequence s;
  s.unit = "mm";
  s.axes = {{"X", 400}, {"2", 12.5}};
  s.pen_up = {{Output{2, false}}, {Delay{150}}};
  s.pen_down = {{Output{2, true}}};
  const Speeds own{120.25, 1, 300};
  Repeat loop;
  loop.times = 5;
  loop.steps = {{Pen{true}}, {Move{{1.5, -2}, true, own}, true}, {Pen{false}}};
  s.steps = {
      {Speed{own}},
      {Move{{std::nullopt, 1e-7}, false, {}}},
      {Arc{1, 2, -90.125, Speeds{}}},
      {Jog{1, Sign::minus, own}},
      {Home{0, Sign::minus, {}}},
      {Stop{}},
      {Stop{1, true}},
      {WaitMotion{}},
      {WaitMotion{0}},
      {Delay{0.5}},
      {WaitInput{3, false}},
      {MoveOnInput{2, true, MoveOnInput::Kind::home, 1, 0, Sign::minus, true, own}},
      {Output{1, true}},
      {Output{-1, true, 0xA5}},
      {Enable{1, false}},
      {Comment{"a \"quoted\" \\ remark\nof two lines"}},
      {loop},
      {Contour{1.5, -2, 0.25, false, Speeds{20}, {{Move{{3, 4}}}, {Output{1, true}}, {Arc{5, 4, 180}}}}},
      {SpeedStairs{1, {{1000, 250.5}, {1500, 20}}, 1600.25}},
      {Custom{"own text", "X1000\nWAITX"}, true}};
  return s;
}

TEST(SequenceFile, AnArcNamesItsAxesOnlyIfTheyAreNotTheFirstTwo) {
  Sequence s;
  s.axes = {{"X"}, {"Y"}, {"Z"}};
  s.steps = {{Arc{1, 2, 90}}, {Arc{1, 2, 90, {}, {0, 2}}}, {Contour{0, 0, 0, true, {}, {}, {2, 1}}}};
  const std::string text = write_sequence(s);
  EXPECT_THAT(text, HasSubstr("{ do = \"arc\", x = 1, y = 2, degrees = 90 }"));
  EXPECT_THAT(text, HasSubstr("{ do = \"arc\", x = 1, y = 2, degrees = 90, axes = [\"X\", \"Z\"] }"));
  EXPECT_THAT(text, HasSubstr("axes = [\"Z\", \"Y\"], steps"));
  const auto read = read_sequence(text, "a.toml");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_TRUE(*read == s) << text;
}

TEST(SequenceFile, EveryKindOfStepReadsBackAsTheSame) {
  Sequence written = one_of_each();
  written.tolerance = 0.02;
  const std::string text = write_sequence(written);
  const auto read = read_sequence(text, "a.toml");
  ASSERT_TRUE(read) << read.error().sentence() << "\n" << text;
  EXPECT_TRUE(*read == written) << text << "\n" << write_sequence(*read);
  EXPECT_TRUE(looks_like_sequence(text));
}

TEST(SequenceFile, IsWrittenByHandInAFewWords) {
  const auto read = read_sequence(with_steps(R"(  { do = "move", to = { Y = 2 } },
  { do = "loop", times = 3, steps = [
    { do = "jog", axis = "X" },
    { do = "delay", ms = 20 },
  ] },)"),
                                  "a.toml");
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_EQ(read->steps.size(), 2u);
  EXPECT_EQ(std::get<Move>(read->steps[0].body).to[1], 2.0);
  EXPECT_FALSE(std::get<Move>(read->steps[0].body).to[0]);
  const Repeat& loop = std::get<Repeat>(read->steps[1].body);
  EXPECT_EQ(loop.times, 3);
  EXPECT_EQ(std::get<Jog>(loop.steps[0].body).direction, Sign::plus);
}

struct Wrong {
  const char* name;
  std::string text;
  const char* sentence;
};
std::ostream& operator<<(std::ostream& out, const Wrong& w) { return out << w.name; }
class SequenceFileWrong : public testing::TestWithParam<Wrong> {};

TEST_P(SequenceFileWrong, IsReportedWithItsLine) {
  const auto read = read_sequence(GetParam().text, "a.toml");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().what, HasSubstr(GetParam().sentence));
  EXPECT_THAT(read.error().what, StartsWith("a.toml"));
}

std::string nested(int deep) {
  std::string text;
  for (int i = 0; i < deep; ++i) text += "{ do = \"loop\", steps = [\n";
  for (int i = 0; i < deep; ++i) text += "] }\n";
  return with_steps(text);
}

INSTANTIATE_TEST_SUITE_P(
    Each, SequenceFileWrong,
    testing::Values(
        Wrong{"NoToml", "handwheel_sequence = = 1", "line 1"},
        Wrong{"NoVersion", "unit = \"mm\"", "not a sequence"},
        Wrong{"Newer", "handwheel_sequence = 2", "version 1"},
        Wrong{"NoAxes", "handwheel_sequence = 1\nsteps = []", "does not list its axes"},
        Wrong{"AxisTwice",
              "handwheel_sequence = 1\naxes = [ { name = \"X\" }, { name = \"X\" } ]\nsteps = []",
              "line 2: each axis needs its own name"},
        Wrong{"NoScale", "handwheel_sequence = 1\naxes = [ { name = \"X\", per_unit = 0 } ]\nsteps = []",
              "line 2: per_unit"},
        Wrong{"NoSteps", std::string(beginning), "needs steps"},
        Wrong{"UnknownKey", "colour = 3\n" + with_steps(""), "line 1: colour is not known"},
        Wrong{"UnknownStep", with_steps("{ do = \"fly\" }"), "line 5: there is no step \"fly\""},
        Wrong{"NothingToDo", with_steps("{ axis = \"X\" }"), "line 5: the step does not say what to do"},
        Wrong{"UnknownField", with_steps("{ do = \"pen\", up = true }"), "line 5: up is not known"},
        Wrong{"UnknownAxis", with_steps("{ do = \"jog\", axis = \"Q\" }"),
              "line 5: axis must be one of the axes"},
        Wrong{"NoAxis", with_steps("{ do = \"jog\" }"), "line 5: it needs axis"},
        Wrong{"NoPlaces", with_steps("{ do = \"move\", to = {} }"), "line 5: it moves no axis"},
        Wrong{"PlaceIsNoNumber", with_steps("{ do = \"move\", to = { X = nan } }"),
              "line 5: X is not an axis with a number"},
        Wrong{"CentreIsMissing", with_steps("{ do = \"arc\", x = 1 }"), "line 5: it needs y"},
        Wrong{"PlaneOfAnUnknownAxis", with_steps("{ do = \"arc\", x = 1, y = 2, axes = [\"X\", \"Q\"] }"),
              "line 5: there is no axis \"Q\" in the file"},
        Wrong{"PlaneOfOneAxis", with_steps("{ do = \"arc\", x = 1, y = 2, axes = [\"X\", \"X\"] }"),
              "line 5: axes must be two different axes"},
        Wrong{"NoStairs", with_steps("{ do = \"speed_stairs\", axis = \"X\", stop_at = 1 }"),
              "line 5: it needs stairs in [ ]"},
        Wrong{"HalfAStair",
              with_steps("{ do = \"speed_stairs\", axis = \"X\", stairs = [ { until = 1 } ], stop_at = 1 }"),
              "line 5: it needs speed"},
        Wrong{"Direction", with_steps("{ do = \"jog\", axis = \"X\", direction = \"up\" }"),
              "direction has no such value"},
        Wrong{"Negative", with_steps("{ do = \"delay\", ms = -1 }"), "line 5: ms must not be negative"},
        Wrong{"Infinite", with_steps("{ do = \"delay\", ms = inf }"), "line 5: ms must be a number"},
        Wrong{"Whole", with_steps("{ do = \"wait_input\", input = 1.5 }"),
              "line 5: input must be a whole number"},
        Wrong{"OutputOfNone", with_steps("{ do = \"output\" }"),
              "line 5: it needs output, or the value of all"},
        Wrong{"Flag", with_steps("{ do = \"pen\", down = 1 }"), "line 5: down must be true or false"},
        Wrong{"TooDeep", nested(deepest_loop), "more than 8 deep"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace hw::sequence
