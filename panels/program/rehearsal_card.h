#pragma once
// What a dry run of the text came to: time, spans, verdict. As a column beside the editor, or as one line.
#include "gui/model/desk.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "gui/widgets/icons.h"

namespace hw::panels {

class RehearsalCard {
 public:
  /// At ImGui's cursor, `width` and `height` logical. True: it is to be rehearsed again, from here.
  bool draw_column(gui::Frame& frame, int slot, float width, float height);
  /// One line of 36. True: a click wants the column.
  bool draw_line(gui::Frame& frame, int slot, bool opened);

 private:
  void refresh(gui::Frame& frame, int slot);
  void refresh_caption(const gui::Frame& frame, int slot);
  void refresh_words(const gui::Frame& frame);
  void say_span(const gui::Frame& frame, const RehearsedAxis& axis);
  [[nodiscard]] bool begins_here() const { return outcome_->stand.footing == gui::Footing::here; }
  /// What it says of limits holds for the axes as they stand.
  [[nodiscard]] bool judges_limits() const { return begins_here() && outcome_->scene.switches; }
  void draw_progress(gui::Frame& frame);
  void draw_axes(gui::Frame& frame);
  bool draw_verdict(gui::Frame& frame);
  bool draw_limits(gui::Frame& frame);
  struct Verdict {
    std::string_view words;
    gui::Icon mark;  ///< none: there is nothing to be said for or against
  };
  [[nodiscard]] Verdict verdict(const gui::Frame& frame) const;
  void draw_sentences(gui::Frame& frame);
  void draw_events(gui::Frame& frame);

  // What is shown, made anew only when it changes.
  int version_ = -1, slot_ = -1;
  std::string text_of_units_, units_now_;
  const gui::Rehearsals::Outcome* outcome_ = nullptr;
  std::string time_, fault_, sends_, spans_, stand_, assumed_;
  std::vector<std::string> stops_;
  struct Axis {
    std::string name, span;
  };
  std::vector<Axis> axes_;
  std::vector<std::string> event_times_;
  bool old_ = false, of_running_ = false;
  char caption_[48] = {};
  std::string_view said_caption_;
};

}  // namespace hw::panels
