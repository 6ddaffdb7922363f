#pragma once
// The rest of a sequence from a place within its loops, when it is known which of their passes is meant: the
// passes before and behind it stay loops, that one is written out. Pure.
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/sequence/rest.h"

namespace hw::sequence {

/// Where a step stands that is counted as SequenceText does.
struct Within {
  std::size_t loop = 0;               ///< the outermost loop around it, by its place in the list
  std::optional<std::int64_t> times;  ///< how often it is done, in all loops together; none: without end
};
/// None: it stands in no loop.
std::optional<Within> loops_around(const Sequence& sequence, int counted);

struct RestOfLoop {
  Rest rest;
  std::string begins;  ///< "pass 2 of 3 of the loop of step 5, Move to X 3", for people
};
/// `pass`: from 0, how often that step was done before. `begin`, `rehearsed` and the fault as of rest_from().
Result<RestOfLoop> rest_within(const Sequence& sequence, int counted, std::int64_t pass,
                               const Places& begin = {}, Rehearsed rehearsed = Rehearsed::no);

}  // namespace hw::sequence
