// NF90 emulation (App. P p.74, V83) and what the VXM refuses of the VP9000 (V100).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

void expect_refused(const Form& form) {
  Rig rig = Rig::online();
  rig.send("I1M400,");
  expect_dropped(rig, form.example);
  EXPECT_EQ(rig.ask("V"), "R") << "and the next command is read as ever";
  rig.send("I1M7,");
  EXPECT_EQ(rig.used_bytes(), 8);
}

// A single character is dropped at once: what follows is a command.
void expect_refused_character(const Form& form) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask(form.example + "V"), "R");
  rig.send(form.example + "I1M7,");
  EXPECT_EQ(rig.used_bytes(), 4);
}

}  // namespace

VXM_FORM("vxm.nf90.home") {
  Rig rig = rig_for(form);
  AxisPlace travel;
  travel.plus = Steps(1000);
  travel.minus = Steps(-600);
  rig.place(1, travel);
  rig.run("I1M250,");
  rig.run("I1M0,");
  EXPECT_EQ(rig.position(1), 0) << "to absolute zero";
  rig.run("I1M-0,");
  EXPECT_EQ(rig.position(1), -600) << "still seeks the negative limit";
  rig.run("I1M0,");
  EXPECT_EQ(rig.position(1), 0) << "from below too";
}

VXM_FORM("vxm.nf90.marker") {
  Rig rig = rig_for(form);
  rig.run("I1M100,L-0,I2M10,LA3,");
  EXPECT_EQ(rig.position(1), 100);
  EXPECT_EQ(rig.position(2), 30);
}

VXM_FORM("vxm.nf90.u2") {
  Rig rig = rig_for(form);
  rig.send("U2,P10,R");
  rig.run_for(500ms);
  EXPECT_FALSE(rig.out(1));
  rig.run_until_output("^");
}

VXM_FORM("vxm.nf90.u3") {
  Rig rig = rig_for(form);
  rig.send("P10,P-5000,R");
  rig.run_for(500ms);
  EXPECT_TRUE(rig.out(1)) << "the state at power-up";
  rig.run_for(750ms);
  EXPECT_TRUE(rig.out(1));
  rig.run_until_output("^");
  EXPECT_FALSE(rig.out(1)) << "low again behind the pause";
  rig.send("CU2,P1,U3,P10,R");
  rig.run_for(50ms);
  EXPECT_FALSE(rig.out(1));
  rig.run_for(500ms);
  EXPECT_TRUE(rig.out(1));
}

VXM_FORM("vxm.nf90.accel") {
  Rig rig = rig_for(form);
  EXPECT_TRUE(same_time(rig.run("A1M3,I1M400,"), index_time(400, 2000, 6)));
  EXPECT_TRUE(same_time(rig.run("I2M400,"), index_time(400, 2000, 4))) << "the default of 2 is doubled too";
  rig.send("C");
  expect_dropped(rig, "A1M128");
  rig.send("A1M127,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M254<cr>A1M127<cr>") << "doubled inside only";
}

VXM_FORM("vxm.refused.u10") { expect_refused(form); }
VXM_FORM("vxm.refused.u40") { expect_refused(form); }
VXM_FORM("vxm.refused.u41") { expect_refused(form); }
VXM_FORM("vxm.refused.u60") { expect_refused(form); }
VXM_FORM("vxm.refused.u61") { expect_refused(form); }
VXM_FORM("vxm.refused.u70") { expect_refused(form); }
VXM_FORM("vxm.refused.u71") { expect_refused(form); }
VXM_FORM("vxm.refused.u72") { expect_refused(form); }
VXM_FORM("vxm.refused.u73") { expect_refused(form); }
VXM_FORM("vxm.refused.brace.open") { expect_refused_character(form); }
VXM_FORM("vxm.refused.brace.close") { expect_refused_character(form); }
VXM_FORM("vxm.refused.percent") { expect_refused_character(form); }
VXM_FORM("vxm.refused.ampersand") { expect_refused_character(form); }

VXM_FORM("vxm.refused.u1xx") {
  expect_refused(form);
  Rig rig = Rig::online_with_slave();
  for (const char* u :
       {"U106", "U107", "U108", "U109", "U111", "U112", "U121", "U122", "U177", "U191", "U192",
        "U199", "U110", "U120", "U200", "U255", "U20",  "U34",  "U52",  "U78",  "U93",  "U100000"})
    expect_dropped(rig, u);
}

}  // namespace hw::vxm::proof
