#pragma once
// Works out durations from a rehearsal of the text: of each block in all its passes, of each pass of a loop,
// and of the whole, or its minimum if the rehearsal was cut short. Pure.
#include <span>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/sequence/sequence.h"

namespace hw::panels {

struct BlockTimes {
  std::vector<std::string> of_step;  ///< "2.3 s", "12 x 6.5 s"; as SequenceText counts the steps
  double at_least_s = 0;             ///< least duration of the whole, if the rehearsal did not end
  bool goes_on = false;  ///< the rehearsal did not end, in a loop or delay that merely outlasts it
};

BlockTimes block_times(const sequence::StepList& steps, const Rehearsal& rehearsal,
                       std::span<const int> step_of_command);

}  // namespace hw::panels
