#pragma once
// Emulators that other programs on this computer reach while the console runs, as the connection page sees
// them. Who serves them stands behind this interface, on the io thread.
#include <memory>
#include <string>
#include <string_view>

#include "core/session/address.h"

namespace hw {
class Session;
}

namespace hw::gui {

struct ServedEmulator {
  std::string tcp;       ///< "127.0.0.1:5801"; empty: it is being started, or could not be
  std::string terminal;  ///< path of a pseudo-terminal; may be empty
  int clients = 0;       ///< over TCP
  std::string trouble;   ///< why it is not served
};

class EmulatorServer {
 public:
  virtual ~EmulatorServer() = default;
  /// `session`: the emulator that is open there; null: one of its own, as the address says. GUI thread.
  virtual void serve(const std::string& key, const Address& address, std::shared_ptr<Session> session) = 0;
  virtual void end(std::string_view key) = 0;
  /// As it is now; changes are announced by the console's wake(). Null: nobody has asked for it.
  virtual const ServedEmulator* find(std::string_view key) = 0;
};

}  // namespace hw::gui
