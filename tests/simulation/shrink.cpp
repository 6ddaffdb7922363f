#include "tests/simulation/shrink.h"

#include <algorithm>

namespace hw::simulation {
namespace {

using Fails = std::function<bool(const Plan&)>;

Plan without(const Plan& plan, std::size_t from, std::size_t count) {
  Plan less = plan;
  const auto begin = less.steps.begin() + static_cast<std::ptrdiff_t>(from);
  less.steps.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(count, less.steps.size() - from)));
  return less;
}

// Leaves out ever smaller pieces, the last ones first: what comes behind the finding goes at once.
bool leave_out(Plan& plan, const Fails& fails) {
  bool less = false;
  for (std::size_t piece = std::max<std::size_t>(1, plan.steps.size() / 2);; piece /= 2) {
    for (std::size_t end = plan.steps.size(); end > 0;) {
      const std::size_t from = end > piece ? end - piece : 0;
      Plan tried = without(plan, from, end - from);
      if (fails(tried)) plan = std::move(tried), less = true;
      end = from;
    }
    if (piece <= 1) return less;
  }
}

// The time before the first step, and between two, is often of no account.
void draw_together(Plan& plan, const Fails& fails) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const Millis before = i == 0 ? Millis(1000) : plan.steps[i - 1].at;
    const Millis gap = plan.steps[i].at - before;
    for (const Millis less : {gap - Millis(1000), gap / 2}) {
      if (gap < Millis(500) || less <= Millis(0)) continue;
      Plan tried = plan;
      for (std::size_t k = i; k < tried.steps.size(); ++k) tried.steps[k].at -= less;
      if (fails(tried)) {
        plan = std::move(tried);
        break;
      }
    }
  }
}

}  // namespace

Plan shrink(Plan plan, const Fails& fails) {
  while (leave_out(plan, fails)) {
  }
  draw_together(plan, fails);
  if (!plan.steps.empty()) {
    Plan tried = plan;
    tried.length = tried.steps.back().at + Millis(5000);
    if (tried.length < plan.length && fails(tried)) plan = std::move(tried);
  }
  return plan;
}

}  // namespace hw::simulation
