#include "transports/telnet.h"

#include <gtest/gtest.h>

namespace hw::telnet {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string out;
  for (const int v : values) out += static_cast<char>(v);
  return out;
}

TEST(Telnet, DataPassesAndIacIsDoubled) {
  std::string wire;
  escape(bytes({1, 255, 2}), wire);
  EXPECT_EQ(wire, bytes({1, 255, 255, 2}));
  Receiver receiver;
  std::string data, reply;
  for (const char c : wire) receiver.take(std::string_view(&c, 1), data, reply);  // cut anywhere
  EXPECT_EQ(data, bytes({1, 255, 2}));
  EXPECT_EQ(reply, "");
}

TEST(Telnet, KnowsWhetherTheServerLetsItsPortBeSet) {
  Receiver yes, no;
  std::string data, reply;
  yes.take(bytes({iac, do_, com_port}), data, reply);
  no.take(bytes({iac, dont, com_port}), data, reply);
  EXPECT_EQ(yes.word().com_port, true);
  EXPECT_EQ(no.word().com_port, false);
  EXPECT_EQ(data + reply, "");
}

TEST(Telnet, ReadsConfirmations) {
  Receiver receiver;
  std::string data, reply;
  receiver.take(bytes({'a', iac, sb, 44, 101, 0, 0, 0x96, 0, iac, se, 'b'}), data, reply);
  EXPECT_EQ(receiver.word().baud, 38400);
  receiver.take(bytes({iac, sb, 44, 102, 8, iac, se, iac, sb, 44, 103, 1, iac, se}), data, reply);
  EXPECT_FALSE(receiver.word().settings_complete());
  receiver.take(bytes({iac, sb, 44, 104, 1, iac, se}), data, reply);
  EXPECT_TRUE(receiver.word().settings_complete());
  EXPECT_EQ(data, "ab");
}

TEST(Telnet, ModemStatesAreNoData) {
  Receiver receiver;
  std::string data, reply;
  receiver.take(bytes({iac, sb, 44, 107, 0xB0, iac, se, 'x'}), data, reply);
  EXPECT_EQ(data, "x");
}

TEST(Telnet, OtherOptionsAreDeclinedOnce) {
  Receiver receiver;
  std::string data, reply;
  receiver.take(bytes({iac, will, 1, iac, do_, 24}), data, reply);
  EXPECT_EQ(reply, bytes({iac, dont, 1, iac, wont, 24}));
  reply.clear();
  receiver.take(bytes({iac, will, 1, iac, do_, 24, iac, wont, 1, iac, dont, 24}), data, reply);
  EXPECT_EQ(reply, "");
}

TEST(Telnet, RatesWithAByteOf255AreEscaped) {
  std::string wire;
  ask_rate(0xFF00, wire);
  EXPECT_EQ(wire, bytes({iac, sb, 44, 1, 0, 0, 255, 255, 0, iac, se}));
}

TEST(Telnet, ARunawaySuboptionIsBounded) {
  Receiver receiver;
  std::string data, reply;
  receiver.take(bytes({iac, sb, 44}) + std::string(1'000'000, 'x') + bytes({iac, se, 'y'}), data, reply);
  EXPECT_EQ(data, "y");
}

}  // namespace
}  // namespace hw::telnet
