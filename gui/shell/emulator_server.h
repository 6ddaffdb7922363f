#pragma once
// The connection page's interface to emulators that serve other programs on this computer while the console
// runs. The server works on the io thread.
#include <memory>
#include <string>
#include <string_view>

#include "core/session/address.h"

namespace hw {
class Session;
}

namespace hw::gui {

struct ServedEmulator {
  std::string tcp;       ///< "127.0.0.1:5801"; empty: starting, or failed
  std::string terminal;  ///< path of a pseudo-terminal; may be empty
  int clients = 0;       ///< over TCP
  std::string trouble;   ///< why it is not served
};

class EmulatorServer {
 public:
  virtual ~EmulatorServer() = default;
  /// `session`: the emulator open there; null: a new one, from the address. GUI thread.
  virtual void serve(const std::string& key, const Address& address, std::shared_ptr<Session> session) = 0;
  virtual void end(std::string_view key) = 0;
  /// The present state; the console's wake() announces changes. Null: serving was not requested.
  virtual const ServedEmulator* find(std::string_view key) = 0;
};

}  // namespace hw::gui
