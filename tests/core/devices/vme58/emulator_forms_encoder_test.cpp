// Rows of the encoder commands. Tracking (ET) stands with the motion.
// Those that neither loop nor compute stand in vme58.forms.
#include <cmath>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

constexpr AxisId axis_x{0};

/// Step axes with encoders.
Rig steppers() { return Rig::model("4E"); }

void slip_x(Rig& rig, std::int64_t counts) { rig.operate(bench::Slip(axis_x, Steps(counts))); }
void jam_x(Rig& rig, bool on) { rig.operate(bench::Jam(axis_x, on)); }

std::int64_t encoder(Rig& rig) { return std::atoll(rig.value("AX RE").c_str()); }

/// Holding with a brisk correction.
Rig holding_stepper(std::string_view more = "") {
  Rig rig = steppers();
  rig.send("AX HV1000 HG1000 HN " + std::string(more) + " ");
  EXPECT_FALSE(rig.command_error());
  return rig;
}

}  // namespace

VME58_FORM("vme58.enc.ER") {
  // 1000 counts of the encoder are 400 of the motor. With that ratio the move leaves no error.
  for (const bool told : {true, false}) {
    Rig rig = steppers();
    AxisPlace place;
    place.counts_per_step = 2.5;
    rig.place('X', place);
    rig.send(told ? "AX ER1000,400 HN MR400 GO ID " : "AX HN MR400 GO ID ");
    rig.run_until_done("X");
    EXPECT_EQ(encoder(rig), 1000);
    EXPECT_EQ(rig.position('X'), 400);
    EXPECT_EQ(rig.value("EA").substr(3, 1), told ? "P" : "N") << "1:1 otherwise (decision M80)";
  }
}

VME58_FORM("vme58.enc.HG") {
  // Error times gain: 100 counts at HG 2 begin with 200 counts/s and come down slower and slower.
  Rig rig = holding_stepper("HG2");
  slip_x(rig, -100);
  rig.run_for(500ms);
  EXPECT_NEAR(static_cast<double>(encoder(rig)), -100 * std::exp(-2 * 0.5), 4);
  Rig fast = holding_stepper("HG20");
  slip_x(fast, -100);
  fast.run_for(500ms);
  EXPECT_GT(encoder(fast), -2);
}

VME58_FORM("vme58.enc.IS") {
  for (const bool asked : {true, false}) {
    for (const std::uint8_t enable : {control::slip_interrupt, control::done_interrupt}) {
      Rig rig = steppers();
      rig.write8(reg::control, enable | control::interrupts);
      rig.send(asked ? "AX ES10 IS MR100 GO " : "AX ES10 MR100 GO ");
      jam_x(rig, true);
      rig.run_for(1s);
      EXPECT_EQ(rig.bus().interrupt().has_value(), asked) << "with control bit 2, or 4 (decision M93)";
      EXPECT_NE(rig.status() & status::slip, 0) << "the flag comes either way";
    }
  }
}

}  // namespace hw::vme58::proof
