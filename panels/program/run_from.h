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

namespace hw::panels {

class RunFrom {
 public:
  /// `step`: as SequenceText counts them. `pass`: how often it was done before, which matters within a loop;
  /// none: that is not known. Where the rest cannot be run it is told why.
  void ask(gui::Frame& frame, const sequence::Sequence& of, int step, std::optional<int> pass);
  void draw_dialog(gui::Frame& frame, std::string_view where);
  /// While it is asked: where the tool would go first, in the units of the axes.
  [[nodiscard]] std::optional<drawing::Point3> goes_to(const gui::Frame& frame, const PathAxes& axes) const;

 private:
  struct Wanted {
    sequence::Rest rest;
    std::string begins;  ///< "step 6, Move to 2 400"
  };
  static Result<Wanted> wanted_of(const sequence::Sequence& of, int step, std::optional<int> pass);
  void say(const gui::Frame& frame, std::string_view begins);
  void run(gui::Frame& frame) const;

  bool asking_ = false;
  sequence::Rest rest_;
  SequenceText written_;
  std::string question_;
  bool replaces_ = false;         ///< a text that is in no file
  std::weak_ptr<void> go_ahead_;  ///< a stop while it is asked takes it away
};

/// Why nothing could be run from a place of a text now; empty: it could. `source`: of that text.
std::string_view why_not_run_from(const gui::Frame& frame, const gui::WrittenSequence* source);

}  // namespace hw::panels
