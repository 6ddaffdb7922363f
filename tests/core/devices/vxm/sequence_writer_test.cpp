// What a sequence becomes as stored programs of a VXM.
#include "core/devices/vxm/sequence_writer.h"

#include <gmock/gmock.h>

#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::vxm {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::ElementsAre;
using testing::HasSubstr;

struct VxmSequence : testing::Test {
  VxmSequence() {
    s.unit = "mm";
    s.axes = {{"1", 400}, {"3", 200}};
  }
  std::string write(seq::StepList steps) {
    s.steps = std::move(steps);
    auto text = write_sequence(s, *make_catalog({{"motors", "4"}}));
    if (!text) return text.error().what;
    remarks = text->remarks;
    expect_reads_back(program_language(), text->text, s, *make_catalog({{"motors", "4"}}));
    return text->text;
  }
  static seq::Move to(double first, bool relative = false) {
    seq::Move m;
    m.to[0] = first, m.relative = relative;
    return m;
  }
  seq::Sequence s;
  std::vector<std::string> remarks;
};

TEST_F(VxmSequence, SpeedsAreOfEachMotor) {
  EXPECT_EQ(write({{seq::Speed{{5, 0, 500}}}}), "S1M2000\nA1M4\nS3M1000\nA3M2\n");
  EXPECT_THAT(write({{seq::Speed{{5, 1}}}}), HasSubstr("Step 1 (speed): a VXM has no low speed"));
  EXPECT_THAT(write({{seq::Speed{{0, 0, 100}}}}), HasSubstr("give a speed with the ramp time"));
  EXPECT_EQ(write({{seq::Speed{{1, 0, 10'000}}}}), "S1M400\nA1M1\nS3M200\nA3M1\n");
  EXPECT_THAT(remarks, ElementsAre(HasSubstr("a ramp of 10000 ms is not possible: it takes 400 ms"),
                                   HasSubstr("it takes 200 ms")));
}

TEST_F(VxmSequence, MotorsGoOneAfterTheOther) {
  seq::Move both = to(1.5);
  both.to[1] = -2;
  EXPECT_EQ(write({{both}}), "IA1M600\nIA3M-400\n");
  EXPECT_THAT(remarks,
              ElementsAre(HasSubstr("motors on Master and Slave could start together"),
                          "Step 1 (move): its motors move one after the other, not on a straight line."));
  EXPECT_EQ(write({{to(0)}, {to(-0.5, true)}, {to(0, true)}}), "IA1M0\nI1M-200\n")
      << "a relative move of nothing would be one to the limit switch";
}

TEST_F(VxmSequence, HomeIsTheLimitSwitchAndZeroThere) {
  EXPECT_EQ(write({{seq::Home{1, Sign::minus, {}}}, {seq::Home{0, Sign::plus, {}}}}),
            "I3M-0\nIA3M-0\nI1M0\nIA1M-0\n");
}

TEST_F(VxmSequence, DelaysAreTenthsOfAMillisecondOrOfASecond) {
  EXPECT_EQ(write({{seq::Delay{0.5}}, {seq::Delay{250}}, {seq::Delay{3000}}, {seq::Delay{6553.5}}}),
            "P-5\nP-2500\nP30\nP-65535\n");
  EXPECT_EQ(write({{seq::Delay{7000.5}}, {seq::Delay{7'000'000}}}), "P70\nP-5\nP65535\nP4465\n");
}

TEST_F(VxmSequence, InputsAreWaitedForInProgramsWhereNoCommandDoes) {
  EXPECT_EQ(write({{seq::WaitInput{1, true}}}), "U0\n");
  EXPECT_EQ(write({{seq::WaitInput{2, true}}, {seq::WaitInput{2, true}}, {seq::WaitInput{1, false}}}),
            "PM-0\nJM1\nJM1\nJM2\n"
            "PM-1 ; waits until input 2 is on\nP-10\nU22\nL0\n"
            "PM-2 ; waits until input 1 is off\nP-10\nU11\nL0\n");
  EXPECT_THAT(write({{seq::WaitInput{3, true}}}), HasSubstr("test only inputs 1 and 2"));
}

TEST_F(VxmSequence, AMoveOnInputIsLeftOutOtherwise) {
  seq::MoveOnInput m;
  m.input = 2, m.to = 1;
  EXPECT_EQ(write({{m}}), "U12\nIA1M400\n") << "low is on";
  m.on = false, m.kind = seq::MoveOnInput::Kind::home, m.direction = Sign::minus;
  EXPECT_EQ(write({{m}, {m}}),
            "PM-0\nU22\nJM1\nU22\nJM1\nPM-1 ; motor 1 to its limit switch\nI1M-0\nIA1M-0\n")
      << "the input is asked once: both commands run, or none";
  auto plus = m;
  plus.direction = Sign::plus;
  EXPECT_THAT(write({{m}, {plus}}), HasSubstr("PM-2 ; motor 1 to its limit switch\nI1M0\n"));
}

TEST_F(VxmSequence, OutputsAreTheMakersOwn) {
  EXPECT_EQ(write({{seq::Output{1, true}}, {seq::Output{4, false}}, {seq::Output{-1, true, 6}}}),
            "U5\nU18\nU4\nU15\nU17\nU18\n");
}

TEST_F(VxmSequence, ALoopWithinALoopIsAProgramOfItsOwn) {
  seq::Repeat inner, outer;
  inner.times = 3, inner.steps = {{to(1, true)}};
  outer.times = 0, outer.steps = {{inner}, {seq::Delay{100}}};
  EXPECT_EQ(write({{seq::Delay{200}}, {outer}}), "PM-0\nP2\nLM0\nJM1\nP1\nL0\nPM-1 ; a loop\nI1M400\nLA3\n");
}

TEST_F(VxmSequence, UnsupportedStepsAreRefused) {
  EXPECT_THAT(write({{seq::Arc{}}}), HasSubstr("Step 1 (arc): a VXM moves one motor at a time"));
  EXPECT_THAT(write({{seq::Jog{}}}), HasSubstr("Step 1 (jog): "));
  EXPECT_THAT(write({{seq::Stop{}}}), HasSubstr("Step 1 (stop): "));
  EXPECT_THAT(write({{seq::Enable{}}}), HasSubstr("Step 1 (enable): "));
  s.pen_down = {{seq::Delay{1}}, {seq::Arc{}}};
  EXPECT_THAT(write({{seq::Pen{true}}}), HasSubstr("Pen down, step 2 (arc): "));
}

TEST_F(VxmSequence, ARoutineWithALoopIsCalledByItsOwnNumber) {
  seq::Repeat loop;
  loop.times = 2, loop.steps = {{seq::Delay{100}}};
  s.pen_down = {{seq::Output{1, true}}, {loop}};
  EXPECT_EQ(write({{seq::Pen{true}}, {seq::Pen{true}}}),
            "PM-0\nJM1\nJM1\nPM-1 ; Pen down\nU5\nJM2\nPM-2 ; a loop\nP1\nLA2\n");
}

TEST_F(VxmSequence, TheToolIsNoPartOfItsOwnRoutines) {
  s.pen_down = {{seq::Pen{true}}};
  EXPECT_THAT(write({{seq::Pen{true}}}),
              HasSubstr("Pen down, step 1 (pen): the tool cannot be part of its own"));
}

}  // namespace
}  // namespace hw::vxm
