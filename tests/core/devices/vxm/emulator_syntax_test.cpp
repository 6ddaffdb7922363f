// How the VXM reads its line: separators, rejection and recovery (V03 to V13; manual p.8, 9, 16).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {

TEST(VxmSyntax, CarriageReturnCommaAndPeriodEndACommand) {
  for (const char ender : {'\r', ',', '.'}) {
    Rig rig = Rig::online();
    rig.send(std::string("I1M400") + ender);
    EXPECT_EQ(rig.used_bytes(), 4) << int{ender};
  }
  for (const char not_an_ender : {' ', '\n', '\t', '\0'}) {
    Rig rig = Rig::online();
    rig.send(std::string("I1M400") + not_an_ender);
    EXPECT_EQ(rig.ask("M,"), "") << int{not_an_ender}
                                 << ": the value is still open, so M is a wrong character";
    EXPECT_EQ(rig.used_bytes(), 0) << int{not_an_ender};
  }
}

TEST(VxmSyntax, BlanksLineFeedsAndNulsAreDroppedAnywhere) {
  Rig rig = Rig::online();
  rig.send(std::string("I 1\tM\n4 0\0 0 ,\nP 1 0,", 21));
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M249<cr>I1M400<cr>P10<cr>");
  EXPECT_EQ(rig.ask("l s\nt").substr(0, 3), "PM0");
}

TEST(VxmSyntax, AnEnderWithNothingPendingDoesNothing) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("\r\r,,..\r\n\r\n"), "");
  EXPECT_EQ(rig.used_bytes(), 0);
  rig.send("I1M400,,\r.\r\n,I2M5.");
  EXPECT_EQ(rig.used_bytes(), 8);
}

TEST(VxmSyntax, LettersActAtOnceAmongOtherCommands) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("CVI1M400,MVX"), "R252\rR+0000000\r");
  EXPECT_EQ(visible(rig.ask("lstdellst")), "PM0 M252<cr>I1M400<cr>PM0 M256<cr>");
}

TEST(VxmSyntax, FormsThatCouldGrowWaitForTheirEnder) {
  Rig rig = Rig::online_with_slave();
  for (const char* form : {"PM", "PMA", "B", "O"}) {
    EXPECT_EQ(rig.ask(form), "") << form;
    EXPECT_NE(rig.ask("."), "") << form;
    rig.send(",");
    rig.output();
  }
  EXPECT_EQ(rig.ask("getB"), "") << "no such form";
  EXPECT_EQ(rig.ask("getM1M"), "0\r") << "complete with its last letter";
}

TEST(VxmSyntax, UnknownCharactersAtTheStartAreDropped) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("^=+-/0123456789abcfhijkmnopqtuvwz\"'<>\x7F\x80\xFF"), "");
  rig.send(",");
  EXPECT_EQ(rig.ask("V"), "R");
  EXPECT_EQ(rig.used_bytes(), 0);
}

TEST(VxmSyntax, AWrongCharacterBeforeADigitStartsAfresh) {
  Rig rig = Rig::online();
  rig.send("II1M400,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
  EXPECT_EQ(rig.ask("IV"), "R");
  EXPECT_EQ(rig.ask("SAX"), "+0000000\r");
  EXPECT_EQ(rig.ask("rst\nV"), "R");
  EXPECT_EQ(rig.ask("gV"), "R");
  rig.send("CPP10,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M253<cr>P10<cr>");
  rig.send("Jres");
  EXPECT_EQ(rig.ask("V"), "J") << "Jres resets";
}

TEST(VxmSyntax, AWrongCharacterBehindADigitDropsUpToTheEnder) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("I1M4X00VV,"), "");
  EXPECT_EQ(rig.used_bytes(), 0);
  EXPECT_EQ(rig.ask("P1V."), "");
  rig.send("I1M5,");
  EXPECT_EQ(rig.used_bytes(), 4) << "and is well again behind it";
  rig.send("CU5U5\rP2P2\rP3,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M253<cr>P3<cr>");
}

TEST(VxmSyntax, CaseMatters) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("v"), "");
  rig.send("i1m400,I1m400,seti3,setp1m4,p10,u5,");
  rig.send(",");
  rig.output();
  EXPECT_EQ(rig.used_bytes(), 0);
  EXPECT_EQ(rig.ask("getI"), "7\r");
}

TEST(VxmSyntax, MinusZeroIsAFormOfItsOwnAndPlusIsNothing) {
  Rig rig = Rig::online();
  rig.send("IA1M0,IA1M-0,LM0,LM-0,I1M-00,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M242<cr>IA1M0<cr>IA1M-0<cr>LM0<cr>LM-0<cr>I1M-0<cr>");
  rig.send("CI1M+400,");
  EXPECT_EQ(rig.used_bytes(), 0);
  rig.send("I1M0400,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
}

TEST(VxmSyntax, AMissingNumberStoresNothing) {
  Rig rig = Rig::online();
  rig.send("I1M,S,A,L,LA,LM,J,JM,P,PA,U,IA,SA,I1M-,I,P-,setM1M,setB,setI,setj1M,");
  EXPECT_EQ(visible(rig.output()), "");
  EXPECT_EQ(rig.used_bytes(), 0);
}

TEST(VxmSyntax, EndlessNumbersAreOutOfRangeNotSmall) {
  Rig rig = Rig::online();
  rig.send("I1M" + std::string(300, '9') + ",P4294967297,L18446744073709551618,setI256,PM4294967297,");
  EXPECT_EQ(rig.used_bytes(), 0);
  EXPECT_EQ(rig.ask("PM,"), "0\r");
  rig.send("I1M" + std::string(300, '0') + "7,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M7<cr>");
}

TEST(VxmSyntax, CommandsMayComeByteByByte) {
  Rig rig = Rig::online();
  for (const char c : std::string("S1M1000,I1M400,R")) {
    rig.emulator().receive(std::string_view(&c, 1));
    rig.run_for(1ms);
  }
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(1), 400);
}

TEST(VxmSyntax, WhileAProgramRunsOnlyAFewLettersCount) {
  Rig rig = Rig::online();
  rig.send("I2M1,C");
  rig.send("P10,R");
  EXPECT_EQ(rig.ask("I1M5,R,C,N,M,x,y,#,lst,del,rsm,Q,PM1,getI,setI3,[I1M1,](I3M1,I1M1,)"), "");
  EXPECT_EQ(rig.ask("VXY"), "B+0000000\r+0000000\r");
  EXPECT_EQ(rig.ask("?~$"), std::string("\xFF\xFF\0", 3));
  EXPECT_EQ(rig.ask("*@"), "+0000000\r512\r");
  EXPECT_TRUE(rig.run_until_output("^", 2s));
  rig.output();
  EXPECT_EQ(rig.ask("V"), "R") << "nothing was queued";
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M253<cr>P10<cr>");
  EXPECT_EQ(rig.ask("getI"), "7\r");
}

TEST(VxmSyntax, LocalModeTakesSevenLettersOnly) {
  Rig rig;
  EXPECT_EQ(rig.ask("XYZT?~$@*#M!KHCRlst"), "");
  EXPECT_EQ(rig.ask("VDV"), "JX+0000000\rY+0000000\rJ");
  rig.send("I1M400,");
  rig.send("F");
  EXPECT_EQ(rig.used_bytes(), 0);
}

TEST(VxmSyntax, ThereIsNoMotorZero) {
  Rig rig = Rig::online();
  rig.send("I2M5,I0M1,S0M5,A0M5,IA0M1,SA0M5,setM0M4,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I2M5<cr>");
  EXPECT_EQ(rig.ask("#"), "2\r") << "what is dropped changes no motor";
}

TEST(VxmSyntax, BehindTheDigitOfSetD0AllIsLostUpToTheEnder) {
  Rig rig = Rig::online();
  rig.send("I1M5,");
  EXPECT_EQ(rig.ask("setD0V"), "");
  EXPECT_EQ(rig.ask(",V"), "R");
  EXPECT_EQ(rig.used_bytes(), 4) << "and nothing was erased";
}

}  // namespace hw::vxm::proof
