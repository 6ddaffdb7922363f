// Where a raw text sends the axes, read before it is sent.
#include "core/devices/vme58/text_goals.h"

#include <gtest/gtest.h>

#include "core/device/sequence_travel.h"

namespace hw::vme58 {
namespace {

struct Vme58TextGoals : testing::Test {
  Vme58TextGoals() {
    now.axis_count = 8;
    for (int i = 0; i < 8; ++i) now.axes[i].position_known = true;
    now.axes[0].position = Steps(1000);
  }
  using Places = std::vector<AxisTarget>;
  static AxisTarget at(int axis, std::int64_t place) {
    return {AxisId{static_cast<std::uint8_t>(axis)}, Steps(place)};
  }
  Places goals(std::string_view text) { return goals_of(text, context, units, prepared, now).places; }

  Snapshot now;
  Context context;
  UserUnits units{};
  PreparedMoves prepared;
};

TEST_F(Vme58TextGoals, OnlyGoMoves) {
  EXPECT_EQ(goals("AX MA4600"), Places{});
  EXPECT_EQ(goals("AX MA4600 GO ID"), Places{at(0, 4600)});
  EXPECT_EQ(goals("AX MR4600 GO MR-100 GD"), (Places{at(0, 5600), at(0, 5500)}));
  EXPECT_EQ(goals("AX MA4600 AY GO"), Places{}) << "each queue has its own";
  EXPECT_EQ(goals("AM MA10,,30; GO"), (Places{at(0, 10), at(2, 30)}));
  EXPECT_EQ(goals("AA MT10,20; GO ML5,5; GO"), (Places{at(0, 10), at(1, 20), at(0, 15), at(1, 25)}));
  EXPECT_EQ(goals("AX MA4600 GO GO"), Places{at(0, 4600)}) << "the second finds nothing prepared";
}

TEST_F(Vme58TextGoals, AMovePreparedByAnEarlierTextGoesToo) {
  for (const TextCommand& command : read_commands("AX MA700", context)) prepared.note(command, units);
  EXPECT_EQ(goals("GO"), Places{at(0, 700)});
  EXPECT_EQ(goals("MR5 GO"), Places{at(0, 1005)}) << "replaced";
  for (const TextCommand& command : read_commands("GO", context)) prepared.note(command, units);
  EXPECT_EQ(goals("GO"), Places{});
}

TEST_F(Vme58TextGoals, LoopsAreCarriedOut) {
  EXPECT_EQ(goals("AX LS3 MR10 GO LE"), (Places{at(0, 1010), at(0, 1020), at(0, 1030)}));
  EXPECT_EQ(goals("AX LS2 LS2 MR1 GO LE LE"), (Places{at(0, 1001), at(0, 1002), at(0, 1003), at(0, 1004)}));
  EXPECT_EQ(goals("AX LS2000000000 MR1 GO LE").back(), at(0, 2'000'001'000)) << "as far as a long one goes";
  EXPECT_LT(goals("AX LS2000000000 MR1 GO MR-1 GO LE").back().value, Steps(2000)) << "to and fro";
  EXPECT_EQ(goals("AX WH MR-1 GO WG AY MA7 GO"),
            (Places{at(0, 999), at(0, 998), at(0, -hw::without_end.value), at(1, 7)}));
  EXPECT_EQ(goals("AX WS0 MA5 GO WD MR1 GO"), (Places{at(0, 5), at(0, 5), at(0, 6)}));
}

TEST_F(Vme58TextGoals, UserUnitsMultiply) {
  units[0] = 10;
  EXPECT_EQ(goals("AX MA46 GO"), Places{at(0, 460)});
  EXPECT_EQ(goals("AX UU2 MA46 GO"), Places{at(0, 92)});
  EXPECT_EQ(goals("AX UF MA46 GO"), Places{at(0, 46)});
  EXPECT_EQ(goals("AX JG-5"), Places{at(0, -hw::without_end.value)});
}

TEST_F(Vme58TextGoals, AJogHasNoEndUnlessTheTextEndsIt) {
  EXPECT_EQ(goals("AX JG500"), Places{at(0, hw::without_end.value)});
  EXPECT_EQ(goals("AX JG500 WT100 JG0"), Places{});
  EXPECT_EQ(goals("AX JF-0.5"), Places{at(0, -hw::without_end.value)});
  EXPECT_EQ(goals("AX JG500 SP4000"), Places{at(0, 4000)});
  EXPECT_EQ(goals("AX JG500 FP4000"), Places{at(0, 4000)});
}

TEST_F(Vme58TextGoals, AStaircaseRunsOnUntilItIsEnded) {
  EXPECT_EQ(goals("AX MP MV2000,500"), (Places{at(0, 2000), at(0, hw::without_end.value)}));
  EXPECT_EQ(goals("AX MM MV-100,500 MV-200,50"),
            (Places{at(0, -100), at(0, -200), at(0, -hw::without_end.value)}));
  EXPECT_EQ(goals("AX MP MV2000,500 SP3000"), (Places{at(0, 2000), at(0, 3000)}));
  EXPECT_EQ(goals("AX MP MV2000,500 JG0"), Places{at(0, 2000)});
}

TEST_F(Vme58TextGoals, AStopFlushesTheQueueThatItAddresses) {
  const Places far = {at(1, 9'000'000)};
  EXPECT_EQ(goals("AY MA9000000; AX ST; AY GO"), far);
  EXPECT_EQ(goals("AY MA9000000; AX FL; AY GO"), far);
  EXPECT_EQ(goals("AY MA9000000 GO; AX MA5 GO ST"), far);
  EXPECT_EQ(goals("AY MA9000000; ST GO"), Places{});
  EXPECT_EQ(goals("AY MA9000000; AX SA; AY GO"), Places{}) << "this one flushes all";
}

TEST_F(Vme58TextGoals, AResetForgetsAll) {
  EXPECT_EQ(goals("AX MA5 GO JG500 RS"), Places{});
  EXPECT_EQ(goals("AX LS2 MA5 GO RS LE AX MR5 GO"), Places{});
}

TEST_F(Vme58TextGoals, AHugeNumberIsFarAway) {
  units[0] = 1e12;
  EXPECT_EQ(goals("AX MA9999999 GO").size(), 1u);
}

TEST_F(Vme58TextGoals, AMoveForgetsTheQueuesOfItsAxes) {
  for (const TextCommand& command : read_commands("AX MA1; AY MA2; AA MA3; AY", context))
    prepared.note(command, units);
  prepared.forget(1, false);
  EXPECT_EQ(goals("AX GO; AY GO; AA GO"), (Places{at(1, 2), at(0, 3)}));
  for (const TextCommand& command : read_commands("AY MR4", context)) prepared.doubt(command);
  EXPECT_EQ(goals("AX GO; AY GO; AA GO"), Places{at(0, 3)});
}

TEST_F(Vme58TextGoals, CountsThatAreSetAndPlacesThatAreNotKnown) {
  EXPECT_EQ(goals("AX LP0 MR50 GO"), Places{at(0, 50)});
  EXPECT_EQ(goals("AX HM0 MR50 GO"), Places{}) << "how far it runs on, nobody knows";
  EXPECT_EQ(goals("AX HM0 MA50 GO"), Places{at(0, 50)});
  EXPECT_EQ(goals("AX MA50 QQ GO"), Places{}) << "nothing behind a mistake is sent";
  EXPECT_EQ(goals("AX MA4600 GO SA"), Places{}) << "perhaps it is stopped before";
  now.axes[0].position_known = false;
  EXPECT_EQ(goals("AX MR50 GO"), Places{});
}

TEST_F(Vme58TextGoals, AContourOfTheTextIsPlayedByCx) {
  const std::string contour = "AA CV1000 CD1000,0; MT500,20; CR0,20,3.141592653589793 CE";
  EXPECT_EQ(goals(contour), Places{}) << "it is only recorded";
  const Places played = goals(contour + " CX");
  ASSERT_GE(played.size(), 4u);
  EXPECT_EQ(played[2], at(0, 500));
  EXPECT_NE(std::find(played.begin(), played.end(), at(1, 520)), played.end())
      << "the top of its half circle";
  EXPECT_EQ(goals("AA CX"), Places{}) << "recorded before";
}

TEST_F(Vme58TextGoals, NoTextTakesLongToRead) {
  const Places turns = goals("AA CV1000 CD0,0; CR10,10,-100000000000000000000 CE CX");
  EXPECT_LT(turns.size(), 20u) << "more turns than can be counted";
  std::string contour = "AA CD0,0;";
  for (int i = 0; i < 200; ++i) contour += "MT" + std::to_string(i) + ",0;";
  EXPECT_LT(goals(contour + "CE LS9999 CX LE").size(), 50'000u);
}

}  // namespace
}  // namespace hw::vme58
