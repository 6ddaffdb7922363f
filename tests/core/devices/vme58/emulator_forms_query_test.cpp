// Rows of status requests, with the exact bytes of the replies.
// Those that neither loop nor compute stand in vme58.forms.
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

VME58_FORM("vme58.query.QI") {
  Rig rig;
  rig.send("AX ID ");
  rig.home_switch('U', true);
  const std::string all = "PDNN,PNNN,PNNN,PNNN,PNNH,PNNN,PNNN,PNNN";
  EXPECT_EQ(rig.ask("AA QI"), status_framed(all));
  EXPECT_EQ(rig.ask("QI"), status_framed(all));
  EXPECT_EQ(rig.done(), bit_of('X'));
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
