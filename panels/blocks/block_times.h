#pragma once
// How long blocks take, from a rehearsal of their text: each in all, loops by their passes, and the whole, or
// how long it is at least where the rehearsal was not long enough. Pure.
#include <span>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

struct BlockTimes {
  std::vector<std::string> of_step;  ///< "2.3 s", "12 x 6.5 s"; as SequenceText counts the steps
  double at_least_s = 0;             ///< of the whole, where the rehearsal did not end
  bool goes_on = false;  ///< it did not, in a loop or a delay that only takes longer than it was tried
};

BlockTimes block_times(const sequence::StepList& steps, const Rehearsal& rehearsal,
                       std::span<const int> step_of_command);

}  // namespace hw::panels
