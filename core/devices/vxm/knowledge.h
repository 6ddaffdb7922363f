#pragma once
// Facts that are read once and hold until they change: identity, set-up, programs.
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {

class Knowledge {
 public:
  Knowledge(Identification& identification, Parameters& setup, Slots& slots)
      : identification_(identification), parameters_(setup), slots_(slots) {}

  [[nodiscard]] bool suffices_for_a_move() const {
    return slots_.knows_sizes() && parameters_.knows_essentials();
  }
  /// Reads values that were unreadable while a program ran, or have become uncertain since.
  Task<Result<>> catch_up();
  /// Has everything read again.
  void doubt();
  /// The controller may have restarted: everything is read again, but the console still removes its own
  /// program from it.
  void may_be_of_before();
  /// The controller has restarted: everything not stored is gone.
  void forget();

 private:
  Identification& identification_;
  Parameters& parameters_;
  Slots& slots_;
};

}  // namespace hw::vxm
