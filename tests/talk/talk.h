#pragma once
// Transcripts of a wire: what is sent, what has to come back. Read by somebody who holds the manual, run
// against an emulator in process or over a pty, or against real hardware. One thing per line:
//
//   @ motors=4          options of the controller, before anything else
//   # text              a remark; cites the manual's page
//   > I1M400\r          bytes sent
//   < +0000400\r        bytes that must come next, in time; exactly these
//   <                   nothing may have come that was not expected above
//   ~ 1.5s              lets time pass (s, ms, us)
//   ! input 1 low       a hand on the bench, see below
//
// Escapes: \r \n \0 \\ \xNN. Bytes that came and were not expected fail the next `>` and the end.
// Bench: input N low|high, button NAME down|up|click, limit AXIS +|- on|off, home AXIS on|off, analog N
// VALUE, alarm AXIS on|off, jam AXIS on|off, slip AXIS COUNTS, power cycle, place AXIS [minus=N] [plus=N]
// [home=FROM..TO] [index_every=N].
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/bench.h"
#include "core/time/clock.h"

namespace hw::talk {

struct Step {
  enum class Kind { send, expect, pass, bench };
  Kind kind = Kind::send;
  int line = 0;
  std::string bytes;                ///< sent or expected
  Duration time{};                  ///< pass
  std::vector<BenchCommand> hands;  ///< bench; a click is two, with 50 ms behind each
};

struct Transcript {
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<Step> steps;
};

/// The sentence of a fault names the line.
Result<Transcript> parse(std::string_view text);
Result<Transcript> read(const std::string& path);

/// The other end of the wire: in virtual time or behind a real one.
class Partner {
 public:
  virtual ~Partner() = default;
  virtual void send(std::string_view bytes) = 0;
  /// Waits until `count` bytes have come or the partner's patience ends; gives and takes away what came.
  virtual std::string receive(std::size_t count) = 0;
  /// Gives and takes away what has come so far.
  virtual std::string leftover() = 0;
  virtual void pass(Duration time) = 0;
  virtual Result<> operate(const BenchCommand& command) = 0;
};

/// One sentence for each line that went otherwise; empty when all is as written. Stops at the first few.
std::vector<std::string> run(const Transcript& transcript, Partner& partner);

/// Bytes as they stand in a transcript.
std::string escape(std::string_view bytes);

}  // namespace hw::talk
