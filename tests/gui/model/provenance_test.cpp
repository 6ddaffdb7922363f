// Where the number of an axis comes from, in words.
#include "gui/model/provenance.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

class ProvenanceTest : public testing::Test {
 protected:
  Snapshot now;
  Instant clock{hours(2)};
  DayClock day{hours(12)};  // it is 14:00

  void SetUp() override {
    now.link.state = LinkState::good;
    now.axis_count = 1;
    now.poll_period = Millis(200);
    axis().position_known = true;
    axis().seen_at = clock;
  }
  AxisState& axis() { return now.axes[0]; }
  std::string words(bool brief = false) {
    return std::string(provenance(now, AxisId{0}, clock, day, brief).view());
  }
};

TEST_F(ProvenanceTest, NamesWhoHasSetWhereItStandsAndWhen) {
  EXPECT_EQ(words(), "counted");
  axis().trust.settle(Trust::homed, clock - minutes(116));
  EXPECT_EQ(words(), "homed 12:04");
  EXPECT_EQ(words(true), "homed");
  axis().trust.settle(Trust::set, clock - minutes(1));
  EXPECT_EQ(words(), "set by hand 13:59");
}

TEST_F(ProvenanceTest, ShowsTheDayIfOlderThanToday) {
  axis().trust.settle(Trust::homed, clock - hours(14));
  EXPECT_EQ(words(), "homed 00:00");
  axis().trust.settle(Trust::homed, clock - hours(15));
  EXPECT_EQ(words(), "homed yesterday");
  axis().trust.settle(Trust::homed, clock - hours(24 * 9));
  EXPECT_EQ(words(), "homed 9 days ago");
}

TEST_F(ProvenanceTest, MarksWhatAnEarlierSessionHasLearned) {
  axis().trust =
      recalled({true, Steps(40), {Trust::homed, Doubt::none, clock - hours(15)}}, Steps(40), clock);
  EXPECT_EQ(words(), "homed yesterday, restored");
  EXPECT_EQ(words(true), "restored");
}

TEST_F(ProvenanceTest, PutsDoubtAndAgeFirst) {
  axis().trust.doubt(Doubt::power_cut, clock);
  EXPECT_EQ(words(), "untrusted: power was cut");
  clock += Millis(1200);
  EXPECT_EQ(words(), "1.2 s old");
  axis().position_known = false;
  now.link.state = LinkState::good;
  EXPECT_EQ(words(), "not known: home it, or set it");
}

}  // namespace
}  // namespace hw::gui
