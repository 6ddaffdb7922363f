#pragma once
// Shows the result of a rehearsal of the text: time, spans, verdict. It is a column beside the editor, or a
// line.
#include "gui/model/desk.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/icons.h"
#include "panels/program/io_lanes.h"

namespace hw::panels {

class RehearsalCard {
 public:
  /// Draws at ImGui's cursor, `width` and `height` logical. Returns true when the user asks for a new
  /// rehearsal from the present position.
  bool draw_column(gui::Frame& frame, int slot, float width, float height);
  /// Draws a line of 36. Returns true when a click asks for the column.
  bool draw_line(gui::Frame& frame, int slot, bool opened);

 private:
  void refresh(gui::Frame& frame, int slot);
  void refresh_caption(const gui::Frame& frame, int slot);
  void refresh_words(const gui::Frame& frame);
  void add_span(const gui::Frame& frame, const RehearsedAxis& axis);
  [[nodiscard]] bool begins_here() const { return outcome_->start.match == gui::StartMatch::here; }
  /// Whether the verdict on limits holds for the present axis positions.
  [[nodiscard]] bool judges_limits() const { return begins_here() && outcome_->scene.switches; }
  void draw_progress(gui::Frame& frame);
  void draw_axes(gui::Frame& frame);
  bool draw_verdict(gui::Frame& frame);
  bool draw_limits(gui::Frame& frame);
  struct Verdict {
    std::string_view words;
    gui::Icon mark;  ///< none: no verdict
  };
  [[nodiscard]] Verdict verdict(const gui::Frame& frame) const;
  void draw_sentences(gui::Frame& frame);
  void draw_events(gui::Frame& frame);

  // The words shown, rebuilt only when they change.
  int version_ = -1, slot_ = -1;
  std::string text_of_units_, units_now_;
  const gui::Rehearsals::Outcome* outcome_ = nullptr;
  std::string time_, fault_, sends_, spans_, stand_, assumed_, memory_;
  std::vector<std::string> stops_;
  struct Axis {
    std::string name, span;
  };
  std::vector<Axis> axes_;
  std::vector<std::string> event_times_;
  std::vector<IoLane> lanes_;
  bool old_ = false, of_running_ = false;
  char caption_[48] = {};
  std::string_view shown_caption_;
};

}  // namespace hw::panels
