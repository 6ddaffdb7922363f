#pragma once
// The rest of a sequence from a step within loops, in a known pass: that pass is written out, the passes
// before and after it stay loops. Pure.
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/sequence/rest.h"

namespace hw::sequence {

/// The place of a step, counted as SequenceText does.
struct Within {
  std::size_t loop = 0;               ///< index of the outermost loop around it
  std::optional<std::int64_t> times;  ///< how often the step is done in all loops together; none: endless
};
/// None: not in a loop.
std::optional<Within> loops_around(const Sequence& sequence, int counted);

struct RestOfLoop {
  Rest rest;
  std::string begins;  ///< "pass 2 of 3 of the loop of step 5, Move to X 3", for people
};
/// `pass`: from 0, how often the step was done before. The others and the fault: see rest_from().
Result<RestOfLoop> rest_within(const Sequence& sequence, int counted, std::int64_t pass,
                               const Places& begin = {}, Rehearsed rehearsed = Rehearsed::no,
                               const OnlySets& only_sets = {});

}  // namespace hw::sequence
