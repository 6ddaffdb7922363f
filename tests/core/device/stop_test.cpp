// Which stop ramps, which is at once, and which goes out first.
#include "core/device/stop.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

class StopDeskTest : public testing::Test {
 protected:
  StopOrder& ask(IntentBody body) { return desk.ask(*stop_order_of(Intent(++last_id, std::move(body)))); }
  void send(StopOrder& order) { order.sent = true; }

  StopDesk desk;
  IntentId last_id = 0;
};

TEST_F(StopDeskTest, TheSameScopeAskedAgainIsAtOnce) {
  EXPECT_FALSE(ask(intent::Stop(1)).at_once);
  EXPECT_TRUE(ask(intent::Stop(1)).at_once);
  EXPECT_FALSE(ask(intent::Stop(2)).at_once) << "another axis";
  EXPECT_FALSE(ask(intent::Stop()).at_once) << "the first of all";
  EXPECT_TRUE(ask(intent::Stop()).at_once);
  EXPECT_TRUE(ask(intent::Abort(3)).at_once);
}

TEST_F(StopDeskTest, AStopThatHasTakenEffectIsNoFirstOne) {
  StopOrder& first = ask(intent::Stop());
  desk.close(first);
  EXPECT_FALSE(ask(intent::Stop()).at_once);
}

TEST_F(StopDeskTest, LettingGoOfAJogIsNoFirstAndNoSecondStop) {
  intent::JogStop lets_go;
  lets_go.axis = 0;
  EXPECT_FALSE(ask(lets_go).at_once);
  EXPECT_FALSE(ask(lets_go).at_once);
  EXPECT_FALSE(ask(intent::Stop(0)).at_once);
}

TEST_F(StopDeskTest, TheLatestGoesFirstUnlessAnOlderOneCoversIt) {
  StopOrder& x = ask(intent::Stop(0));
  StopOrder& y = ask(intent::Stop(1));
  EXPECT_EQ(desk.due(), &y);
  StopOrder& all = ask(intent::Stop());
  EXPECT_EQ(desk.due(), &all);
  StopOrder& z = ask(intent::Stop(2));
  EXPECT_EQ(desk.due(), &all) << "it stops Z too";
  StopOrder& kill = ask(intent::Abort(2));
  EXPECT_EQ(desk.due(), &kill) << "harsher than what is to come";
  send(kill), send(all), send(z), send(y);
  EXPECT_EQ(desk.due(), &x);
  send(x);
  EXPECT_EQ(desk.due(), nullptr);
  desk.send_all_again();
  EXPECT_NE(desk.due(), nullptr);
}

TEST_F(StopDeskTest, EachIsFoundByItsNumberUntilItIsClosed) {
  const std::uint64_t x = ask(intent::Stop(0)).number, y = ask(intent::Stop(1)).number;
  EXPECT_LT(x, y);
  EXPECT_EQ(desk.epoch(), y);
  desk.close(*desk.find(x));
  EXPECT_EQ(desk.find(x), nullptr);
  EXPECT_EQ(desk.find(y)->axis, 1);
  EXPECT_FALSE(desk.stops_all());
}

TEST_F(StopDeskTest, ReportsWhichHasNotGoneOutAtAll) {
  StopOrder& first = ask(intent::Stop(1));
  EXPECT_FALSE(desk.another_waits(first)) << "it is alone";
  StopOrder& second = ask(intent::Stop(2));
  first.times_sent = 1;
  EXPECT_TRUE(desk.another_waits(first));
  second.times_sent = 2;
  EXPECT_FALSE(desk.another_waits(first)) << "it is said again";
  EXPECT_FALSE(desk.all_were_sent(2));
  first.times_sent = 3;
  EXPECT_TRUE(desk.all_were_sent(2));
}

TEST_F(StopDeskTest, OfTwoThatStopTheSameOneWaitsForTheOtherAtMost) {
  StopOrder& first = ask(intent::Stop(-1));
  StopOrder& second = ask(intent::Stop(-1));
  first.times_sent = second.times_sent = 1;
  second.at_once = false;
  EXPECT_EQ(desk.due(), &first);
  EXPECT_FALSE(desk.another_waits(first));
  EXPECT_FALSE(desk.another_waits(second));
  first.times_sent = 2;
  EXPECT_FALSE(desk.another_waits(second));
}

TEST_F(StopDeskTest, TheToolIsSwitchedOffBehindWhateverStops) {
  const ToolOff laser{{1, false}};
  StopOrder& tool = desk.ask_tool(laser);
  EXPECT_EQ(desk.due(), &tool);
  EXPECT_TRUE(desk.only_tool());
  StopOrder& x = ask(intent::Stop(0));
  EXPECT_EQ(desk.due(), &x);
  EXPECT_FALSE(desk.only_tool());
  EXPECT_FALSE(desk.another_waits(x)) << "its stop is given the time that it needs";
  EXPECT_TRUE(desk.another_waits(tool));
  send(x);
  x.times_sent = 1;
  EXPECT_EQ(desk.due(), &tool);
  x.sent = false;
  EXPECT_EQ(desk.due(), &tool) << "it has not gone out at all";
  send(tool);
  tool.times_sent = 1;
  EXPECT_EQ(desk.due(), &x);
  tool.sent = false;
  EXPECT_EQ(desk.due(), &x) << "sent again, it goes first again";
  EXPECT_EQ(x.tool, ToolOff());
  EXPECT_EQ(tool.tool, laser);
}

TEST_F(StopDeskTest, TheToolIsOneOrderHoweverOftenItIsAskedFor) {
  StopOrder& tool = desk.ask_tool({{1, false}});
  tool.sent = true;
  tool.times_sent = 3;
  const std::uint64_t epoch = desk.epoch();
  const std::uint64_t number = tool.number;
  StopOrder& again = desk.ask_tool({{1, false}, {2, true}});
  EXPECT_EQ(&again, &tool);
  EXPECT_EQ(desk.orders().size(), 1u);
  EXPECT_EQ(desk.due(), &tool);
  EXPECT_EQ(tool.times_sent, 0);
  EXPECT_NE(tool.number, number) << "what is on its way is not taken for it";
  EXPECT_EQ(desk.epoch(), epoch) << "nothing that waits to be started is dropped for it";
}

TEST_F(StopDeskTest, OnlyStopsAreOrders) {
  EXPECT_FALSE(stop_order_of(Intent(1, intent::MoveTo({}))).has_value());
  EXPECT_EQ(stop_order_of(Intent(1, intent::HaltProgram(2)))->thread, 2);
  EXPECT_EQ(stop_order_of(Intent(1, intent::HaltProgram(2)))->what, StopOrder::What::program);
}

}  // namespace
}  // namespace hw
