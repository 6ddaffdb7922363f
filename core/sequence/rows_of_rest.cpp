#include "core/sequence/rows_of_rest.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/sequence/rest.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

int rows_in(const Step& step) {
  const StepList* inner = steps_in(step);
  return 1 + (inner ? count_steps(*inner) : 0);
}

/// Number of leading steps; all of them: not a rest.
std::size_t leading_of(const StepList& rest) {
  const auto begins = std::find(rest.begin(), rest.end(), Step{Comment{std::string(rest_begins)}});
  return static_cast<std::size_t>((begins == rest.end() ? begins : begins + 1) - rest.begin());
}

/// Whether `step` is the same loop with only the remaining passes.
bool is_left_of(const Step& step, const Repeat& loop) {
  const auto* left = std::get_if<Repeat>(&step.body);
  return left && left->times < loop.times && left->steps == loop.steps;
}

/// Matches backwards: a rest ends with the same steps as the whole, or within an entered loop with the same
/// steps as that loop.
class BackwardMatch {
 public:
  explicit BackwardMatch(const StepList& rest)
      : rest_(rest), rows_(ix(count_steps(rest)), -1), leading_(leading_of(rest)) {}

  /// Matches the first `count` of some steps of the whole, which end before row `behind` there. False: the
  /// rest does not match.
  bool match(const StepList& steps, std::size_t count, int behind) {
    for (; left_ > leading_; --count) {
      if (count == 0) return false;
      const Step& step = steps[count - 1];
      const int row = behind - rows_in(step);
      const auto* loop = std::get_if<Repeat>(&step.body);
      const bool same = rest_[left_ - 1] == step;
      if (same && (!loop || loop->times > 0)) {
        take(row), behind = row;
        continue;
      }
      if (!loop) return false;
      if (same || is_left_of(rest_[left_ - 1], *loop)) take(row);
      const auto left = left_;
      const auto end = end_;
      if (same && match(steps, count - 1, row)) return true;  // the rest begins before an endless loop
      left_ = left, end_ = end;
      return match(loop->steps, loop->steps.size(), behind);
    }
    return true;
  }
  [[nodiscard]] std::vector<int> rows() && { return std::move(rows_); }

 private:
  void take(int row) {
    const int count = rows_in(rest_[--left_]);
    end_ -= count;
    for (int i = 0; i < count; ++i) rows_[ix(end_ + i)] = row + i;
  }

  const StepList& rest_;
  std::vector<int> rows_;
  const std::size_t leading_;
  std::size_t left_ = rest_.size();
  int end_ = static_cast<int>(rows_.size());  ///< row of the rest after the unmatched steps
};

}  // namespace

std::vector<int> rows_of_rest(const Sequence& rest, const Sequence& whole) {
  BackwardMatch search(rest.steps);
  if (!search.match(whole.steps, whole.steps.size(), count_steps(whole.steps))) return {};
  return std::move(search).rows();
}

}  // namespace hw::sequence
