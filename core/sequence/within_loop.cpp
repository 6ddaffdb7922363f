#include "core/sequence/within_loop.h"

#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"
#include "core/sequence/words.h"

namespace hw::sequence {
namespace {

/// The step of the list that is the counted step or contains it, and the count within it; none: not found.
struct Found {
  std::size_t step;
  int inner;  ///< -1: that step itself, or one in a contour, which is run as a whole
};
std::optional<Found> find(const StepList& steps, int counted) {
  int first = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepList* inner = steps_in(steps[i]);
    const int size = 1 + (inner ? count_steps(*inner) : 0);
    if (counted >= first && counted < first + size) {
      const bool in_loop = counted > first && std::holds_alternative<Repeat>(steps[i].body);
      return Found{i, in_loop ? counted - first - 1 : -1};
    }
    first += size;
  }
  return std::nullopt;
}

/// How often a step is done in one run of the list; none: endless.
std::optional<std::int64_t> times_in(const StepList& steps, int counted) {
  const auto found = find(steps, counted);
  if (!found || found->inner < 0) return 1;
  const Repeat& loop = std::get<Repeat>(steps[found->step].body);
  const auto inner = times_in(loop.steps, found->inner);
  return loop.times > 0 && inner ? std::optional(loop.times * *inner) : std::nullopt;
}

/// A list with the loops around one step written out at a given pass.
struct Opened {
  StepList steps;
  std::size_t begin = 0;
  int round = 0, rounds = 0;  ///< of the outermost loop
};
Opened open(const StepList& steps, int counted, std::int64_t pass) {
  const auto found = find(steps, counted);
  if (!found || found->inner < 0) return {steps, found ? found->step : 0};
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(found->step);
  const Repeat& loop = std::get<Repeat>(at->body);
  const auto in_a_round = times_in(loop.steps, found->inner);
  const int round = in_a_round ? static_cast<int>(pass / *in_a_round) : 0;
  Opened inner = open(loop.steps, found->inner, in_a_round ? pass % *in_a_round : pass);
  Opened all{StepList(steps.begin(), at), 0, round, loop.times};
  if (round > 0) all.steps.push_back({Repeat{round, loop.steps}});
  all.begin = all.steps.size() + inner.begin;
  all.steps.insert(all.steps.end(), inner.steps.begin(), inner.steps.end());
  if (loop.times == 0)
    all.steps.push_back({loop});
  else if (round + 1 < loop.times)
    all.steps.push_back({Repeat{loop.times - round - 1, loop.steps}});
  all.steps.insert(all.steps.end(), at + 1, steps.end());
  return all;
}

}  // namespace

std::optional<Within> loops_around(const Sequence& sequence, int counted) {
  const auto found = find(sequence.steps, counted);
  if (!found || found->inner < 0) return std::nullopt;
  return Within{found->step, times_in(sequence.steps, counted)};
}

Result<RestOfLoop> rest_within(const Sequence& sequence, int counted, std::int64_t pass, const Places& begin,
                               Rehearsed rehearsed, const OnlySets& only_sets) {
  const auto within = loops_around(sequence, counted);
  if (!within || pass < 0 || (within->times && pass >= *within->times))
    return fail(FaultKind::refused, "There is no such pass of a loop.", "Nothing was started.");
  Opened opened = open(sequence.steps, counted, pass);
  Sequence whole = frame_of(sequence);
  whole.steps = std::move(opened.steps);
  auto rest = rest_from(whole, opened.begin, begin, rehearsed, only_sets);
  if (!rest) {
    Fault fault = rest.error();
    fault.advice += fault.advice.empty() ? "" : " ";
    fault.advice += "Steps are counted as if this pass of the loop were written out.";
    return tl::unexpected(std::move(fault));
  }
  const Step::Body& first = whole.steps[opened.begin].body;
  const std::string of = opened.rounds > 0 ? fmt::format(" of {}", opened.rounds) : std::string();
  RestOfLoop found{std::move(*rest), {}};
  found.begins = fmt::format("pass {}{} of the loop of step {}, {} {}", opened.round + 1, of,
                             within->loop + 1, title_of(first), summary_of(first, sequence));
  const std::string from =
      fmt::format("From pass {}{} of step {} on.", opened.round + 1, of, within->loop + 1);
  for (Step& step : found.rest.sequence.steps)
    if (auto* comment = std::get_if<Comment>(&step.body)) {
      comment->text = from;
      break;  // the first leading comment
    }
  return found;
}

}  // namespace hw::sequence
