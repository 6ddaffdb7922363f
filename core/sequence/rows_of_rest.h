#pragma once
// Maps the steps of a rest to those of the whole sequence, to highlight the running step in the user's list.
// Pure.
#include <vector>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// `rest`: of rest_from() or rest_within(). For each of its steps the corresponding step of `whole`, both
/// counted as SequenceText does; -1: a leading step. Empty: not a rest of `whole`, or `whole` was changed
/// since.
std::vector<int> rows_of_rest(const Sequence& rest, const Sequence& whole);

}  // namespace hw::sequence
