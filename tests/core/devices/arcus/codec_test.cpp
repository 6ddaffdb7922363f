// The codec against the exchanges that the manuals print (PMX ch. 8, DMX ch. 7 and 8).
#include "core/devices/arcus/codec.h"

#include <gtest/gtest.h>

#include "core/devices/arcus/explain.h"
#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/facts.h"
#include "core/devices/dmx_k_sa/forms.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/facts.h"
#include "core/devices/pmx_4ex_sa/forms.h"

namespace hw::arcus {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

const Forms& pmx_forms() { return pmx_4ex_sa::forms(); }
const Forms& dmx_forms() { return dmx_k_sa::forms(); }

ParamInfo param(const Catalog& catalog, std::string_view name) {
  return catalog.params.at(static_cast<std::size_t>(catalog.find_param(name)));
}

TEST(ArcusCodec, ACommandBeginsWithTheAddressAndEndsWithCarriageReturn) {
  EXPECT_EQ(frame(Framing::addressed, 1, "EX"), "@01EX\r");
  EXPECT_EQ(frame(Framing::addressed, 0, "POX"), "@00POX\r");
  EXPECT_EQ(frame(Framing::addressed, 1, "J+"), "@01J+\r");
  EXPECT_EQ(frame(Framing::addressed, 1, "@05PX"), "@05PX\r")
      << "a text for another device keeps its address";
  EXPECT_EQ(frame(Framing::message, 1, "EX"), "EX") << "USB has no address and no end";
}

TEST(ArcusCodec, RepliesEndWithEitherTerminatorAndMayBeginWithTheAddress) {
  EXPECT_EQ(decode_reply("1000\0"sv).text, "1000");
  EXPECT_EQ(decode_reply("OK\r"sv).text, "OK");
  EXPECT_FALSE(decode_reply("OK\0"sv).id);
  const Reply second = decode_reply("#011000\0"sv);
  EXPECT_EQ(second.text, "1000");
  EXPECT_EQ(second.id, 1);
  EXPECT_EQ(decode_reply("#01OK\0"sv).text, "OK");
  EXPECT_TRUE(decode_reply("#01?Moving\0"sv).refused());
  EXPECT_EQ(decode_reply("Performax-4EX-SA"s + std::string(48, '\0')).text, "Performax-4EX-SA");
  EXPECT_EQ(decode_reply("\n7\r"sv).text, "7") << "a stray line feed";
  EXPECT_EQ(decode_reply("\r"sv).text, "") << "an unused line of the program";
}

TEST(ArcusCodec, TheAutomaticMessageDiffersFromReplies) {
  EXPECT_EQ(unsolicited_at_front("$01P\r"), 5u);
  EXPECT_EQ(unsolicited_at_front("$01P\r1000\0"sv), 5u);
  EXPECT_EQ(unsolicited_at_front("$01"), std::string_view::npos) << "the rest may come";
  EXPECT_EQ(unsolicited_at_front("1000\0"sv), 0u);
  EXPECT_EQ(unsolicited_at_front("$x"), 0u);
  EXPECT_EQ(in_position("$07P\r"), 7);
  EXPECT_FALSE(in_position("$07Q\r"));
}

TEST(ArcusCodec, ADeviceNameDiffersFromOtherReplies) {
  const Model& dmx = *dmx_forms().model;
  EXPECT_EQ(number_in_name(dmx, "DMK07"), 7);
  EXPECT_EQ(number_in_name(dmx, "4EX07"), std::nullopt);
  EXPECT_EQ(number_in_name(dmx, "DMK7"), std::nullopt);
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "DMK07\0001000\0"sv), 6u);
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "#07DMK07\0"sv), 9u);
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "$01P\r"), 5u);
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "DM"), std::string_view::npos) << "the rest may come";
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "1000\0"sv), 0u);
  EXPECT_EQ(unsolicited_or_name_at_front(dmx, "DriveMax-K-SA\0"sv), 0u);
  EXPECT_EQ(unsolicited_or_name_at_front(*pmx_forms().model, "4\r"), 0u) << "a number may begin like a name";
}

TEST(ArcusCodec, StatusOfAllAxesInOneLine) {
  const auto words = decode_numbers("0:1:64:0:1:3:9:30:0", 9);
  ASSERT_TRUE(words);
  EXPECT_EQ((*words)[2], 64);
  EXPECT_EQ((*words)[7], 30);
  EXPECT_EQ(decode_numbers("-5:0:7:100", 4)->front(), -5);
  EXPECT_TRUE(decode_numbers("1:2:3:4:", 4)) << "a colon behind the last field";
  EXPECT_FALSE(decode_numbers("1:2:3", 4));
  EXPECT_FALSE(decode_numbers("1:x:3:4", 4));
  EXPECT_FALSE(decode_numbers("", 1));
  EXPECT_FALSE(decode_number("12\x91"));
}

TEST(ArcusCodec, ValuesAreWrittenAsTheControllerReadsThem) {
  const Catalog p = *pmx_4ex_sa::make_catalog({}), d = *dmx_k_sa::make_catalog({});
  EXPECT_EQ(set_command(param(p, "HSX"), 1500), "HSX=1500");
  EXPECT_EQ(set_command(param(p, "SLRX"), 800), "SLRX=0.800");
  EXPECT_EQ(set_command(param(p, "SLRU"), 12345), "SLRU=12.345");
  EXPECT_EQ(set_command(param(p, "DN"), 7), "DN=4EX07");
  EXPECT_EQ(set_command(param(d, "DN"), 99), "DN=DMK99");
  EXPECT_EQ(set_command(param(d, "SYNP"), -3000), "SYNP=-3000");
  EXPECT_EQ(decode_value(param(p, "SLRX"), "0.800"), 800);
  EXPECT_EQ(decode_value(param(p, "SLRX"), "1"), 1000);
  EXPECT_EQ(decode_value(param(d, "DN"), "DMK07"), 7);
  EXPECT_FALSE(decode_value(param(d, "DN"), "4EX07"));
  EXPECT_FALSE(decode_value(param(p, "SLRX"), "0.8x0"));
  EXPECT_FALSE(decode_value(param(p, "HS"), "?HS"));
}

TEST(ArcusCodec, EachModelSpellsItsOwnWay) {
  EXPECT_EQ(fill(pmx_forms(), pmx_forms().jog, 0, Sign::plus), "JX+");
  EXPECT_EQ(fill(dmx_forms(), dmx_forms().jog, 0, Sign::minus), "J-");
  EXPECT_EQ(fill(pmx_forms(), pmx_forms().homes[4], 3, Sign::minus), "HU-4");
  EXPECT_EQ(fill(dmx_forms(), dmx_forms().homes[4], 0, Sign::plus), "HL+");
  EXPECT_EQ(fill(dmx_forms(), dmx_forms().homes[2], 0, Sign::plus), "ZH+");
  EXPECT_EQ(fill(pmx_forms(), pmx_forms().change_speed, 0, Sign::plus, 3000), "SSPDX=3000");
  EXPECT_EQ(fill(dmx_forms(), dmx_forms().change_speed, 0, Sign::plus, 3000), "SSPD3000") << "no equal sign";
  EXPECT_EQ(fill(pmx_forms(), pmx_forms().change_target, 1, Sign::plus, -500), "TY-500");
  EXPECT_EQ(move_command(pmx_forms(), {{0, 1000}, {3, 800}}), "X1000U800");
  EXPECT_EQ(move_command(dmx_forms(), {{0, -1000}}), "X-1000");
}

TEST(ArcusCodec, CommandsThatMoveAreRecognised) {
  for (const char* text : {"X1000", "X-5", "X1000Y1000", "JX+", "HX+0", "TX500", "SR0=1", "GS1", "CIRP0:0",
                           "ARCN0:0:1:2", "I1:2:3:4", "SSPDX=300", "JE=1"})
    EXPECT_TRUE(may_move(pmx_forms(), text)) << text;
  for (const char* text : {"J+", "H+", "HL-", "L+", "Z+", "ZH-", "T100", "SSPD300"})
    EXPECT_TRUE(may_move(dmx_forms(), text)) << text;
  for (const char* text :
       {"",   "MST",  "PX",     "PX=0",  "EX=5",  "HS=100", "LSX=3",   "STOP",       "ABORT", "ID",
        "DN", "IERR", "IACC=1", "TOC=5", "LTX=1", "TR=100", "JV1=100", "JMAXX=4500", "SLX=1", "HSX"})
    EXPECT_FALSE(may_move(pmx_forms(), text)) << text;
  for (const char* text : {"HSPD=1000", "LSPD", "LT=1", "LTE", "HCA=10", "LCA", "TOC", "SYNO"})
    EXPECT_FALSE(may_move(dmx_forms(), text)) << text;
}

TEST(ArcusCodec, EveryRefusalOfTheManualsIsExplained) {
  for (const Model* model : {&pmx_4ex_sa::model, &dmx_k_sa::model})
    for (const std::string_view reply : model->refusals) {
      if (!reply.starts_with('?')) continue;
      const std::string words = explain_refusal(*model, reply);
      EXPECT_GE(words.size(), 25u) << reply;
      EXPECT_NE(words, explain_refusal(*model, "?FOO")) << reply;
    }
}

TEST(ArcusExplain, ExplainsTraffic) {
  const auto known = pmx_4ex_sa::command_help();
  const auto sent = [&](std::string_view bytes) {
    return explain(pmx_4ex_sa::model, known, bytes, Way::sent, TrafficKind::intent, {});
  };
  const auto came = [&](std::string_view bytes, std::string_view asked) {
    return explain(pmx_4ex_sa::model, known, bytes, Way::received, TrafficKind::intent, asked);
  };
  EXPECT_EQ(sent("@00JX+\r"), "to 00: runs one axis in the given direction until stopped");
  EXPECT_EQ(sent("@00FOO\r"), "to 00: not a command of the manual");
  EXPECT_EQ(came("OK\r", "@00JX+\r"), "done");
  EXPECT_EQ(came("?PULSING\r", "@00X5\r"),
            "refused: an axis of the command is moving, or under the joystick: stop it, or wait until it is "
            "at rest");
  EXPECT_EQ(came("1:0:144:0:0:0:0:36:0\r", "@00MST\r"),
            "X accelerating; Y at rest; Z at rest, + limit switch on, + limit error; U at rest");
  const auto dmx_known = dmx_k_sa::command_help();
  EXPECT_EQ(explain(dmx_k_sa::model, dmx_known, "$01P\r", Way::received, TrafficKind::unsolicited, {}),
            "device 01 is in position");
  EXPECT_EQ(explain(dmx_k_sa::model, dmx_known, "9\0"sv, Way::received, TrafficKind::poll, "@01MST\r"),
            "X at speed, home switch on")
      << "the manual's example";
  EXPECT_EQ(explain(dmx_k_sa::model, dmx_known, "@00STOP\r", Way::sent, TrafficKind::stop, {}),
            "to all devices, no reply: ramps down to low speed and stops");
}

}  // namespace
}  // namespace hw::arcus
