#pragma once
// Serves an emulator to other programs: by TCP, and for a device on a line by a pseudo-terminal too, as
// `handwheel emulate` does. New clients share the wire of the emulator with clients already attached. Io
// thread only.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/session/address.h"
#include "transports/serve.h"

namespace hw {

class TcpEndpoint;

class EmulatorService {
 public:
  struct Place {
    int port = 0;          ///< TCP port on this computer; if taken or 0: any free port
    std::string terminal;  ///< path of the pseudo-terminal; empty: none
  };
  /// `clients_changed` is called with the number of TCP clients.
  static Result<std::unique_ptr<EmulatorService>> start(Scheduler& scheduler,
                                                        std::shared_ptr<EmulatorHost> host,
                                                        const Place& place,
                                                        std::function<void(int)> clients_changed);
  /// Closes the endpoints and disconnects the clients.
  ~EmulatorService();

  [[nodiscard]] std::string address() const;  ///< "127.0.0.1:5801"
  [[nodiscard]] const std::string& terminal() const { return terminal_; }

  struct ServedStreams;

 private:
  EmulatorService(std::shared_ptr<EmulatorHost> host, std::shared_ptr<ServedStreams> streams);

  std::shared_ptr<EmulatorHost> host_;
  std::shared_ptr<ServedStreams> streams_;
  std::unique_ptr<TcpEndpoint> endpoint_;
  std::string terminal_;
};

/// Makes a new host with the emulators that an address names: "dmx-k-sa@emulator,id=01-04". A single emulator
/// answers without its id too.
Result<std::shared_ptr<EmulatorHost>> make_private_host(Scheduler& scheduler, const Address& address);

/// The path for a pseudo-terminal of this name, in the user's runtime folder, else in the temporary folder.
std::string terminal_for(const std::string& name);

}  // namespace hw
