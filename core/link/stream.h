#pragma once
// The interface of a transport: an ordered stream of bytes in both directions. Io thread only.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/link/wire_share.h"

namespace hw {

class Stream {
 public:
  /// Receives the bytes. Called from the io thread, never from inside a call into the stream.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void bytes_arrived(std::string_view bytes) = 0;
    /// The wire is gone (cable pulled, peer closed). Nothing arrives any more; send() does nothing.
    virtual void stream_closed(const Fault& why) = 0;
  };

  virtual ~Stream() = default;
  /// Null: received bytes are dropped.
  virtual void listen(Listener* listener) = 0;
  /// Never blocks. Bytes go out in the order of the calls.
  virtual void send(std::string_view bytes) = 0;
  /// Gives the wire up: unsent bytes must not be sent later.
  virtual void discard_unsent() = 0;
  /// Line rate in baud, 8N1. Streams without a rate accept and ignore it.
  virtual Result<> set_rate(int baud) = 0;
  /// 0: no rate, bytes arrive as fast as they can.
  [[nodiscard]] virtual int rate() const = 0;
  /// True: each send() and each bytes_arrived() is one message (USB), without address and terminator; an
  /// empty message arrives as a single zero byte. False: a line of bytes.
  [[nodiscard]] virtual bool carries_messages() const { return false; }
  /// How the watchdog reaches the wire; none: it ends with this program.
  [[nodiscard]] virtual WireShare share() const { return {}; }
  /// A name for the user: "/dev/ttyUSB0, 9600 baud".
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace hw
