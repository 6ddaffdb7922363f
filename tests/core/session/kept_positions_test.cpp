// What is kept of positions from one session to the next, and what is believed of it then.
#include "core/session/kept_positions.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

constexpr Instant now{hours(1)};
KeptPosition kept(std::int64_t at, PositionTrust trust) { return {true, Steps(at), trust}; }
const PositionTrust homed{Trust::homed, Doubt::none, now - minutes(5)};

TEST(Recalled, TheSameCountProvesThatNothingHasHappened) {
  const PositionTrust trust = recalled(kept(5000, homed), Steps(5000), now);
  EXPECT_EQ(trust.kind, Trust::homed);
  EXPECT_TRUE(trust.restored);
  EXPECT_EQ(trust.since, homed.since);
}

TEST(Recalled, ZeroProvesNothing) { EXPECT_EQ(recalled(kept(0, homed), Steps(0), now), PositionTrust()); }

TEST(Recalled, ZeroWhereItStoodElsewhereIsNotTrusted) {
  const PositionTrust trust = recalled(kept(5000, homed), Steps(0), now);
  EXPECT_EQ(trust.cause, Doubt::zero_since);
  EXPECT_TRUE(trust.doubtful());
  EXPECT_EQ(trust.since, now);
}

TEST(Recalled, AnotherCountIsCountedOnly) {
  EXPECT_EQ(recalled(kept(5000, homed), Steps(4999), now), PositionTrust());
  EXPECT_EQ(recalled(kept(5000, {}), Steps(0), now), PositionTrust()) << "nobody had said where zero is";
}

TEST(Recalled, DoubtIsNotHealedByAMove) {
  PositionTrust doubted;
  doubted.doubt(Doubt::killed, now - minutes(9));
  const PositionTrust trust = recalled(kept(5000, doubted), Steps(7), now);
  EXPECT_EQ(trust.cause, Doubt::killed);
  EXPECT_TRUE(trust.doubtful());
}

class KeptPositionsTest : public testing::Test {
 protected:
  test::Folder folder;
  KeptPositions store{UserFolders::below(folder.path())};
  const std::chrono::system_clock::time_point today{hours(500'000)};
};

TEST_F(KeptPositionsTest, TheNextSessionReadsThemOnItsOwnClock) {
  ASSERT_TRUE(store.save("usb-A10", {kept(5000, homed), KeptPosition()}, {now, today}));
  const auto read = store.load("usb-A10", {Instant{}, today + minutes(10)});
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ(read->at(0).position, Steps(5000));
  EXPECT_EQ(read->at(0).trust.kind, Trust::homed);
  EXPECT_EQ(read->at(0).trust.since, Instant{} - minutes(15));
  EXPECT_FALSE(read->at(1).known);
  EXPECT_TRUE(store.load("usb-B11", {Instant{}, today})->empty()) << "another controller";
}

TEST_F(KeptPositionsTest, ADamagedFileIsPutAside) {
  ASSERT_TRUE(store.save("usb-A10", {kept(5000, homed)}, {now, today}));
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder.path()))
    if (file.is_regular_file()) std::ofstream(file.path()) << R"({"axes":[{"position":1,"trust":"sworn"}]})";
  const auto read = store.load("usb-A10", {now, today});
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().sentence().find("where the axes stood"), std::string::npos);
  EXPECT_TRUE(store.load("usb-A10", {now, today})->empty());
}

}  // namespace
}  // namespace hw
