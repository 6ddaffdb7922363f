#pragma once
// What is read once and holds until it changes: what the controller is, its set-up, its programs.
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {

class Knowledge {
 public:
  Knowledge(Nameplate& nameplate, Parameters& setup, Slots& slots)
      : nameplate_(nameplate), parameters_(setup), slots_(slots) {}

  [[nodiscard]] bool suffices_for_a_move() const {
    return slots_.knows_sizes() && parameters_.knows_essentials();
  }
  /// What could not be read while a program ran, or has become uncertain since.
  Task<Result<>> catch_up();
  /// It is read again.
  void doubt();
  /// It may have restarted: all is read again, but what the console has left in it is still to be taken back.
  void may_be_of_before();
  /// The controller has restarted: what is not stored is gone.
  void forget();

 private:
  Nameplate& nameplate_;
  Parameters& parameters_;
  Slots& slots_;
};

}  // namespace hw::vxm
