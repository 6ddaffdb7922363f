// How text becomes commands: separators, numbers, lists, mistakes (decisions M12 to M16).
#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {

TEST(Vme58Text, CommandsNeedNoSeparatorsAndTakeAny) {
  for (const char* text : {"AXLP123RP", "AX LP123 RP", "AX;LP123;RP", "AX\r\nLP123\r\nRP\r\n", "AX,LP123,RP,",
                           "  AX   LP 123\nRP;;;", "AX LP123.999 RP"}) {
    Rig rig;
    EXPECT_EQ(rig.value(text), "123") << visible(text);
    EXPECT_FALSE(rig.command_error()) << visible(text);
  }
}

TEST(Vme58Text, AStartUpOfAHostParses) {
  Rig rig;
  EXPECT_EQ(visible(rig.ask("AX LNAX HLAX VL1000AX VB100AX AC500AX RP")), "<lf><cr>0<lf><cr>");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 1000);
  EXPECT_EQ(rig.axis_value('X', AxisValue::base_velocity), 100);
  EXPECT_EQ(rig.axis_value('X', AxisValue::acceleration), 500);
}

TEST(Vme58Text, UnknownTextIsDroppedAndTheRestWorks) {
  Rig rig;
  rig.send("AX KK2 ID ");  // a filter coefficient of other firmware
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.done(), bit_of('X'));
  for (const char* text :
       {"QQ5,6,7; LP9 ", "xy LP9 ", "5 LP9 ", "LPabc LP9 ", "M LP9 ", "\x01LP9 ", "LP9 QQ "}) {
    rig.send("LP0 ");
    rig.send(text);
    EXPECT_TRUE(rig.command_error()) << text;
    EXPECT_EQ(rig.position('X'), 9) << text;
  }
}

TEST(Vme58Text, LettersAreUpperCase) {
  Rig rig;
  rig.send("ax lp5 ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.position('X'), 0);
}

TEST(Vme58Text, NumbersThatAreNone) {
  Rig rig;
  for (const char* text : {"LP- ", "LP. ", "LP1.2.3 ", "LP--5 ", "LP5- ", "LP+5 ", "LP;", "LP\r", "LP 1 2 ",
                           "LP1e3 ", "LP99999999999999999999999999999999999999999999999999 "}) {
    rig.send(std::string("AX LP0 ") + text + "\r");
    EXPECT_TRUE(rig.command_error()) << text;
  }
  rig.send("LP-.5 ");
  EXPECT_FALSE(rig.command_error());
}

TEST(Vme58Text, ListsEndWithTheLineASemicolonOrTheNextLetter) {
  for (const char* end : {";", "\r", "\n", "RP"}) {
    Rig rig;
    rig.send(std::string("AA LP1,,3") + end);
    EXPECT_FALSE(rig.command_error());
    EXPECT_EQ(rig.value("RP").substr(0, 6), "1,0,3,") << visible(end);
  }
  Rig rig;
  rig.send("AA LP1, 2 , 3;");
  EXPECT_EQ(rig.value("RP").substr(0, 6), "1,2,3,") << "spaces do not end a list";
  rig.send("LP1 2;");
  EXPECT_TRUE(rig.command_error());
  rig.send("LP,,;");
  EXPECT_TRUE(rig.command_error()) << "nothing given";
  rig.send("LP1,2,3,4,5,6,7,8,9;");
  EXPECT_TRUE(rig.command_error()) << "nine axes";
}

TEST(Vme58Text, OneWrongPlaceDropsTheWholeList) {
  Rig rig;
  rig.send("AA LP5,99999999,7; ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.value("RP"), "0,0,0,0,0,0,0,0");
  Rig small = Rig::model("4");
  small.send("AA LP1,2,3,4,5; ");
  EXPECT_TRUE(small.command_error()) << "an axis that is not there";
  EXPECT_EQ(small.value("RP"), "0,0,0,0");
}

TEST(Vme58Text, RangesAreThePrintedOnes) {
  Rig rig;
  for (const char* bad : {"AC8000001", "AC-1", "VL1044001", "VB-1", "LP33500001", "LP-33500001", "MA33500001",
                          "MR67000001", "JG1044001", "KP-1", "KN16", "KN-1", "HM33500001", "SP33500001",
                          "MV0,1044001", "LS-1", "ER0,1", "ER1,0", "RM0"}) {
    rig.send(std::string("AX ") + bad + "\r");
    EXPECT_TRUE(rig.command_error()) << bad;
  }
  EXPECT_EQ(rig.value("RC"), "2000000") << "the old value stays (decision M67)";
  EXPECT_EQ(rig.room('X'), queue_entries);
  for (const char* good :
       {"AC8000000", "VL1044000", "VB1044000", "LP33500000", "LP-33500000", "KN15", "KO-3"}) {
    rig.send(std::string("AX ") + good + "\r");
    EXPECT_FALSE(rig.command_error()) << good;
  }
}

TEST(Vme58Text, ACommandCutInTwoByTheHostWaitsForItsRest) {
  Rig rig;
  for (const char c : std::string("AX LP12345 RP")) rig.send(std::string(1, c));
  EXPECT_EQ(rig.output(), framed("12345"));
  rig.send("VL70");
  rig.run_for(1s);
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), default_velocity);
  rig.send("00 ");
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 7000);
}

TEST(Vme58Text, EncoderCommandsNeedAnEncoder) {
  Rig rig = Rig::model("4");
  EXPECT_EQ(rig.ask("AX EA ID "), "");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.done(), bit_of('X')) << "the ID behind it works";
  for (const char* text :
       {"ER1,1", "HV1", "HG1", "HD1", "HN", "HF", "ES1", "TN", "TF", "IS", "ET", "HE", "HS", "RE"}) {
    rig.send(std::string("AX ") + text + "\r");
    EXPECT_TRUE(rig.command_error()) << text;
  }
  Rig mixed = Rig::model("2S2");
  EXPECT_NE(mixed.value("AY EA"), "");
  EXPECT_EQ(mixed.ask("AZ EA"), "");
  EXPECT_TRUE(mixed.command_error());
  mixed.send("AX KP2 ");
  EXPECT_FALSE(mixed.command_error());
  mixed.send("AZ KP2 ");
  EXPECT_TRUE(mixed.command_error()) << "gains are those of servo axes";
}

}  // namespace hw::vme58::proof
