#pragma once
// A TCP port that this program serves. Each accepted connection becomes a stream.
#include <functional>
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

class TcpEndpoint {
 public:
  using Accepted = std::function<void(std::unique_ptr<Stream>)>;
  /// Listens at `where`, "HOST:PORT"; port 0: any free port. Without `allow_remote` only loopback addresses
  /// are accepted, so that no other host can connect.
  static Result<std::unique_ptr<TcpEndpoint>> open(Scheduler& scheduler, const std::string& where,
                                                   bool allow_remote, Accepted accepted);
  virtual ~TcpEndpoint() = default;
  /// The address with the actual port: "127.0.0.1:4001".
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace hw
