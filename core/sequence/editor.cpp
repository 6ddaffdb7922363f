#include "core/sequence/editor.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/sequence/sequence_file.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

constexpr std::size_t most_kept = 500;

/// The list that contains the path's last step; null: none.
StepList* list_of(Sequence& s, const StepPath& path) {
  if (path.empty()) return nullptr;
  StepList* list = &s.steps;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path[i] >= list->size()) return nullptr;
    list = steps_in((*list)[path[i]]);
    if (!list) return nullptr;
  }
  return list;
}

std::ptrdiff_t offset(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

/// Whether `inner` is one of the span's steps or nested in one.
bool within(const StepPath& inner, const StepSpan& outer) {
  const std::size_t level = outer.first.size() - 1;
  return inner.size() > level &&
         std::equal(inner.begin(), inner.begin() + offset(level), outer.first.begin()) &&
         inner[level] >= outer.first[level] && inner[level] < outer.first[level] + outer.count;
}

int depth_of(const StepList& steps) {
  int deepest = 0;
  for (const Step& step : steps)
    if (const StepList* inner = steps_in(step)) deepest = std::max(deepest, depth_of(*inner));
  return deepest + 1;
}

}  // namespace

StepSpan span_between(const StepPath& one, const StepPath& other) {
  const StepPath& shorter = one.size() < other.size() ? one : other;
  const auto differ = std::mismatch(shorter.begin(), shorter.end(), (&shorter == &one ? other : one).begin());
  auto level = static_cast<std::size_t>(differ.first - shorter.begin());
  if (level == shorter.size()) return StepSpan(shorter);  // one is nested in the other
  StepPath first(shorter.begin(), differ.first + 1);
  const auto [low, high] = std::minmax(one[level], other[level]);
  first[level] = low;
  return StepSpan(std::move(first), high - low + 1);
}

void Editor::load(Sequence sequence) {
  done_.clear(), undone_.clear();
  typed_at_.reset();
  now_ = std::make_shared<const Sequence>(std::move(sequence));
  ++version_, ++loads_;
}

void Editor::exchange(Sequence sequence) {
  if (keep(std::move(sequence))) ++loads_;
}

Editor::Change Editor::between(const Sequence& was, const Sequence& is) {
  const StepList &a = was.steps, &b = is.steps;
  const auto [first_a, first_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto [last_a, last_b] = std::mismatch(a.rbegin(), std::make_reverse_iterator(first_a), b.rbegin(),
                                              std::make_reverse_iterator(first_b));
  Change change;
  change.at = static_cast<std::size_t>(first_a - a.begin());
  change.was.assign(first_a, last_a.base());
  change.is.assign(first_b, last_b.base());
  Sequence frame_was = frame_of(was), frame_is = frame_of(is);
  if (frame_was != frame_is) change.frame_was = std::move(frame_was), change.frame_is = std::move(frame_is);
  return change;
}

bool Editor::keep(Sequence changed, const StepPath* typed_at) {
  if (depth_of(changed.steps) > deepest_loop) return false;
  Change change = between(*now_, changed);
  const bool goes_on = typed_at && typed_at_ == *typed_at;
  if (goes_on && done_.back().at == change.at && done_.back().is == change.was) {
    done_.back().is = std::move(change.is);
  } else {
    if (done_.size() == most_kept) done_.erase(done_.begin());
    done_.push_back(std::move(change));
  }
  typed_at_ = typed_at ? std::optional(*typed_at) : std::nullopt;
  undone_.clear();
  now_ = std::make_shared<const Sequence>(std::move(changed));
  ++version_;
  return true;
}

const Step* Editor::at(const StepPath& path) const {
  const StepList* list = &now_->steps;
  const Step* step = nullptr;
  for (const std::size_t place : path) {
    if (!list || place >= list->size()) return nullptr;
    step = &(*list)[place];
    list = steps_in(*step);
  }
  return step;
}

std::optional<StepPath> Editor::insert(const StepPath& at, Step step) {
  Sequence s = *now_;
  StepList* list = list_of(s, at);
  if (!list || at.back() > list->size()) return std::nullopt;
  list->insert(list->begin() + offset(at.back()), std::move(step));
  return keep(std::move(s)) ? std::optional(at) : std::nullopt;
}

bool Editor::holds(const StepSpan& which) const {
  if (which.count == 0 || !at(which.first)) return false;
  StepPath last = which.first;
  last.back() += which.count - 1;
  return at(last) != nullptr;
}

std::optional<StepPath> Editor::remove(const StepSpan& which) {
  if (!holds(which)) return std::nullopt;
  Sequence s = *now_;
  StepPath next = which.first;
  StepList* list = list_of(s, next);
  const auto first = list->begin() + offset(next.back());
  list->erase(first, first + offset(which.count));
  if (next.back() >= list->size()) {
    if (list->empty())
      next.pop_back();
    else
      next.back() = list->size() - 1;
  }
  return keep(std::move(s)) ? std::optional(next) : std::nullopt;
}

std::optional<StepPath> Editor::move(const StepSpan& from, const StepPath& to) {
  if (!holds(from) || to.empty()) return std::nullopt;
  const StepPath& first = from.first;
  const std::size_t level = first.size() - 1;
  // The place just after the last of them is not within.
  if (within(to, from)) return std::nullopt;
  Sequence s = *now_;
  StepList* target = list_of(s, to);
  if (!target || to.back() > target->size()) return std::nullopt;
  StepList* source = list_of(s, first);
  const auto begin = source->begin() + offset(first.back()), end = begin + offset(from.count);
  StepList moved(std::make_move_iterator(begin), std::make_move_iterator(end));
  source->erase(begin, end);
  // Later steps of their list have moved up.
  StepPath place = to;
  if (place.size() > level && std::equal(first.begin(), first.end() - 1, place.begin()) &&
      place[level] > first[level])
    place[level] -= from.count;
  target = list_of(s, place);
  target->insert(target->begin() + offset(place.back()), std::make_move_iterator(moved.begin()),
                 std::make_move_iterator(moved.end()));
  if (place == first) return std::nullopt;  // already there
  if (s == *now_) return place;             // equal steps were there: no change
  return keep(std::move(s)) ? std::optional(place) : std::nullopt;
}

std::optional<StepPath> Editor::duplicate(const StepSpan& which) {
  if (!holds(which)) return std::nullopt;
  Sequence s = *now_;
  StepList* list = list_of(s, which.first);
  const auto first = list->begin() + offset(which.first.back()), end = first + offset(which.count);
  const StepList again(first, end);
  list->insert(end, again.begin(), again.end());
  StepPath behind = which.first;
  behind.back() += which.count;
  return keep(std::move(s)) ? std::optional(behind) : std::nullopt;
}

std::optional<StepPath> Editor::put_into_loop(const StepSpan& which) {
  if (!holds(which)) return std::nullopt;
  Sequence s = *now_;
  StepList* list = list_of(s, which.first);
  const auto first = list->begin() + offset(which.first.back()), end = first + offset(which.count);
  Repeat loop;
  loop.times = 2;
  loop.steps.assign(std::make_move_iterator(first), std::make_move_iterator(end));
  *first = Step{std::move(loop)};
  list->erase(first + 1, end);
  return keep(std::move(s)) ? std::optional(which.first) : std::nullopt;
}

std::optional<StepPath> Editor::take_out_of_loop(const StepPath& at) {
  const Step* step = this->at(at);
  if (!step || !std::holds_alternative<Repeat>(step->body)) return std::nullopt;
  const StepList inner = std::get<Repeat>(step->body).steps;
  Sequence s = *now_;
  StepList* list = list_of(s, at);
  const auto place = list->erase(list->begin() + offset(at.back()));
  list->insert(place, inner.begin(), inner.end());
  return keep(std::move(s)) ? std::optional(at) : std::nullopt;
}

std::optional<StepPath> Editor::skip(const StepSpan& which, bool skipped) {
  if (!holds(which)) return std::nullopt;
  Sequence s = *now_;
  StepList* list = list_of(s, which.first);
  bool any = false;
  for (std::size_t i = which.first.back(); i < which.first.back() + which.count; ++i)
    if (std::exchange((*list)[i].skipped, skipped) != skipped) any = true;
  return any && keep(std::move(s)) ? std::optional(which.first) : std::nullopt;
}

std::optional<StepPath> Editor::replace(const StepPath& at, Step::Body body) {
  const Step* step = this->at(at);
  if (!step || step->body == body) return std::nullopt;
  Sequence s = *now_;
  (*list_of(s, at))[at.back()].body = std::move(body);
  return keep(std::move(s), &at) ? std::optional(at) : std::nullopt;
}

void Editor::replace_frame(Sequence frame) {
  frame.steps = now_->steps;
  if (frame != *now_) keep(std::move(frame));
}

void Editor::go(std::vector<Change>& from, std::vector<Change>& to, bool back) {
  if (from.empty()) return;
  Change change = std::move(from.back());
  from.pop_back();
  const StepList &goes = back ? change.is : change.was, &comes = back ? change.was : change.is;
  const auto& frame = back ? change.frame_was : change.frame_is;
  Sequence s = *now_;
  if (frame) {
    StepList steps = std::move(s.steps);
    s = *frame;
    s.steps = std::move(steps);
  }
  const auto place = s.steps.begin() + offset(change.at);
  s.steps.insert(s.steps.erase(place, place + offset(goes.size())), comes.begin(), comes.end());
  to.push_back(std::move(change));
  now_ = std::make_shared<const Sequence>(std::move(s));
  typed_at_.reset();
  ++version_;
}

void Editor::undo() { go(done_, undone_, true); }

void Editor::redo() { go(undone_, done_, false); }

}  // namespace hw::sequence
