#pragma once
// Makes a time line for each output and input seen in a rehearsal. Pure.
#include <string>
#include <vector>

#include "core/device/language.h"

namespace hw::panels {

struct IoLane {
  struct Span {
    double from, to;
  };
  std::string name;         ///< "output 1"
  std::vector<Span> on;     ///< while switched on, or seen on
  std::vector<Span> waits;  ///< while the program waits for it
  std::vector<double> looks;
  std::string words;  ///< in words: "on from 1.3 s to 1.4 s, looked at after 0.2 s"
};

/// The lanes in order of first use. Spans closer together than `finest` of the whole are merged, because the
/// gap would be invisible.
std::vector<IoLane> io_lanes(const Rehearsal& rehearsal, double finest = 1.0 / 256);

}  // namespace hw::panels
