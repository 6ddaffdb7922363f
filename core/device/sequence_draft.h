#pragma once
// What the writers of all languages share while they make text of a sequence: which step is at hand, which
// axis of the controller is meant and how many of its steps, and where its axes stand by then.
//
// A writer has a function write(const X&) for each kind of step; write_steps() calls them in turn.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/refused_steps.h"
#include "core/device/sequence_text.h"
#include "core/sequence/steps_in.h"

namespace hw {

/// In steps of one axis. 0: as the controller has it.
struct StepSpeeds {
  std::int64_t high = 0, low = 0;
  double ramp_ms = 0;
  bool operator==(const StepSpeeds&) const = default;
};

/// Of one axis.
struct StepStairs {
  struct Stair {
    std::int64_t until, speed;
  };
  Sign direction = Sign::plus;
  std::vector<Stair> stairs{};
  std::int64_t stop_at = 0;
};

class SequenceDraft {
 public:
  SequenceDraft(const sequence::Sequence& sequence, const Catalog& catalog)
      : sequence(sequence), catalog(catalog) {}
  /// Before anything else. The fault names an axis that the controller does not have.
  [[nodiscard]] Result<> find_axes();

  const sequence::Sequence& sequence;
  const Catalog& catalog;

  // ---- the step at hand
  void enter(const sequence::Step& step, std::size_t place);
  void leave();
  /// From here on the steps of a routine ("Pen up") are entered; its lines are of the step at hand. Refused
  /// within a routine: the tool is no part of its own routines.
  [[nodiscard]] Result<> begin_routine(std::string_view name);
  void end_routine();
  [[nodiscard]] bool in_routine() const { return !routine_.empty(); }
  [[nodiscard]] tl::unexpected<Fault> refuse_tool() const {
    return refuse("the tool is no part of its own routines.");
  }
  /// "Step 3.2 (arc): a VXM draws no arcs."
  [[nodiscard]] tl::unexpected<Fault> refuse(std::string_view why) const;
  /// Of a field: its key in files. `nearest`: what it could be.
  [[nodiscard]] tl::unexpected<Fault> refuse_field(std::string field, std::string_view why,
                                                   std::optional<double> nearest = {}) const;
  /// A motion that goes at the controller's own speed, behind one that has changed it.
  [[nodiscard]] tl::unexpected<Fault> refuse_own_speed() const;
  void remark(std::string_view what);

  // ---- steps that are refused
  /// From here on they are collected, with a comment behind `mark` in the place of each.
  void collect_refused(std::vector<RefusedStep>* refused, std::string_view mark) {
    refused_ = refused, comment_mark_ = mark;
  }
  /// How things stand before a step is entered.
  struct Before {
    std::size_t depth, lines;
    int indent, part;
    std::array<std::optional<std::int64_t>, max_axes> at;
  };
  [[nodiscard]] Before before() const { return {path_.size(), lines_.size(), indent_, part_, at_}; }
  /// Leaves the step at hand out, whose writer has answered with `fault`, and goes on as if it had been done.
  /// False: refused steps are not collected.
  bool pass_over(const sequence::Step& step, const Fault& fault, const Before& before);

  // ---- the text
  void line(std::string_view text);
  /// Each line of it, behind `mark`.
  void lines(std::string_view text, std::string_view mark = {});
  /// Ahead of all: a comment behind `mark` that names the outputs which switch its tool off, where it has
  /// any. Refused where a stop would switch it on.
  /// `aside`: what else is to be known of a tool on this controller.
  [[nodiscard]] Result<> tool_line(std::string_view mark, std::string_view aside = {});
  void indent(int by) { indent_ += by; }
  /// Lines go into this part from now on; parts stand one behind the other. Returns the part so far.
  int change_part(int part) { return std::exchange(part_, part); }
  [[nodiscard]] int part() const { return part_; }
  [[nodiscard]] SequenceText finish() &&;

  // ---- axes, from a place in Sequence::axes
  [[nodiscard]] AxisId axis(int place) const { return axes_[ix(place)]; }
  [[nodiscard]] const std::string& name(int place) const { return catalog.axes[axis(place).index].name; }
  [[nodiscard]] int axis_count() const { return static_cast<int>(sequence.axes.size()); }
  /// A position; a distance may be twice as long.
  [[nodiscard]] Result<std::int64_t> position(int place, double units) const;
  [[nodiscard]] Result<std::int64_t> distance(int place, double units) const;
  [[nodiscard]] Result<StepSpeeds> speeds(int place, const sequence::Speeds& units) const;
  /// Of a motion of this axis: what is its own, else what speed steps have said.
  [[nodiscard]] Result<StepSpeeds> speeds_of(int place, const sequence::OwnSpeeds& own) const;
  /// Checked: they go one way, from where the axis stands by then if that is known.
  [[nodiscard]] Result<StepStairs> stairs(const sequence::SpeedStairs& stairs) const;
  void say_speeds(const sequence::Speeds& units) { speeds_now_ = over(speeds_now_, units); }
  /// Where steps are written that are carried out elsewhere: nothing is said there that they do not say
  /// themselves. Returns those so far.
  sequence::Speeds change_speeds(const sequence::Speeds& units) { return std::exchange(speeds_now_, units); }
  /// Whether all axes have equally many steps in a unit.
  [[nodiscard]] bool all_alike() const;
  /// Both axes of it.
  [[nodiscard]] bool has(const sequence::Plane& plane) const {
    return std::max(plane.right, plane.up) < axis_count();
  }
  /// Whether its axes have equally many: otherwise its circles are ellipses.
  [[nodiscard]] bool alike(const sequence::Plane& plane) const {
    return sequence.axes[ix(plane.right)].per_unit == sequence.axes[ix(plane.up)].per_unit;
  }

  // ---- where the axes stand, in steps, once the motions so far have ended
  [[nodiscard]] std::optional<std::int64_t> at(int place) const { return at_[ix(place)]; }
  void stands(int place, std::optional<std::int64_t> position) { at_[ix(place)] = position; }
  void nothing_known() { at_ = {}; }
  /// What the steps of a loop move stands elsewhere when it begins anew.
  void forget_what_moves(const sequence::StepList& steps);

  /// Of the maker's number: its place in the catalog.
  [[nodiscard]] Result<int> input(int number) const;
  [[nodiscard]] Result<int> output(int number) const;

 private:
  [[nodiscard]] Result<std::int64_t> steps_of(int place, double units, double low, double high) const;
  /// The key of the field that says where an axis goes.
  [[nodiscard]] std::string place_field(int place) const;
  [[nodiscard]] std::string numbers() const;  ///< of the step at hand: "3.2"
  void as_if_moved(const sequence::Move& move);

  [[nodiscard]] int index() const;
  static sequence::Speeds over(sequence::Speeds below, const sequence::Speeds& above);

  sequence::Speeds speeds_now_;
  std::array<AxisId, max_axes> axes_{};
  std::array<std::optional<std::int64_t>, max_axes> at_{};
  struct Entered {
    const sequence::Step* step;
    std::size_t place;
    int index;  ///< as SequenceText counts them
  };
  std::vector<Entered> path_, path_outside_;
  std::string_view routine_;  ///< empty: none
  int next_index_ = 0;
  int indent_ = 0, part_ = 0;
  struct Line {
    int part;
    int index;
    std::string text;
  };
  std::vector<Line> lines_;
  std::vector<std::string> remarks_;
  std::string tool_;
  std::vector<RefusedStep>* refused_ = nullptr;  ///< null: the first one is the end
  std::string_view comment_mark_;
  mutable RefusedStep latest_;  ///< what refuse_field() knows beside its sentence
};

/// What texts call them, too, so that they are known again.
constexpr std::string_view routine_name(bool down) { return down ? "Pen down" : "Pen up"; }

/// "arc", as files call it.
std::string_view kind_of(const sequence::Step& step);
/// What refuse_own_speed() says.
inline constexpr std::string_view no_own_speed =
    "a step before it has changed the speed, and none says what it is otherwise.";
/// Whose refusal it is, by the places of the lists that it stands in; none: that of no step of the list.
std::optional<std::vector<std::size_t>> refused_step(std::string_view what);

/// `writer` writes each step that is not skipped.
template <class Writer>
Result<> write_steps(Writer& writer, SequenceDraft& draft, const sequence::StepList& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const SequenceDraft::Before before = draft.before();
    draft.enter(steps[i], i);
    Result<> written;
    if (!steps[i].skipped)
      written = std::visit([&writer](const auto& body) { return writer.write(body); }, steps[i].body);
    if (!written && !draft.pass_over(steps[i], written.error(), before)) return written;
    draft.leave();
  }
  return {};
}

}  // namespace hw
