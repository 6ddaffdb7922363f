#pragma once
// Running the rest of a sequence, from one of its steps on: what leads there is shown, and nothing is done
// before it is agreed to. Ids: `WHERE/run_from/yes`, `WHERE/run_from/no`.
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/sequence/rest.h"
#include "gui/model/program_source.h"
#include "panels/path/path_subject.h"
#include "panels/program/rest_of_text.h"

namespace hw::panels {

class RunFrom {
 public:
  /// Where it is to begin. `step`: as SequenceText counts them. `pass`: how often it was done before, which
  /// matters within a loop; none: that is not known.
  struct Place {
    int step = 0;
    std::optional<int> pass = {};
    /// Of its rehearsal. No axes: there was none, and the steps are counted from where the axes stand.
    std::span<const RehearsedAxis> axes = {};
    std::optional<std::array<RehearsedPlace, 2>> begun = {};  ///< none: it does not tell
  };
  /// Where the rest cannot be run it is told why.
  void ask(gui::Frame& frame, const sequence::Sequence& of, const Place& place);
  /// The same of a text that somebody has typed, once it has been read.
  void ask(gui::Frame& frame, PlaceToBegin place);
  void draw_dialog(gui::Frame& frame, std::string_view where);
  /// While it is asked: where the tool would go first, in the units of the axes.
  [[nodiscard]] std::optional<drawing::Point3> goes_to(const gui::Frame& frame, const PathAxes& axes) const;

 private:
  struct Wanted {
    sequence::Rest rest;
    std::string begins;  ///< "step 6, Move to 2 400"
    std::string text{};  ///< that was read; empty: it is of blocks or a drawing
    std::vector<RehearsedAxis> axes{};
    bool counts_from_now = false;  ///< elsewhere it would begin elsewhere
  };
  void ask(gui::Frame& frame, Result<Wanted> wanted);
  static Result<Wanted> wanted_of(const sequence::Sequence& of, const Place& place,
                                  const sequence::Places& begin);
  void say(const gui::Frame& frame, const Wanted& wanted);
  void run(gui::Frame& frame) const;

  bool asking_ = false, reading_ = false;
  std::optional<Result<Wanted>> read_;  ///< has come from the worker
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  sequence::Rest rest_;
  SequenceText written_;
  std::string question_;
  bool replaces_ = false;         ///< a text that is in no file
  std::weak_ptr<void> go_ahead_;  ///< a stop while it is asked takes it away
};

/// Why nothing could be run from any place of a text now; empty: it may be asked for.
std::string_view why_not_run_from(const gui::Frame& frame);

}  // namespace hw::panels
