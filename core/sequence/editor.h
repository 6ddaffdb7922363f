#pragma once
// A sequence under a hand: each change of its list is one that can be taken back. Pure; for the GUI thread.
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/sequence/sequence.h"

namespace hw::sequence {

/// Its place in the list; for a step within another, the place of that one before it.
using StepPath = std::vector<std::size_t>;

/// Steps of one list that follow each other.
struct StepSpan {
  StepPath first;
  std::size_t count = 1;
  StepSpan(StepPath at, std::size_t many = 1) : first(std::move(at)), count(many) {}  // NOLINT: a step is one
  StepSpan(std::initializer_list<std::size_t> at) : first(at) {}
};
/// From one place to another, whichever comes first: as many of the list that both stand in, or the steps
/// that they stand in, as it takes.
StepSpan span_between(const StepPath& one, const StepPath& other);

/// A step as a row of the whole list, loops entered.
struct StepRow {
  StepPath path;
  const Step* step = nullptr;
};

class Editor {
 public:
  Editor() : now_(std::make_shared<const Sequence>()) {}

  [[nodiscard]] const Sequence& sequence() const { return *now_; }
  /// The same, for whoever needs it as it is now: another thread.
  [[nodiscard]] std::shared_ptr<const Sequence> shared() const { return now_; }
  /// Another one, with nothing to be taken back.
  void load(Sequence sequence);
  /// Another one, in a change that can be taken back.
  void exchange(Sequence sequence);
  /// Changes whenever the sequence does.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Grows with each load() and exchange(): what is remembered of places in the list does not hold any more.
  [[nodiscard]] std::uint64_t loads() const { return loads_; }
  /// In the order of the list; valid until the next change.
  [[nodiscard]] std::vector<StepRow> rows() const;
  /// Null: nothing stands there.
  [[nodiscard]] const Step* at(const StepPath& path) const;

  // Each of these answers where the step, or the first of several, stands then; nothing when there is no such
  // place, or when loops would stand in loops deeper than a file may hold (deepest_loop). Each is one change.
  std::optional<StepPath> insert(const StepPath& at, Step step);
  std::optional<StepPath> remove(const StepSpan& which);  ///< where the next one stands, or the last
  /// In front of what stands at `to` before the move; never into themselves.
  std::optional<StepPath> move(const StepSpan& from, const StepPath& to);
  std::optional<StepPath> duplicate(const StepSpan& which);  ///< behind them
  /// They become a loop with themselves in it.
  std::optional<StepPath> put_into_loop(const StepSpan& which);
  /// The steps of a loop take its place.
  std::optional<StepPath> take_out_of_loop(const StepPath& at);
  std::optional<StepPath> skip(const StepSpan& which, bool skipped);
  /// Changes of one step that follow each other are one to be taken back, as a word that is typed.
  std::optional<StepPath> replace(const StepPath& at, Step::Body body);
  /// All that is no step: unit, axes, the tool's routines.
  void set_frame(std::string unit, std::vector<Axis> axes, StepList pen_up, StepList pen_down);

  [[nodiscard]] bool can_undo() const { return !done_.empty(); }
  [[nodiscard]] bool can_redo() const { return !undone_.empty(); }
  void undo();
  void redo();

 private:
  /// What differs between two that follow each other: of many steps a change keeps those that it is about.
  struct Change {
    std::size_t at = 0;  ///< in the outermost list
    StepList was, is;
    std::optional<Sequence> frame_was, frame_is;  ///< without steps; none: it is the same
  };
  static Change between(const Sequence& was, const Sequence& is);
  [[nodiscard]] bool holds(const StepSpan& which) const;
  /// False: nothing has changed.
  bool keep(Sequence changed, const StepPath* typed_at = nullptr);
  /// Takes the newest change of one list back, or makes it again, and puts it into the other.
  void go(std::vector<Change>& from, std::vector<Change>& to, bool back);

  std::shared_ptr<const Sequence> now_;
  std::vector<Change> done_, undone_;
  std::optional<StepPath> typed_at_;  ///< of the latest change, where it was a replacement
  std::uint64_t version_ = 0, loads_ = 0;
};

}  // namespace hw::sequence
