// Where a raw text sends the axes, read before it is sent.
#include "core/devices/arcus/text_goals.h"

#include <gtest/gtest.h>

#include "core/device/sequence_travel.h"
#include "core/devices/dmx_k_sa/forms.h"
#include "core/devices/pmx_4ex_sa/forms.h"

namespace hw::arcus {
namespace {

struct ArcusTextGoals : testing::Test {
  ArcusTextGoals() {
    now.axis_count = 4;
    for (int i = 0; i < 4; ++i) now.axes[i].position_known = true;
    now.axes[0].position = Steps(1000);
  }
  using Places = std::vector<AxisTarget>;
  static AxisTarget at(int axis, std::int64_t place) {
    return {AxisId{static_cast<std::uint8_t>(axis)}, Steps(place)};
  }
  Places pmx(std::string_view text, std::optional<bool> incremental = false) {
    return goals_of(pmx_4ex_sa::forms(), text, 0, incremental, now).places;
  }
  Places dmx(std::string_view text, std::optional<bool> incremental = false) {
    now.axis_count = 1;
    return goals_of(dmx_k_sa::forms(), text, 1, incremental, now).places;
  }

  Snapshot now;
};

TEST_F(ArcusTextGoals, TargetsAreAbsoluteOrDistancesByTheMode) {
  EXPECT_EQ(pmx("X4600"), Places{at(0, 4600)});
  EXPECT_EQ(pmx("X-500Y20U7"), (Places{at(0, -500), at(1, 20), at(3, 7)}));
  EXPECT_EQ(pmx("X4600", true), Places{at(0, 5600)});
  EXPECT_EQ(pmx("X4600", std::nullopt), Places{}) << "one or the other";
  EXPECT_EQ(dmx("X4600"), Places{at(0, 4600)});
  EXPECT_EQ(dmx("X+4600"), Places{at(0, 4600)});
  EXPECT_EQ(dmx("X4600", true), Places{at(0, 5600)});
  EXPECT_EQ(dmx("X9223372036854775807", true), Places{}) << "no place of the counter";
  EXPECT_EQ(dmx("X134217000", true), Places{});
  now.axes[0].position_known = false;
  EXPECT_EQ(dmx("X4600", true), Places{});
}

TEST_F(ArcusTextGoals, AChangedTargetIsAbsoluteInEitherMode) {
  EXPECT_EQ(pmx("TY300", true), Places{at(1, 300)});
  EXPECT_EQ(dmx("T300", true), Places{at(0, 300)});
  EXPECT_EQ(dmx("TR=300"), Places{});
}

TEST_F(ArcusTextGoals, NothingEndsAJog) {
  EXPECT_EQ(pmx("JZ-"), Places{at(2, -without_end.value)});
  EXPECT_EQ(dmx("J+", std::nullopt), Places{at(0, without_end.value)});
  EXPECT_EQ(dmx("JX+"), Places{});
}

TEST_F(ArcusTextGoals, ArcsReachAsFarAsTheirCircle) {
  const Places circle = {at(0, -1000), at(0, 1000), at(1, -1000), at(1, 1000)};
  EXPECT_EQ(pmx("CIRP0:0"), circle);
  EXPECT_EQ(pmx("CIRP0:0", true), Places{}) << "refused then";
  const Places quarter = {at(0, 0), at(0, 1000), at(1, 0), at(1, 1000)};
  EXPECT_EQ(pmx("ARCN0:0:90000:90000"), quarter);
  const Places both = {at(0, 0),     at(0, 1000), at(1, 0), at(1, 1000),
                       at(0, -1000), at(0, 1000), at(1, 0), at(1, 1000)};
  EXPECT_EQ(pmx("ARCN0:0:0:90000"), both) << "its end angle and its sweep disagree";
  EXPECT_EQ(pmx("I10:20:30:500"), (Places{at(0, 10), at(1, 20), at(2, 30)}));
}

TEST_F(ArcusTextGoals, HomingAndCommandsWithoutMotionHaveNoTarget) {
  for (const char* text :
       {"PX", "HX+0", "LY-", "ZX+", "EO=15", "HSX=2000", "X", "X=5", "STOPX", "XX4", "X4Q", ""})
    EXPECT_EQ(pmx(text), Places{}) << text;
  for (const char* text : {"H+", "L-", "Z+", "PX=0", "4600", "@02X4600"})
    EXPECT_EQ(dmx(text), Places{}) << text;
  EXPECT_EQ(dmx("@01X4600"), Places{at(0, 4600)});
  EXPECT_EQ(dmx("@00X4600"), Places{at(0, 4600)}) << "for all";
}

TEST_F(ArcusTextGoals, AStoredProgramThatIsStartedIsNamed) {
  const auto runs = [this](const char* text, std::optional<bool> incremental = false) {
    return goals_of(pmx_4ex_sa::forms(), text, 0, incremental, now).runs;
  };
  EXPECT_EQ(runs("SR2=1"), 2);
  EXPECT_EQ(runs("SR2=0"), -1);
  EXPECT_EQ(runs("SR2=1", true), -1) << "its targets may be distances";
  EXPECT_EQ(runs("X5"), -1);
}

}  // namespace
}  // namespace hw::arcus
