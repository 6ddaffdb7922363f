#pragma once
// Through this interface the connection page makes emulators serve other programs on this computer while the
// console runs. The server works on the io thread.
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
  std::string trouble;   ///< why the emulator is not served
};

class EmulatorServer {
 public:
  virtual ~EmulatorServer() = default;
  /// Serves the emulator of `session`; null: a new emulator made from the address. GUI thread.
  virtual void serve(const std::string& key, const Address& address, std::shared_ptr<Session> session) = 0;
  virtual void end(std::string_view key) = 0;
  /// The present state; null: serving was not requested. The console's wake() announces changes.
  virtual const ServedEmulator* find(std::string_view key) = 0;
};

}  // namespace hw::gui
