// Where a raw text sends the motors, read before it is sent.
#include "core/devices/vxm/text_goals.h"

#include <gtest/gtest.h>

#include "core/device/sequence_travel.h"

namespace hw::vxm {
namespace {

struct VxmTextGoals : testing::Test {
  VxmTextGoals() {
    now.axis_count = 4;
    for (int i = 0; i < 4; ++i) now.axes[i].position_known = true;
    held.selected = 0;
    held.contents[0].emplace();
  }
  /// The places of motor 1, in order.
  std::vector<std::int64_t> goals(std::string_view text, Listening listening = {}) {
    std::vector<std::int64_t> places;
    for (const AxisTarget& place : goals_of(text, listening, held, now).places)
      if (place.axis == AxisId{0}) places.push_back(place.value.value);
    return places;
  }
  using Places = std::vector<std::int64_t>;

  Snapshot now;
  HeldPrograms held;
};

TEST_F(VxmTextGoals, OnlyWhatIsRunMoves) {
  EXPECT_EQ(goals("I1M4000,"), Places{});
  EXPECT_EQ(goals("I1M4000,R"), Places{4000});
  EXPECT_EQ(goals("I1M4000R"), Places{}) << "the R breaks the command off";
  EXPECT_EQ(goals("C,S1M2000,IA1M-700,I1M200,R"), (Places{-700, -500}));
  EXPECT_EQ(goals("X"), Places{});
}

TEST_F(VxmTextGoals, DistancesCountFromWhereItStands) {
  now.axes[0].position = Steps(1000);
  EXPECT_EQ(goals("I1M4000,R"), Places{5000});
  now.axes[0].position_known = false;
  EXPECT_EQ(goals("I1M4000,R"), Places{}) << "nobody knows";
  EXPECT_EQ(goals("IA1M4000,R"), Places{4000});
}

TEST_F(VxmTextGoals, CommandsAlreadyInTheProgramRunToo) {
  held.contents[0] = commands_of({"I1M300"});
  EXPECT_EQ(goals("R"), Places{300});
  EXPECT_EQ(goals("I1M50,R"), (Places{300, 350}));
  EXPECT_EQ(goals("del,I1M50,R"), Places{50});
  EXPECT_EQ(goals("C,I1M50,R"), Places{50});
  EXPECT_EQ(goals("PM-1,I1M50,R"), Places{50}) << "another program, emptied";
  EXPECT_EQ(goals("PM1,I1M50,R"), Places{}) << "its contents are not known";
  held.contents[0].reset();
  EXPECT_EQ(goals("I1M50,R"), Places{});
}

TEST_F(VxmTextGoals, ATextChangesTheSelectedProgram) {
  ProgramContents program;
  const auto type = [&program](const char* text) {
    for (const TextCommand& c : read_text(text)) change(program, c);
    return program ? static_cast<int>(program->size()) : -1;
  };
  EXPECT_EQ(type("I1M50,"), -1) << "not known before, nor now";
  EXPECT_EQ(type("C"), 0);
  EXPECT_EQ(type("I1M50,X"), 1);
  EXPECT_EQ(type("S1M500,I1M50,"), 3);
  EXPECT_EQ(type("del"), 2);
  EXPECT_EQ(type("PM-3,"), 0);
}

TEST_F(VxmTextGoals, LoopsAndJumpsAreFollowed) {
  EXPECT_EQ(goals("I1M100,L3,R"), (Places{100, 200})) << "the last pass leaves it out";
  EXPECT_EQ(goals("I1M100,LM0,I1M1,L2,R"), (Places{100, 101}));
  EXPECT_EQ(goals("I1M100,P5,L3,R"), (Places{100, 200, 300})) << "only the pause is left out";
  EXPECT_EQ(goals("I1M5,(I1M100,I2M100,)L2,R"), (Places{5, 105, 110})) << "a pair is one command";
  EXPECT_EQ(goals("I1M100,L1,R"), Places{100});
  EXPECT_EQ(goals("I1M100,L0,R").back(), without_end.value) << "it goes on and on";
  EXPECT_EQ(goals("I1M-100,I1M50,J0,R").back(), -without_end.value);
  EXPECT_LT(goals("I1M100,I1M-100,L0,R").back(), 1000) << "to and fro";
  EXPECT_EQ(goals("I1M100,L-2,R"), Places{100}) << "then distances turn around";
  held.contents[1] = commands_of({"I1M7"});
  EXPECT_EQ(goals("JM1,JM1,I1M1,R"), (Places{7, 14, 15}));
  EXPECT_EQ(goals("J1,I1M1,R"), Places{7});
  held.contents[1] = commands_of({"JM1"});
  EXPECT_EQ(goals("JM1,R"), Places{}) << "it calls itself";
}

TEST_F(VxmTextGoals, AListingWithASpoiltByteIsFollowedUpToIt) {
  for (const char* spoilt : {"I9M400", "J7", "JM7", "IA9M-0", "I9M0"}) {
    held.contents[0] = commands_of({"I1M5", spoilt, "I1M7"});
    EXPECT_EQ(goals("R"), Places{5}) << spoilt;
  }
}

TEST_F(VxmTextGoals, WhereAProgramBehindProgram4BeginsIsNotKnown) {
  held.program_4_first = true;
  EXPECT_EQ(goals("I1M5,R"), Places{});
  EXPECT_EQ(goals("IA1M5,I1M2,R"), (Places{5, 7}));
}

TEST_F(VxmTextGoals, APairIsDeletedAsOne) {
  held.contents[0] = commands_of({"I1M5", "(I1M100", "I2M100", ")"});
  EXPECT_EQ(goals("del,R"), Places{5});
}

TEST_F(VxmTextGoals, AfterAResetTheStoredProgramsAreNotKnown) {
  now.axes[0].position = Steps(1000);
  EXPECT_EQ(goals("res,F,R"), Places{});
  EXPECT_EQ(goals("I1M9,res,F,C,I1M5,R"), Places{5});
}

TEST_F(VxmTextGoals, ACountThatIsSetCountsFromThere) {
  now.axes[0].position = Steps(1000);
  EXPECT_EQ(goals("IA1M-0,I1M50,R"), Places{50});
  EXPECT_EQ(goals("N,I1M50,R"), Places{50});
  EXPECT_EQ(goals("I1M-0,I1M50,R"), Places{}) << "where the switch is, nobody knows";
  EXPECT_EQ(goals("I1M-0,IA1M-0,I1M50,R"), Places{50});
}

TEST_F(VxmTextGoals, CommandsThatTheControllerDropsMoveNothing) {
  Listening runs;
  runs.running = true;
  EXPECT_EQ(goals("I1M4000,R", runs), Places{});
  Listening local;
  local.local = true;
  EXPECT_EQ(goals("I1M4000,R", local), Places{});
  EXPECT_EQ(goals("F,I1M4000,R", local), Places{4000});
  EXPECT_EQ(goals("[I1M4000,R]"), Places{}) << "for the Slave";
}

}  // namespace
}  // namespace hw::vxm
