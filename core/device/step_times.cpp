#include "core/device/step_times.h"

#include "core/base/index.h"

namespace hw {

std::vector<double> seconds_of_parts(const Rehearsal& r, std::span<const int> part_of_command) {
  std::vector<double> all;
  int part = -1;
  double since = 0;
  const auto until = [&](double t) {
    if (part >= 0) all[ix(part)] += t - since;
    since = t;
  };
  for (const RehearsedTurn& turn : r.turns) {
    if (ix(turn.command) >= part_of_command.size()) continue;
    const int next = part_of_command[ix(turn.command)];
    if (next < 0 || next == part) continue;
    until(turn.t);
    part = next;
    if (all.size() <= ix(part)) all.resize(ix(part) + 1, 0);
  }
  until(r.duration_s);
  return all;
}

}  // namespace hw
