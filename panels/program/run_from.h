#pragma once
// Runs the rest of a sequence, from a step on. Shows the way there, and sends no command before the user
// agrees. Ids: `WHERE/run_from/yes`, `WHERE/run_from/no`.
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
  /// The place to begin. `step` is counted as SequenceText counts steps. `pass` is how often the step was
  /// done before, which matters in a loop; nullopt: unknown.
  struct Place {
    int step = 0;
    std::optional<int> pass = {};
    /// The axes of its rehearsal. Empty: not rehearsed, so the steps are counted from the present position.
    std::span<const RehearsedAxis> axes = {};
    std::optional<std::array<RehearsedPlace, 2>> begun = {};  ///< nullopt: not known
  };
  /// Asks whether to run the rest. If it cannot be run, take_refusal() has the reason.
  void ask(gui::Frame& frame, const sequence::Sequence& of, const Place& place);
  /// As above for a typed text, which is read first.
  void ask(gui::Frame& frame, PlaceToBegin place);
  void draw_dialog(gui::Frame& frame, std::string_view where);
  /// The text of the last requested rest; empty: none.
  [[nodiscard]] const std::string& text() const { return written_.text; }
  /// Returns, once, why the last request was not carried out, for the panel to show; empty: it was, or is
  /// under way.
  [[nodiscard]] std::string take_refusal() { return std::exchange(refusal_, {}); }
  /// The first target of the tool while the question is open, in the units of the axes.
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
  bool replaces_ = false;         ///< true: replaces a text that is in no file
  std::weak_ptr<void> go_ahead_;  ///< expires on a stop while the question is open
};

}  // namespace hw::panels
