#include "gui/model/units_format.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

const DisplayUnit steps;
const DisplayUnit mm{"mm", 0.0025, 3, true};
const DisplayUnit inch{"inch", 0.001, 3, true};
const DisplayUnit degrees{"°", 0.0125, 2, true};

std::string position(std::int64_t n, const DisplayUnit& u) {
  return std::string(format_position(Steps(n), u).view());
}

TEST(UnitsFormat, ShowsSteps) {
  EXPECT_EQ(position(0, steps), "0");
  EXPECT_EQ(position(3120, steps), "3120");
  EXPECT_EQ(position(-3120, steps), "−3120");
  EXPECT_EQ(position(57000, steps), "57\u2009000") << "thin space from five figures on";
  EXPECT_EQ(position(-8388608, steps), "−8\u2009388\u2009608");
}

TEST(UnitsFormat, ShowsRealUnitsWithTheDecimalsOfOneStep) {
  EXPECT_EQ(position(3120, mm), "7.800");
  EXPECT_EQ(position(1, mm), "0.003");
  EXPECT_EQ(position(-60000, mm), "−150.000");
  EXPECT_EQ(position(8388607, mm), "20\u2009971.518");
  EXPECT_EQ(std::string(format_with_unit(Steps(3120), mm).view()), "7.800 mm");
  EXPECT_EQ(std::string(format_with_unit(Steps(80), degrees).view()), "1.00°");
  EXPECT_EQ(std::string(format_with_unit(Steps(1), steps).view()), "1 step");
  EXPECT_EQ(std::string(format_speed(Pps(2000), mm).view()), "5.000 mm/s");
  EXPECT_EQ(std::string(format_speed(Pps(2000), steps).view()), "2000 steps/s");
}

TEST(UnitsFormat, NumbersHaveARealMinusAndThinSpacesFromFiveFiguresOn) {
  EXPECT_EQ(format_number(-150, 3).view(), "\u2212150.000");
  EXPECT_EQ(format_number(57000, 0).view(), "57\u2009000");
  EXPECT_EQ(format_number(1234567.5, 1).view(), "1\u2009234\u2009567.5");
  EXPECT_EQ(format_number(3120, 0).view(), "3120");
}

TEST(UnitsFormat, NothingIsMinusZero) {
  EXPECT_EQ(format_number(-0.0001, 3).view(), "0.000");
  EXPECT_EQ(format_number(-0.0, 0).view(), "0");
}

TEST(UnitsFormat, ReadsWhatPeopleType) {
  for (const char* text : {"7.8", "7,8", " 7.800 ", "+7.8", "7.8 mm", "7,8mm"})
    EXPECT_EQ(parse_position(text, mm).value(), Steps(3120)) << text;
  EXPECT_EQ(parse_position("-150", mm).value(), Steps(-60000));
  EXPECT_EQ(parse_position("−150", mm).value(), Steps(-60000)) << "the real minus, copied from the screen";
  EXPECT_EQ(parse_position("57 000", steps).value(), Steps(57000));
  EXPECT_EQ(parse_position("57\u2009000 steps", steps).value(), Steps(57000));
}

TEST(UnitsFormat, DecimalCommaIsNeverAThousand) {  // 60 um became 60 mm elsewhere
  EXPECT_EQ(parse_position("0,060", mm).value(), Steps(24));
  EXPECT_EQ(parse_position("1,000", mm).value(), Steps(400));
}

TEST(UnitsFormat, RefusesWhatCanBeReadTwoWays) {
  for (const char* text : {"1,000.5", "1.000,5", "1.2.3"}) {
    const auto read = parse_position(text, mm);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(read.error().sentence().find("more than one decimal mark"), std::string::npos);
  }
  for (const char* text : {"", "mm", "twelve", "--3", "+-3", "3e5", "nan", "1/2"})
    EXPECT_FALSE(parse_position(text, mm).has_value()) << text;
  EXPECT_FALSE(parse_position("1.5", steps).has_value()) << "no half steps";
  EXPECT_FALSE(parse_position("99999999999999999999", mm).has_value());
}

TEST(UnitsFormat, AShownPositionReadsBackAsTheSameSteps) {
  for (const DisplayUnit& u : {steps, mm, inch, degrees})
    for (std::int64_t n : {0, 1, -1, 3120, -57001, 8388607, -8388608})
      EXPECT_EQ(parse_position(format_with_unit(Steps(n), u).view(), u).value(), Steps(n))
          << u.name << " " << n;
}

TEST(UnitsFormat, ReversedUnitsCountAgainstTheSteps) {
  DisplayUnit reversed = mm;
  reversed.per_step = -reversed.per_step;
  EXPECT_EQ(position(3120, reversed), "−7.800");
  EXPECT_EQ(parse_position("-7.8", reversed).value(), Steps(3120));
  EXPECT_EQ(jog_steps(reversed)[1].steps, jog_steps(mm)[1].steps);
}

TEST(UnitsFormat, JogStepsFollowTheUnit) {
  std::vector<std::string> labels;
  for (const JogStep& s : jog_steps(mm)) labels.push_back(s.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"1 step", "0.01 mm", "0.1 mm", "1 mm", "10 mm"}));
  EXPECT_EQ(jog_steps(mm)[2].id, "0.1");
  EXPECT_EQ(jog_steps(mm)[2].steps, Steps(40));
  EXPECT_TRUE(jog_steps(mm)[2].caption.empty());
  EXPECT_EQ(jog_steps(steps)[0].id, "1");
  EXPECT_EQ(jog_steps(steps)[4].label, "10\u2009000 steps");
  EXPECT_EQ(jog_steps(mm, 4).size(), 4u);
}

TEST(UnitsFormat, AStepThatDoesNotFitShowsWhatItRoundsTo) {
  const DisplayUnit e04{"mm", 0.0254, 2, true};
  const auto list = jog_steps(e04);
  EXPECT_EQ(list[1].label, "0.1 mm");
  EXPECT_EQ(list[1].steps, Steps(4));
  EXPECT_EQ(list[1].caption, "4 steps: 0.10");
}

TEST(CountedUnit, IsInCountsWhereTheLoopIsClosed) {
  Catalog c;
  c.step_word = "pulses", c.loop_word = "counts";
  Snapshot now;
  now.axis_count = 2;
  EXPECT_EQ(counted_unit(c, now, "pulses/s"), "pulses/s");
  now.axes[1].in_counts = true;
  EXPECT_EQ(counted_unit(c, now, "pulses/s", 0), "pulses/s");
  EXPECT_EQ(counted_unit(c, now, "pulses/s", 1), "counts/s");
  EXPECT_EQ(counted_unit(c, now, "pulses/s"), "/s") << "one axis counts this, the other that";
  now.axes[0].in_counts = true;
  EXPECT_EQ(counted_unit(c, now, "pulses"), "counts");
  EXPECT_EQ(counted_unit(c, now, "ms"), "ms");
}

TEST(CountOf, OneStepOfAnyWordIsNoPlural) {
  const DisplayUnit pulses{"pulses", 1, 0, false};
  EXPECT_EQ(format_with_unit(Steps(1), pulses).view(), "1 pulse");
  EXPECT_EQ(format_with_unit(Steps(2), pulses).view(), "2 pulses");
  EXPECT_EQ(*parse_position("1 pulse", pulses), Steps(1));
  EXPECT_EQ(*parse_position("7 pulses", pulses), Steps(7));
}

TEST(CountOf, OneIsNoPlural) {
  EXPECT_EQ(count_of(1, "lines"), "1 line");
  EXPECT_EQ(count_of(0, "lines"), "0 lines");
  EXPECT_EQ(count_of(24, "bytes"), "24 bytes");
}

}  // namespace
}  // namespace hw::gui
