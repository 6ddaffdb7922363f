// Rows of status requests, with the exact bytes of the replies.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

VME58_FORM("vme58.query.WY") {
  Rig rig;
  EXPECT_EQ(visible(rig.ask("WY")), "<lf><cr>VME58 ver 2.24-8S<lf><cr>") << "without any end of line";
  for (const Variant& v : variants)
    EXPECT_EQ(Rig::model(std::string(v.name)).value("WY"), "VME58 ver 2.24-" + std::string(v.name));
  EXPECT_EQ(Rig(DeviceOptions{{"firmware", "2.35"}}).value("WY"), "VME58 ver 2.35-8S");
  EXPECT_EQ(Rig::model("4s4").value("WY"), "VME58 ver 2.24-4S4") << "names in any case";
}

VME58_FORM("vme58.query.RP") {
  Rig rig;
  rig.send("AX LP-33500000 AS LP5 ");
  EXPECT_EQ(rig.ask("AX RP"), framed("-33500000"));
  EXPECT_EQ(rig.ask("AA RP"), framed("-33500000,0,0,0,0,0,0,5"));
  EXPECT_EQ(rig.ask("AM RP"), framed("-33500000,0,0,0,0,0,0,5"));
}

VME58_FORM("vme58.query.RQ") {
  Rig rig;
  EXPECT_EQ(rig.ask("AX RQ"), framed("200"));
  rig.send("WT1000 MR400 GO ");
  EXPECT_EQ(rig.value("RQ"), "195") << "commands and operands count (decision M18)";
  EXPECT_EQ(rig.value("AY RQ"), "200") << "a queue for each axis";
  EXPECT_EQ(rig.value("AA RQ"), "200");
  rig.send("WT1000 MR1,2,3; ");
  EXPECT_EQ(rig.value("RQ"), "194");
  EXPECT_EQ(rig.value("AM RQ"), "200") << "AM has one of its own (decision M20)";
  rig.run_for(10s);
  EXPECT_EQ(rig.value("AX RQ"), "200");
}

VME58_FORM("vme58.query.RA") {
  Rig rig;
  EXPECT_EQ(visible(rig.ask("AX RA")), "<lf><cr><cr>PNNN<lf><cr><cr>");
  rig.send("MR-100 GO ID ");
  rig.run_for(1s);
  rig.limit('X', '-', true);
  rig.home_switch('X', true);
  EXPECT_EQ(rig.value("RA"), "MDLH");
  EXPECT_EQ(rig.value("RA"), "MNLH") << "the done flag is cleared";
  EXPECT_EQ(rig.done(), 0);
}

VME58_FORM("vme58.query.RI") {
  Rig rig;
  rig.send("AY MR-1 GO ID AS ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("RI"), status_framed("PNNN,MDNN,PNNN,PNNN,PNNN,PNNN,PNNN,PDNN"));
  EXPECT_EQ(rig.ask("RI"), status_framed("PNNN,MNNN,PNNN,PNNN,PNNN,PNNN,PNNN,PNNN"));
  EXPECT_EQ(rig.done(), 0);
  EXPECT_EQ(Rig::model("4").value("RI"), "PNNN,PNNN,PNNN,PNNN");
}

VME58_FORM("vme58.query.QA") {
  Rig rig;
  rig.send("AZ ID ");
  EXPECT_EQ(rig.ask("QA"), status_framed("PDNN"));
  EXPECT_EQ(rig.ask("QA"), status_framed("PDNN")) << "nothing is cleared";
  EXPECT_EQ(rig.done(), bit_of('Z'));
}

VME58_FORM("vme58.query.QI") {
  Rig rig;
  rig.send("AX ID ");
  rig.home_switch('U', true);
  const std::string all = "PDNN,PNNN,PNNN,PNNN,PNNH,PNNN,PNNN,PNNN";
  EXPECT_EQ(rig.ask("AA QI"), status_framed(all));
  EXPECT_EQ(rig.ask("QI"), status_framed(all));
  EXPECT_EQ(rig.done(), bit_of('X'));
}

VME58_FORM("vme58.query.RC") {
  Rig rig;
  EXPECT_EQ(rig.ask("AX RC"), framed("2000000")) << "decision M47";
  rig.send("AC8000000 AY AC0 ");
  EXPECT_EQ(rig.value("AX RC"), "8000000");
  EXPECT_EQ(rig.value("AA RC"), "8000000,0,2000000,2000000,2000000,2000000,2000000,2000000");
}

VME58_FORM("vme58.query.RV") {
  Rig rig;
  EXPECT_EQ(rig.ask("AX RV"), framed("0"));
  rig.send("AX JG-2500 AZ JG30 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.value("AX RV"), "2500") << "magnitude only (decision M10)";
  EXPECT_EQ(rig.value("AA RV"), "2500,0,30,0,0,0,0,0");
  rig.send("SA");
  rig.run_for(1s);
  EXPECT_EQ(rig.value("AX RV"), "0");
}

VME58_FORM("vme58.query.RU") {
  Rig rig;
  rig.send("AX LP-1500 ");
  EXPECT_EQ(rig.ask("RU"), framed("-1500.0")) << "counts while user units are off";
  rig.send("UU1000 ");
  EXPECT_EQ(rig.value("RU"), "-1.5");
  rig.send("UU3 ");
  EXPECT_EQ(rig.value("RU"), "-500.0");
  rig.send("UU7 ");
  EXPECT_EQ(rig.value("RU"), "-214.285714") << "up to six decimals";
  EXPECT_EQ(rig.value("AA RU"), "-214.285714,0.0,0.0,0.0,0.0,0.0,0.0,0.0");
}

VME58_FORM("vme58.contour.RQ") {
  Rig rig;
  rig.send("AA CD0,0; ");
  EXPECT_EQ(rig.ask("RQ"), framed("200"));
  rig.send("AN0; MT10,20 CR0,0,3.14 ");
  EXPECT_EQ(rig.value("RQ"), "191");
  // Overflow is a command error and spoils the contour (decision M21): back-pressure would hold CE back for
  // ever.
  for (int i = 0; i < 63; ++i) rig.send("MT1,1 ");
  EXPECT_EQ(rig.value("RQ"), "2");
  EXPECT_FALSE(rig.command_error());
  rig.send("MT2,2;");
  EXPECT_TRUE(rig.command_error());
  rig.send("CE CV100 ");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.value("RQ"), "200") << "the AA queue again";
  rig.send("CX ");
  EXPECT_TRUE(rig.command_error());
  rig.run_for(1s);
  EXPECT_EQ(rig.position('X'), 0);
}

}  // namespace hw::vme58::proof
