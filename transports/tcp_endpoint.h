#pragma once
// A TCP port on which clients reach something of ours; each connection is given away as a stream.
#include <functional>
#include <memory>
#include <string>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

class TcpEndpoint {
 public:
  using Accepted = std::function<void(std::unique_ptr<Stream>)>;
  /// "HOST:PORT"; port 0: any free one. Other hosts than this one can connect only with `allow_remote`;
  /// without, a place that is not loopback is refused.
  static Result<std::unique_ptr<TcpEndpoint>> open(Scheduler& scheduler, const std::string& where,
                                                   bool allow_remote, Accepted accepted);
  virtual ~TcpEndpoint() = default;
  /// With the port that it really is: "127.0.0.1:4001".
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace hw
