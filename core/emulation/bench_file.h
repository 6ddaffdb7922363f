#pragma once
// A bench described in a TOML file: the axes' switches and loads, the inputs at the start, and later events.
//
//   quirks = ["overrun"]
//   [axis.1]                      # keys of AxisPlace, the same as in a script's bench:place()
//   minus = -1000
//   plus = 90000
//   home = [2000, 2400]
//   scatter = 3                   # a switch acts up to 3 steps before or behind
//                                 # its place, elsewhere each time
//   seed = 7                      # of that (else 1): the same seed, the same series
//   motor = {friction = 0.01}     # a servo axis gets a motor (true: as it stands in
//                                 # core/motion/motor.h; false: none): inertia kg m²,
//                                 # viscous Nm s/rad, friction Nm, torque_per_volt Nm/V,
//                                 # torque_limit Nm, counts_per_turn
//   [input]
//   1 = true                      # operated from the start
//   [analog]
//   1 = 300
//   [[at]]                        # later: the names and arguments of a script's bench
//   t = 2.5                       # seconds
//   limit = ["1", "+", true]
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/bench.h"
#include "core/device/catalog.h"

namespace hw {

struct TimedBenchCommand {
  Duration at;  ///< since the bench was set up
  BenchCommand command;
};

struct BenchFile {
  std::vector<std::string> quirks;
  std::vector<BenchCommand> at_start;
  std::vector<TimedBenchCommand> later;  ///< earliest first
};

/// Axis names are those of `catalog`. A fault begins `name:LINE:COLUMN: `.
Result<BenchFile> parse_bench_file(std::string_view text, const Catalog& catalog,
                                   std::string_view name = "bench file");

/// The error in a place ("minus must be below plus"); empty: none.
std::string_view problem_of(const AxisPlace& place);

}  // namespace hw
