#pragma once
// Shared state of all language writers: the present step, the conversion to the controller's axes and steps,
// and the positions of the axes before the step.
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

/// In steps of one axis. 0: as the controller is set up.
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
  /// To be called first. The fault names an axis that the controller lacks.
  [[nodiscard]] Result<> find_axes();

  const sequence::Sequence& sequence;
  const Catalog& catalog;

  // ---- the present step
  void enter(const sequence::Step& step, std::size_t place);
  void leave();
  /// Enters a routine ("Pen up"); its lines belong to the present step. Refused within a routine: the tool
  /// cannot be part of its own routines.
  [[nodiscard]] Result<> begin_routine(std::string_view name);
  void end_routine();
  [[nodiscard]] bool in_routine() const { return !routine_.empty(); }
  [[nodiscard]] tl::unexpected<Fault> refuse_tool() const {
    return refuse("the tool cannot be part of its own routines.");
  }
  [[nodiscard]] tl::unexpected<Fault> refuse_no_axis() const { return refuse("it moves no axis."); }
  /// `what`: "an arc" or "a contour".
  [[nodiscard]] tl::unexpected<Fault> refuse_single_axis(std::string_view what) const;
  [[nodiscard]] tl::unexpected<Fault> refuse_unknown_start() const;
  /// The controller has fewer outputs than `value` has bits.
  [[nodiscard]] tl::unexpected<Fault> refuse_outputs(std::size_t count, std::uint32_t value,
                                                     std::string_view kind = "outputs") const;
  /// A step that no contour holds.
  [[nodiscard]] tl::unexpected<Fault> refuse_in_contour() const {
    return refuse("a contour can hold only moves, arcs and outputs.");
  }
  /// "Step 3.2 (arc): a VXM draws no arcs."
  [[nodiscard]] tl::unexpected<Fault> refuse(std::string_view why) const;
  /// Refuses a field by its key in files. `nearest`: the nearest possible value.
  [[nodiscard]] tl::unexpected<Fault> refuse_field(std::string field, std::string_view why,
                                                   std::optional<double> nearest = {}) const;
  /// Refuses a motion at the controller's own speed after one that has changed it.
  [[nodiscard]] tl::unexpected<Fault> refuse_own_speed() const;
  void remark(std::string_view what);

  // ---- steps that are refused
  /// Collects refused steps from here on, with a comment behind `mark` in place of each.
  void collect_refused(std::vector<RefusedStep>* refused, std::string_view mark) {
    refused_ = refused, comment_mark_ = mark;
  }
  /// The state before a step is entered.
  struct Before {
    std::size_t depth, lines;
    int indent, part;
    std::array<std::optional<std::int64_t>, max_axes> at;
  };
  [[nodiscard]] Before before() const { return {path_.size(), lines_.size(), indent_, part_, at_}; }
  /// Leaves out the present step, refused with `fault`, and continues as if it had been done. False: refused
  /// steps are not collected.
  bool pass_over(const sequence::Step& step, const Fault& fault, const Before& before);

  // ---- the text
  void line(std::string_view text);
  /// Each line of it, behind `mark`.
  void lines(std::string_view text, std::string_view mark = {});
  /// Puts a comment behind `mark` in front that names the outputs which switch the tool off, if any. Refused
  /// if a stop would switch it on.
  /// `aside`: a further remark about tools on this controller.
  [[nodiscard]] Result<> tool_line(std::string_view mark, std::string_view aside = {});
  void indent(int by) { indent_ += by; }
  /// Lines go into this part from now on; parts follow each other in the text. Returns the previous part.
  int change_part(int part) { return std::exchange(part_, part); }
  [[nodiscard]] int part() const { return part_; }
  [[nodiscard]] SequenceText finish() &&;

  // ---- axes, by their place in Sequence::axes
  [[nodiscard]] AxisId axis(int place) const { return axes_[ix(place)]; }
  [[nodiscard]] const std::string& name(int place) const { return catalog.axes[axis(place).index].name; }
  [[nodiscard]] int axis_count() const { return static_cast<int>(sequence.axes.size()); }
  /// A position; a distance may be twice as long.
  [[nodiscard]] Result<std::int64_t> position(int place, double units) const;
  [[nodiscard]] Result<std::int64_t> distance(int place, double units) const;
  [[nodiscard]] Result<StepSpeeds> speeds(int place, const sequence::Speeds& units) const;
  /// Speeds of a motion of this axis: its own, else those of the speed steps.
  [[nodiscard]] Result<StepSpeeds> speeds_of(int place, const sequence::OwnSpeeds& own) const;
  /// Checks that the stairs go in one direction, from the place of the axis before them if it is known.
  [[nodiscard]] Result<StepStairs> stairs(const sequence::SpeedStairs& stairs) const;
  void set_speeds(const sequence::Speeds& units) { speeds_now_ = over(speeds_now_, units); }
  /// For steps that run elsewhere and cannot rely on earlier speeds. Returns the speeds so far.
  sequence::Speeds change_speeds(const sequence::Speeds& units) { return std::exchange(speeds_now_, units); }
  /// Whether all axes have the same steps per unit.
  [[nodiscard]] bool all_alike() const;
  /// The controller has both axes of the plane.
  [[nodiscard]] bool has(const sequence::Plane& plane) const {
    return std::max(plane.right, plane.up) < axis_count();
  }
  /// Whether its axes have the same steps per unit: otherwise circles are ellipses.
  [[nodiscard]] bool alike(const sequence::Plane& plane) const {
    return sequence.axes[ix(plane.right)].per_unit == sequence.axes[ix(plane.up)].per_unit;
  }

  // ---- where the axes are, in steps, after the motions so far
  [[nodiscard]] std::optional<std::int64_t> at(int place) const { return at_[ix(place)]; }
  void stands(int place, std::optional<std::int64_t> position) { at_[ix(place)] = position; }
  void nothing_known() { at_ = {}; }
  /// Forgets the places of axes that the steps of a loop move: they differ in the next pass.
  void forget_moved_axes(const sequence::StepList& steps);

  /// The place in the catalog of the maker's number.
  [[nodiscard]] Result<int> input(int number) const;
  [[nodiscard]] Result<int> output(int number) const;

 private:
  [[nodiscard]] Result<std::int64_t> steps_of(int place, double units, double low, double high) const;
  /// The key of the field with the target of an axis.
  [[nodiscard]] std::string place_field(int place) const;
  [[nodiscard]] std::string numbers() const;  ///< of the present step: "3.2"
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
  std::vector<RefusedStep>* refused_ = nullptr;  ///< null: parts_ has only the first
  std::string_view comment_mark_;
  mutable RefusedStep latest_;  ///< details of refuse_field()
};

/// Also used in texts, so that readers recognise them.
constexpr std::string_view routine_name(bool down) { return down ? "Pen down" : "Pen up"; }

/// "arc", as files call it.
std::string_view kind_of(const sequence::Step& step);
/// The sentence of refuse_own_speed().
inline constexpr std::string_view no_own_speed =
    "an earlier step has changed the speed, and no other step sets it.";
/// The step of a refusal, by its places in the nested lists; none: not of a step.
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
