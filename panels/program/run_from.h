#pragma once
// Running the rest of a sequence, from one of its steps on: shows the way there, and does nothing before the
// user agrees. Ids: `WHERE/run_from/yes`, `WHERE/run_from/no`.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/sequence/rest.h"
#include "gui/model/program_source.h"
#include "panels/path/path_subject.h"
#include "panels/program/rest_of_text.h"

namespace hw::panels {

class RunFrom {
 public:
  /// Where to begin. `step`: as SequenceText counts them. `pass`: how often it was done before, which matters
  /// within a loop; none: unknown.
  struct Place {
    int step = 0;
    std::optional<int> pass = {};
    /// Of its rehearsal. No axes: not rehearsed, and the steps are counted from the present position.
    std::span<const RehearsedAxis> axes = {};
    std::optional<std::array<RehearsedPlace, 2>> begun = {};  ///< none: not known
  };
  /// If the rest cannot be run, take_refusal() has the reason.
  void ask(gui::Frame& frame, const sequence::Sequence& of, const Place& place);
  /// The same for a typed text, once it has been read.
  void ask(gui::Frame& frame, PlaceToBegin place);
  void draw_dialog(gui::Frame& frame, std::string_view where);
  /// The text of the rest that was asked for last; empty: none.
  [[nodiscard]] const std::string& text() const { return written_.text; }
  /// Why the last request was not carried out, once: for the panel to show; empty: it was, or is under way.
  [[nodiscard]] std::string take_refusal() { return std::exchange(refusal_, {}); }
  /// The first target of the tool while the question stands, in the units of the axes.
  [[nodiscard]] std::optional<drawing::Point3> goes_to(const gui::Frame& frame, const PathAxes& axes) const;

 private:
  struct Wanted {
    sequence::Rest rest;
    std::string begins;  ///< "step 6, Move to 2 400"
    std::string text{};  ///< the text that was read; empty: from blocks or a drawing
    std::vector<RehearsedAxis> axes{};
    bool counts_from_now = false;  ///< the start depends on the present position
  };
  void ask(gui::Frame& frame, Result<Wanted> wanted);
  static Result<Wanted> wanted_of(const sequence::Sequence& of, const Place& place,
                                  const sequence::Places& begin);
  void refuse(std::string why) { refusal_ = std::move(why); }
  void compose_question(const gui::Frame& frame, const Wanted& wanted);
  void run(gui::Frame& frame);

  bool asking_ = false, reading_ = false;
  std::optional<Result<Wanted>> read_;  ///< result from the worker
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  sequence::Rest rest_;
  SequenceText written_;
  std::string question_, refusal_;
  bool replaces_ = false;         ///< replaces a text that is in no file
  std::weak_ptr<void> go_ahead_;  ///< expires on a stop while the question stands
};

/// Why a text cannot be run from any place now; empty: it may be asked for.
std::string_view why_not_run_from(const gui::Frame& frame);

}  // namespace hw::panels
