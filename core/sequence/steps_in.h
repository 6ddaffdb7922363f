#pragma once
// Steps nested in other steps.
#include <utility>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// The inner steps of a step; null: it has none.
inline const StepList* steps_in(const Step& step) {
  if (const auto* loop = std::get_if<Repeat>(&step.body)) return &loop->steps;
  if (const auto* contour = std::get_if<Contour>(&step.body)) return &contour->steps;
  return nullptr;
}
inline StepList* steps_in(Step& step) { return const_cast<StepList*>(steps_in(std::as_const(step))); }
/// Number of steps in a list, nested ones included.
inline int count_steps(const StepList& steps) {
  int count = 0;
  for (const Step& step : steps) {
    const StepList* inner = steps_in(step);
    count += 1 + (inner ? count_steps(*inner) : 0);
  }
  return count;
}

}  // namespace hw::sequence
