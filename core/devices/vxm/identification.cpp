#include "core/devices/vxm/identification.h"

#include <fmt/core.h>

#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

/// The hundredths of a version like 1.30. A version in another form counts as a new one.
int hundredths(std::string_view version) {
  if (version.size() != 4 || version[1] != '.') return newest_firmware;
  int sum = 0;
  for (const char digit : {version[0], version[2], version[3]}) {
    if (digit < '0' || digit > '9') return newest_firmware;
    sum = 10 * sum + (digit - '0');
  }
  return sum;
}

}  // namespace

Task<Result<>> Identification::read() {
  auto version = co_await conversation_.text("getD0", Priority::poll);
  if (!version) co_return fail(version.error());
  auto date = co_await conversation_.text("getD1", Priority::poll);
  if (!date) co_return fail(date.error());
  auto motors = co_await conversation_.number("getD2", Priority::poll);
  if (!motors) co_return fail(motors.error());
  console_.snapshot.identity.firmware = fmt::format("{} ({})", *version, *date);
  has_slave_ = *motors == 4;
  reports_outputs_ = hundredths(*version) >= firmware_of_outputs;
  reports_pulses_ = hundredths(*version) >= firmware_of_pulses;
  const int axes = static_cast<int>(console_.catalog.axes.size());
  for (int i = 0; i < axes; ++i) {
    console_.snapshot.axes[i].enabled = i < motors_per_controller || has_slave_;
    console_.snapshot.axes[i].own_speed =
        console_.catalog
            .jog_speed;  // the controller has no such setting: each jog of the console sets the speed
  }
  if (axes > motors_per_controller && !has_slave_)
    console_.report(Notice::Kind::warning,
                    "The controller finds no second controller on the VXM bus, so motors 3 and 4 cannot be "
                    "used. Nothing is sent to them. Check the Slave's power and cable, and that this "
                    "controller is the Master (DM bit 6); then "
                    "reconnect.");
  if (axes <= motors_per_controller && has_slave_)
    console_.report(Notice::Kind::warning, std::string(unused_slave));
  read_ = true;
  co_return Result<>();
}

void Identification::lose_slave() {
  has_slave_ = false;
  for (int i = motors_per_controller; i < console_.snapshot.axis_count; ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    axis.position_known = axis.limits_known = axis.enabled = false;
    axis.activity = Activity::unknown;
  }
}

}  // namespace hw::vxm
