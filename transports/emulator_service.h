#pragma once
// An emulator that other programs reach while it is served: by TCP, and where it hangs on a line by a
// pseudo-terminal too, as `handwheel emulate` does it. Clients are on its one wire together with whoever is
// there already. Io thread only.
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
    int port = 0;          ///< of TCP on this computer; taken or 0: any free one
    std::string terminal;  ///< path of the pseudo-terminal; empty: none
  };
  /// `clients_changed` hears how many programs are connected by TCP.
  static Result<std::unique_ptr<EmulatorService>> start(Scheduler& scheduler,
                                                        std::shared_ptr<EmulatorHost> host,
                                                        const Place& place,
                                                        std::function<void(int)> clients_changed);
  /// Nobody can connect any more, and whoever is connected is sent away.
  ~EmulatorService();

  [[nodiscard]] std::string address() const;  ///< "127.0.0.1:5801"
  [[nodiscard]] const std::string& terminal() const { return terminal_; }
  [[nodiscard]] int clients() const;

  struct Guests;

 private:
  EmulatorService(std::shared_ptr<EmulatorHost> host, std::shared_ptr<Guests> guests);

  std::shared_ptr<EmulatorHost> host_;
  std::shared_ptr<Guests> guests_;
  std::unique_ptr<TcpEndpoint> endpoint_;
  std::string terminal_;
};

/// A host with emulators of its own, as an address names them: "dmx-k-sa@emulator,id=01-04". One alone is
/// spoken to without its id too.
Result<std::shared_ptr<EmulatorHost>> host_of_its_own(Scheduler& scheduler, const Address& address);

/// Where a pseudo-terminal of this name is put for the user: in his folder for what lives as long as he is
/// logged in, else among the temporary files.
std::string terminal_for(const std::string& name);

}  // namespace hw
