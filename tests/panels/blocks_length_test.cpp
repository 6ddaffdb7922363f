// Blocks that run for long, and blocks whose controller has not told everything: what is said of their time.
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct LongBlocks : test_blocks::BlocksStage {
  LongBlocks() : BlocksStage("dmx-k-sa") {}
  void set(const char* name, std::int64_t value, bool known) {
    const int place = s.catalog.find_param(name);
    ASSERT_GE(place, 0) << name;
    s.now.params[static_cast<std::size_t>(place)] = {value, known};
  }
  static sequence::Move to(double place) {
    sequence::Move move;
    move.to[0] = place;
    return move;
  }
};

TEST_F(LongBlocks, OfMoreThanTenMinutesTheTimeIsExact) {
  load({{sequence::Delay{1'000'000}}});
  s.stage.frames(6);
  EXPECT_EQ(value("blocks/total"), "16 min 40 s");
  EXPECT_EQ(value("blocks/1/time"), "1000.0 s");
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsed: this text"));
}

TEST_F(LongBlocks, OfMoreThanAnHourThatIsReported) {
  load({{sequence::Delay{5'000'000}}});
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/at_least"), StartsWith("at least 1 h"));
  EXPECT_THAT(value("blocks/1/time"), StartsWith("over 1 h"));
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("longer than the hour"));
}

TEST_F(LongBlocks, OfAMotionWithoutEndThatIsReportedAtItsBlock) {
  load({{sequence::Enable{0, true}}, {sequence::Home{0, Sign::minus}}});  // there is no switch
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/no_end"), AllOf(StartsWith("Rehearsed for 1 h"), HasSubstr("line 2")));
  EXPECT_THAT(value("blocks/2/time"), StartsWith("over "));
}

TEST_F(LongBlocks, UnknownParametersAreNamedAndReadByF5) {
  set("HSPD", 0, false);
  load({{sequence::Enable{0, true}}, {to(4000)}});
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/assumed"), AllOf(StartsWith("Unknown, so assumed"), HasSubstr("HSPD")));
  EXPECT_THAT(value("blocks/rehearsed"), Not(HasSubstr("card")));
  const std::string assumed = value("blocks/total");
  key("F5");
  ASSERT_TRUE(s.last<intent::ReadParams>());
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsing."));
  set("HSPD", 200, true);
  s.settle(IntentState::done);
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/assumed"), Not(HasSubstr("HSPD")));
  EXPECT_NE(value("blocks/total"), assumed);
}

TEST_F(LongBlocks, UnreadableParametersDoNotHoldUpTheRehearsal) {
  set("HSPD", 0, false);
  load({{sequence::Enable{0, true}}, {to(4000)}});
  key("F5");
  s.settle(IntentState::failed, "No answer.");
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("with the assumptions listed"));
}

}  // namespace
}  // namespace hw::panels
