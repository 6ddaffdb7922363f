#include "core/device/tool_off.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/sequence/sequence.h"

namespace hw {
namespace {

namespace seq = sequence;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

seq::Step output(int number, bool on) { return {seq::Output{number, on}}; }

TEST(ToolOff, IsWhatPenDownLeavesOneWayAndPenUpTheOther) {
  seq::Sequence s;
  s.pen_down = {output(1, true), output(2, true), output(3, false), output(4, true)};
  s.pen_up = {output(1, false), output(2, true), output(3, true)};
  EXPECT_THAT(tool_off_of(s, 4), ElementsAre(ToolOutput{1, false}, ToolOutput{3, true}))
      << "2 stays on and 4 is left as it is: neither is the tool";
}

TEST(ToolOff, IsWhatARoutineLeavesAtItsEnd) {
  seq::Sequence s;
  s.pen_down = {output(1, false), {seq::Delay{5}}, output(1, true)};
  s.pen_up = {output(1, true), output(1, false), {seq::Output{1, true}, true}};
  EXPECT_THAT(tool_off_of(s, 4), ElementsAre(ToolOutput{1, false})) << "the last step of pen up is skipped";
}

TEST(ToolOff, KnowsTheOutputsThatAreSwitchedTogether) {
  seq::Sequence s;
  s.pen_down = {{seq::Output{-1, true, 0b0110}}};
  s.pen_up = {{seq::Output{-1, true, 0b0100}}};
  EXPECT_THAT(tool_off_of(s, 4), ElementsAre(ToolOutput{2, false}));
}

TEST(ToolOff, NoneIsMovedByAnAxisOrMissing) {
  seq::Sequence s;
  EXPECT_THAT(tool_off_of(s, 8), IsEmpty());
  seq::Move lift;
  lift.to[2] = 5;
  s.pen_up = {{lift}};
  s.pen_down = {output(1, true)};
  EXPECT_THAT(tool_off_of(s, 8), IsEmpty());
}

TEST(ToolOff, ATextCarriesItInAComment) {
  const ToolOff tool{{1, false}, {13, true}};
  const std::string line = tool_off_line(tool);
  EXPECT_EQ(line, "Tool off: output 1 off, output 13 on");
  for (const char* mark : {"; ", "# ", "' ", "  ;"})
    EXPECT_EQ(tool_off_in("X100\n" + (mark + line) + "\r\nX0\n").value(), tool) << mark;
  EXPECT_EQ(tool_off_in(";" + line).value(), tool) << "without a line end";
}

TEST(ToolOff, GivenTwiceItIsAllOfThem) {
  EXPECT_THAT(tool_off_in("; Tool off: output 1 off\n; Tool off: output 1 off, output 2 off\n").value(),
              ElementsAre(ToolOutput{1, false}, ToolOutput{2, false}));
}

TEST(ToolOff, OtherTextDoesNotMentionIt) {
  for (const char* text : {"", "X100", "; tool off at noon", "Tool off: output 1 off", "PM-0 ; Tool off: x"})
    EXPECT_THAT(tool_off_in(text).value(), IsEmpty()) << text;
}

TEST(ToolOff, AMalformedToolOffListIsNamedByItsLine) {
  for (const char* list : {"", " output 1", " output off", " output 1 off,", " 1 off", " output 1 offside",
                           " output -1 off", " output 99999999999 off"}) {
    const auto tool = tool_off_in(std::string("X1\n; Tool off:") + list + "\nX2");
    ASSERT_FALSE(tool) << list;
    EXPECT_THAT(tool.error().sentence(), HasSubstr("Line 2")) << list;
  }
}

TEST(ToolOff, IsDerivedFromTheOutputs) {
  EXPECT_EQ(tool_outputs_words({{3, false}}), "output 3");
  EXPECT_EQ(tool_outputs_words({{1, false}, {3, true}, {4, false}}), "outputs 1, 3 and 4");
}

}  // namespace
}  // namespace hw
