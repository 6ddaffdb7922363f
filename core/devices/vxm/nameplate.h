#pragma once
// What the controller is: its version, and whether a second one answers on the VXM bus.
#include <string_view>
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

inline constexpr std::string_view unused_slave =
    "A second controller answers on the VXM bus, and its motors 3 and 4 are not shown. Open it with motors=4 "
    "in its address to use them.";

class Nameplate {
 public:
  Nameplate(const Console& console, Conversation& talk) : console_(console), talk_(talk) {}

  Task<Result<>> read();
  [[nodiscard]] bool is_read() const { return read_; }
  void forget() { read_ = false; }
  [[nodiscard]] bool has_slave() const { return has_slave_; }
  /// $ came with version 1.22: of an older one nobody knows the outputs.
  [[nodiscard]] bool tells_outputs() const { return tells_outputs_; }
  /// getPA came with version 1.24.
  [[nodiscard]] bool tells_pulses() const { return tells_pulses_; }
  /// $ was not answered: its version, if that has been read, was misread perhaps; else it may be an old one.
  void doubt_outputs() { tells_outputs_ = std::exchange(read_, false); }
  /// Asked about its motors again, the controller would restart each time. The identity, read afresh after
  /// the restart, tells whether a Slave answers.
  void lose_slave();

 private:
  const Console& console_;
  Conversation& talk_;
  bool read_ = false, has_slave_ = false, tells_outputs_ = true, tells_pulses_ = true;
};

}  // namespace hw::vxm
