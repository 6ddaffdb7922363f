#pragma once
// What a transport implements: an ordered stream of bytes both ways. Io thread only.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/link/wire_share.h"

namespace hw {

class Stream {
 public:
  /// Hears what comes in. Called from the io thread, never from inside a call into the stream.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void bytes_arrived(std::string_view bytes) = 0;
    /// The wire is gone (cable pulled, peer closed). Nothing arrives any more; send() does nothing.
    virtual void stream_closed(const Fault& why) = 0;
  };

  virtual ~Stream() = default;
  /// Null: nobody listens, what arrives is dropped.
  virtual void listen(Listener* listener) = 0;
  /// Never blocks. Bytes go out in the order of the calls.
  virtual void send(std::string_view bytes) = 0;
  /// The wire is given up: what has not left yet must not arrive later, when nobody looks any more.
  virtual void discard_unsent() = 0;
  /// Line rate in baud, 8N1. Streams without a rate accept and ignore it.
  virtual Result<> set_rate(int baud) = 0;
  /// 0: no rate, bytes arrive as fast as they can.
  [[nodiscard]] virtual int rate() const = 0;
  /// True: each send() is one message, and so is each bytes_arrived() (USB): no address in front, no
  /// terminator behind; an empty one arrives as a single zero byte. False: a line of bytes.
  [[nodiscard]] virtual bool carries_messages() const { return false; }
  /// How a watchdog reaches it too; none: it ends with this program.
  [[nodiscard]] virtual WireShare share() const { return {}; }
  /// Where it leads, for a person: "/dev/ttyUSB0, 9600 baud".
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace hw
