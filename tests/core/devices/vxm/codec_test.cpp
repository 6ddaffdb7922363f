#include "core/devices/vxm/codec.h"

#include <random>

#include <gtest/gtest.h>

#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/explain.h"

namespace hw::vxm {
namespace {

using Kind = Message::Kind;
constexpr auto npos = std::string_view::npos;

TEST(VxmCodec, EncodesWhatTheManualPrints) {
  EXPECT_EQ(index_by(1, Steps{400}), "I1M400\r");
  EXPECT_EQ(index_by(2, Steps{-600}), "I2M-600\r");
  EXPECT_EQ(index_to(4, Steps{-90200}), "IA4M-90200\r");
  EXPECT_EQ(index_to(1, Steps{0}), "IA1M0\r");
  EXPECT_EQ(zero_here(1), "IA1M-0\r");
  EXPECT_EQ(home(1, Sign::plus), "I1M0\r");
  EXPECT_EQ(home(2, Sign::minus), "I2M-0\r");
  EXPECT_EQ(speed(1, 500), "S1M500\r");
  EXPECT_EQ(index_pair(3, Steps{800}, 1, Steps{400}), "(I3M800,I1M400,)");
  EXPECT_EQ(output(1, true), "U5\r");
  EXPECT_EQ(output(1, false), "U4\r");
  EXPECT_EQ(output(2, true), "U15\r");
  EXPECT_EQ(output(4, false), "U18\r");
  EXPECT_EQ(select_program(1), "PM1\r");
  EXPECT_EQ(empty_program(0), "PM-0\r");
  EXPECT_EQ(ask_position(3), "Z");
  EXPECT_EQ(set_param("j1M", 1000), "setj1M1000\r");
  EXPECT_EQ(set_param("L1M", -2), "setL1M-2\r");
  EXPECT_EQ(set_param("B", 38), "setB38\r");
  EXPECT_EQ(set_param("Bx", 20), "B20\r");
  EXPECT_EQ(set_param("O", 3), "O3\r");
  EXPECT_EQ(set_param("PMA", -5), "PMA-0\r");
  EXPECT_EQ(get_param("DM"), "getDM");
  EXPECT_EQ(get_param("Bx"), "B\r");
  EXPECT_EQ(get_param("O"), "O\r");
}

TEST(VxmCodec, ReadsThePrintedReplies) {
  EXPECT_EQ(decode_position("-0001200\r"), Steps{-1200});
  EXPECT_EQ(decode_position("+0009201\r"), Steps{9201});
  EXPECT_EQ(decode_position("-000020\r"), Steps{-20});
  EXPECT_EQ(decode_position("-0200000\r"), Steps{-200000});
  EXPECT_EQ(decode_number("3\r"), 3);
  EXPECT_EQ(decode_number("-2\r"), -2);
  EXPECT_EQ(decode_state("B"), 'B');
  EXPECT_EQ(decode_text_line("1.30\r"), "1.30");
  EXPECT_EQ(decode_text_line("12-29-04\r"), "12-29-04");
  const auto listing = decode_listing("PM0 M252\rI1M400\r");
  ASSERT_TRUE(listing);
  EXPECT_EQ(listing->slot, 0);
  EXPECT_EQ(listing->free_bytes, 252);
  EXPECT_EQ(listing->commands, std::vector<std::string>{"I1M400"});
  const auto digitized = decode_digitized("X+0000201\rY-1294010\rZ+0000000\rT+0080000\r", 4);
  ASSERT_TRUE(digitized);
  EXPECT_EQ(digitized->positions[1], Steps{-1294010});
  EXPECT_EQ(digitized->positions[3], Steps{80000});
}

TEST(VxmCodec, SomethingElseIsNoReply) {
  for (const char* no : {"", "\r", "+\r", "+0000400", "0000400\r", "+00004x0\r", "+00000400\r",
                         "-1200000\r\r", "+9999999\r", "X+0000400\r"})
    EXPECT_FALSE(decode_position(no)) << no;
  for (const char* no : {"", "\r", "1", "1a\r", "--1\r", "99999999999999999999\r"})
    EXPECT_FALSE(decode_number(no)) << no;
  for (const char* no : {"", "V", "R\r", "^"}) EXPECT_FALSE(decode_state(no)) << no;
  for (const char* no : {"", "PM0\r", "PM9 M252\r", "PM0 M999\r", "I1M400\r", "PM0 M252"})
    EXPECT_FALSE(decode_listing(no)) << no;
  EXPECT_FALSE(decode_digitized("X+0000201\r", 2));
  EXPECT_FALSE(decode_digitized("X+0000201\rZ-1294010\r", 2));
}

TEST(VxmCodec, StatusBytesAreNumberedAsTheCatalogDoes) {
  EXPECT_FALSE(limit_active(255, 0, Sign::plus));
  EXPECT_TRUE(limit_active(253, 0, Sign::plus)) << "manual: limit 1+ low";
  EXPECT_FALSE(limit_active(253, 0, Sign::minus));
  EXPECT_TRUE(limit_active(0xBF, 3, Sign::minus));
  EXPECT_EQ(inputs_of(255), 255u);
  EXPECT_EQ(inputs_of(191), 255u & ~4u) << "manual: input 3 activated";
  EXPECT_EQ(inputs_of(0xFE), 255u & ~16u) << "jog 1-";
}

TEST(VxmCodec, MessagesAreDistinguished) {
  EXPECT_EQ(next_message("^").kind, Kind::prompt);
  EXPECT_EQ(next_message("O\r").kind, Kind::limit);
  EXPECT_EQ(next_message("W").kind, Kind::waits);
  EXPECT_EQ(next_message("@").kind, Kind::passed);
  EXPECT_EQ(next_message("\r").kind, Kind::end);
  EXPECT_EQ(next_message("E").kind, Kind::unfinished);
  EXPECT_EQ(next_message("EM").letter, 'M');
  EXPECT_EQ(next_message("\xC5"
                         "B")
                .letter,
            'B');
  EXPECT_EQ(next_message("EX").kind, Kind::unknown);
  EXPECT_EQ(next_message(":I1M4").kind, Kind::unfinished);
  const Message held = next_message(":I1M400\r^");
  EXPECT_EQ(held.kind, Kind::held);
  EXPECT_EQ(held.text, "I1M400");
  EXPECT_EQ(held.length, 8u);
  EXPECT_EQ(next_message(std::string(":") + std::string(100, '1')).kind, Kind::unknown);
  EXPECT_EQ(next_message("\x80").kind, Kind::unknown);
}

TEST(VxmCodec, AMessageThatCrossesAnAnswerIsNoPartOfIt) {
  EXPECT_EQ(before_number("+0000400\r"), 0u);
  EXPECT_EQ(before_number("^+0000400\r"), 1u);
  EXPECT_EQ(before_number(":I1M-1200000\r+0000400\r"), 13u) << "the number in the listing is no position";
  EXPECT_EQ(before_number(":I1M-12"), npos);
  EXPECT_EQ(before_number("E"), npos);
  EXPECT_EQ(before_state("EB"), 2u) << "the B of a bus error is no answer to V";
  EXPECT_EQ(before_state("B"), 0u);
  EXPECT_EQ(before_prompt("O^"), 1u);
}

TEST(VxmCodec, EachErrorIsExplainedWithAdvice) {
  for (const char letter : std::string_view("BMLJCNS")) {
    const ErrorWords words = explain_error(letter);
    EXPECT_NE(words.what.find(std::string("E") + letter), std::string::npos);
    EXPECT_GE(words.advice.size(), 30u);
    EXPECT_EQ(words.halts, std::string_view("MLJC").find(letter) != npos) << letter;
  }
}

// ---- text

std::string canon(std::string_view text, int motor = 1) {
  std::string all;
  for (const TextCommand& c : read_text(text, motor)) {
    constexpr std::string_view flaws = " ?#!~";
    all += (all.empty() ? "" : " ") + canonical(c);
    if (c.flaw != Flaw::none) all += flaws[static_cast<int>(c.flaw)];
  }
  return all;
}

TEST(VxmText, ReadsWhatPeopleWrite) {
  EXPECT_EQ(canon("E I1M400,R"), "E I1M400 R");
  EXPECT_EQ(canon("C I3M400,R"), "C I3M400 R");
  EXPECT_EQ(canon("CS1M1000,R"), "C S1M1000 R");
  EXPECT_EQ(canon("A2,S4000,I400,"), "A1M2 S1M4000 I1M400");
  EXPECT_EQ(canon("I2M200,I-200,S2000,IA0,"), "I2M200 I2M-200 S2M2000 IA2M0");
  EXPECT_EQ(canon("I400\r", 3), "I3M400");
  EXPECT_EQ(canon("I1M400 ;one turn\rI1M0 ; home, or not\r"), "I1M400 I1M0");
  EXPECT_EQ(canon("I1M2000, I2M300, L-4, LM0, LM-0, LA5\r"), "I1M2000 I2M300 L-4 LM0 LM-0 LA5");
  EXPECT_EQ(canon("(I3M800,I1M400,)R"), "( I3M800 I1M400 ) R");
  EXPECT_EQ(canon("PM-0\r\nIA1M-0,U5,P-500,PA0,JM-1,J3,SA1M-12\r\n"),
            "PM-0 IA1M-0 U5 P-500 PA0 JM-1 J3 SA1M-12");
  EXPECT_EQ(canon("P10.0\r"), "P10 0?") << "the period ends the number, the orphan 0 means nothing";
  EXPECT_EQ(canon("getM1MsetM1M3\rgetD0getPA setPA4\rsetjA2M0\rB20\rB\rO\rPMA-0\rPMA\r"),
            "getM1M setM1M3 getD0 getPA setPA4 setjA2M0 B20 B O PMA-0 PMA");
  EXPECT_EQ(canon("lst rsm res del"), "lst rsm res del");
}

TEST(VxmText, FindsWhatIsWrong) {
  EXPECT_EQ(canon("S2M8000\r"), "S2M8000!");
  EXPECT_EQ(canon("I5M100\r"), "I5M100!");
  EXPECT_EQ(canon("U10\r U106\r L1\r A0\r PM5\r setM1M7\r setB10\r setl1M1\r"),
            "U10! U106! L1! A1M0! PM5! setM1M7! setB10! set? l? 1? M 1?");
  EXPECT_EQ(canon("I1M,\r"), "I1M0#");
  EXPECT_EQ(canon("%"), "%?");
  EXPECT_EQ(canon("I1M40"), "I1M40~");
  const auto res = read_text("Jres");
  ASSERT_EQ(res.size(), 2u) << "a dangling letter is abandoned, the rest read afresh";
  EXPECT_EQ(res[0].flaw, Flaw::unknown);
  EXPECT_EQ(res[1].name, "res");
}

TEST(VxmText, KnowsWhenTheControllerStillWaitsForAnEnd) {
  for (const char* open :
       {"I1M400", "I1", "I", "PM", "B", "set", "getM1", "ls", "R I1M4", "U5 ;remark", ";", "I1M4x"})
    EXPECT_TRUE(ends_open(open)) << open;
  for (const char* closed :
       {"", "X", "I1M400,", "I1M400\r", "I1M400,R", "getM1M", "lst", "PM\r", "(I3M1,I1M1,)", "%"})
    EXPECT_FALSE(ends_open(closed)) << closed;
}

TEST(VxmText, CountsTheBytesOfTheManualsExamples) {
  const auto cost = [](std::string_view text) {
    int sum = 0;
    for (const TextCommand& c : read_text(text)) sum += program_cost(c);
    return sum;
  };
  EXPECT_EQ(cost("I1M400,R"), 4);
  EXPECT_EQ(cost("P10,I1M400,L10,I1M-3600,R"), 14);
  EXPECT_EQ(cost("S1M600,I1M0,I1M-200,IA1M-0,R"), 15);
  EXPECT_EQ(cost("I1M2000, U1, I2M1000, U1, LM-3, L0, R"), 14);
  EXPECT_EQ(cost("I1M2000, I2M300, L-4, LM0, I2M600, I1M3000, L-3, IA2M0\r"), 27);
  EXPECT_EQ(cost("I3M2000, I3M-2000, I1M1600, L5, I2M400, L-3, IA1M0, IA2M0\r"), 30);
  EXPECT_EQ(cost("U91\r"), 6);
}

TEST(VxmText, AnyBytesAreReadToTheirEnd) {
  std::mt19937 random(1);
  constexpr std::string_view likely = "ISALJPUMBOsetgrmdlK(){}[]0123456789-,.\r\n ;%\xC5\xFF";
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (unsigned n = random() % 24; n > 0; --n) text += likely[random() % likely.size()];
    std::size_t at = 0;
    for (const TextCommand& c : read_text(text)) {
      ASSERT_GE(c.begin, at) << text;
      ASSERT_GT(c.end, c.begin) << text;
      ASSERT_LE(c.end, text.size()) << text;
      at = c.end;
    }
    (void)explain(text, Way::sent, TrafficKind::intent, "");
    for (const char* asked : {"X", "V", "?", "M", "lst", "getM1M"})
      (void)explain(text, Way::received, TrafficKind::poll, asked);
    (void)decode_listing(text), (void)decode_digitized(text, 4);
    if (!text.empty() && next_message(text).length > text.size()) FAIL() << text;
  }
}

}  // namespace
}  // namespace hw::vxm
