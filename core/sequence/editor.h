#pragma once
// A sequence being edited: each change of its list can be undone. Pure; for the GUI thread.
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Index of a step in the list; for a nested step, preceded by the index of the outer step.
using StepPath = std::vector<std::size_t>;

/// Consecutive steps of one list.
struct StepSpan {
  StepPath first;
  std::size_t count = 1;
  StepSpan(StepPath at, std::size_t many = 1) : first(std::move(at)), count(many) {}  // NOLINT: a step is one
  StepSpan(std::initializer_list<std::size_t> at) : first(at) {}
};
/// The span between two paths, in either order: in the innermost list that contains both, whole outer steps
/// where they are nested deeper.
StepSpan span_between(const StepPath& one, const StepPath& other);

class Editor {
 public:
  Editor() : now_(std::make_shared<const Sequence>()) {}

  [[nodiscard]] const Sequence& sequence() const { return *now_; }
  /// The same as an unchanging copy, for another thread.
  [[nodiscard]] std::shared_ptr<const Sequence> shared() const { return now_; }
  /// Replaces the sequence and clears the history.
  void load(Sequence sequence);
  /// Replaces the sequence as a change that can be undone.
  void exchange(Sequence sequence);
  /// Changes whenever the sequence does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Grows with each load() and exchange(): paths kept from before are then invalid.
  [[nodiscard]] std::uint64_t loads() const { return loads_; }
  /// Null: no step there.
  [[nodiscard]] const Step* at(const StepPath& path) const;

  // Each of these is one change and returns the new path of the step, or of the first of several; none if
  // there is no such place, or if loops would nest deeper than deepest_loop.
  std::optional<StepPath> insert(const StepPath& at, Step step);
  std::optional<StepPath> remove(const StepSpan& which);  ///< path of the next step, or of the last
  /// Moves steps to the place before the step that is at `to` now; never into themselves.
  std::optional<StepPath> move(const StepSpan& from, const StepPath& to);
  std::optional<StepPath> duplicate(const StepSpan& which);  ///< the copies follow the steps
  /// Replaces the steps by a loop that contains them.
  std::optional<StepPath> put_into_loop(const StepSpan& which);
  /// Replaces a loop by its steps.
  std::optional<StepPath> take_out_of_loop(const StepPath& at);
  std::optional<StepPath> skip(const StepSpan& which, bool skipped);
  /// Consecutive changes of one step are undone together, like a typed word.
  std::optional<StepPath> replace(const StepPath& at, Step::Body body);
  /// Replaces everything but the steps: one change too.
  void replace_frame(Sequence frame);

  [[nodiscard]] bool can_undo() const { return !done_.empty(); }
  [[nodiscard]] bool can_redo() const { return !undone_.empty(); }
  void undo();
  void redo();

 private:
  /// The difference of two consecutive sequences: only the steps that changed.
  struct Change {
    std::size_t at = 0;  ///< in the outermost list
    StepList was, is;
    std::optional<Sequence> frame_was, frame_is;  ///< without steps; none: unchanged
  };
  static Change between(const Sequence& was, const Sequence& is);
  [[nodiscard]] bool holds(const StepSpan& which) const;
  /// False: no change.
  bool keep(Sequence changed, const StepPath* typed_at = nullptr);
  /// Undoes or redoes the newest change of `from` and moves it to `to`.
  void go(std::vector<Change>& from, std::vector<Change>& to, bool back);

  std::shared_ptr<const Sequence> now_;
  std::vector<Change> done_, undone_;
  std::optional<StepPath> typed_at_;  ///< of the latest change, if a replace()
  std::uint64_t version_ = 0, loads_ = 0;
};

}  // namespace hw::sequence
