#pragma once
// Identity of the controller: its version, and whether a second one answers on the VXM bus.
#include <string_view>
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

inline constexpr std::string_view unused_slave =
    "A second controller answers on the VXM bus, and its motors 3 and 4 are not shown. Open it with motors=4 "
    "in its address to use them.";

inline constexpr const char* check_slave = "Check the Slave's power and cable, then reconnect.";

class Identification {
 public:
  Identification(const Console& console, Conversation& conversation)
      : console_(console), conversation_(conversation) {}

  Task<Result<>> read();
  [[nodiscard]] bool is_read() const { return read_; }
  void forget() { read_ = false; }
  [[nodiscard]] bool has_slave() const { return has_slave_; }
  /// $ came with version 1.22: older versions do not report their outputs.
  [[nodiscard]] bool reports_outputs() const { return reports_outputs_; }
  /// getPA came with version 1.24.
  [[nodiscard]] bool reports_pulses() const { return reports_pulses_; }
  /// $ was not answered. The version, if read, may have been misread; else it may be an old one.
  void doubt_outputs() { reports_outputs_ = std::exchange(read_, false); }
  /// Ends all questions about the Slave's motors, as each of them would restart the controller. The identity,
  /// read again after the restart, tells whether a Slave answers.
  void lose_slave();

 private:
  const Console& console_;
  Conversation& conversation_;
  bool read_ = false, has_slave_ = false, reports_outputs_ = true, reports_pulses_ = true;
};

}  // namespace hw::vxm
