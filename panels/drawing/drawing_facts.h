#pragma once
// Shows the facts of a drawing: its duration, number of moves, drawn length, and omissions. Ids:
// `drawing/problem`, `drawing/progress`, `drawing/off`, `drawing/time`, `drawing/moves`, `drawing/drawn`,
// `drawing/travel`, `drawing/saved`, `drawing/saved/untimed`, `drawing/size`, `drawing/chains`,
// `drawing/remarks`, `drawing/left_out`, `drawing/understood`.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/drawing/drawing_job.h"

namespace hw::panels {

class DrawingFacts {
 public:
  /// Call once a frame.
  void follow(const DrawingJob& job, const ConversionOptions& wanted);
  /// Draws at ImGui's cursor.
  void draw(gui::Frame& frame, const DrawingJob& job);
  void draw_left_out(gui::Frame& frame);
  /// The duration; empty while unknown.
  [[nodiscard]] std::string_view time() const { return time_; }
  /// The number of moves in the whole drawing.
  [[nodiscard]] std::size_t moves() const { return count_; }

 private:
  static void draw_remarks(gui::Frame& frame, const std::vector<std::string>& remarks);
  static void draw_why_untimed(gui::Frame& frame);

  std::uint64_t shown_version_ = ~std::uint64_t{0};  ///< DrawingJob::version() for which the words were made
  std::size_t count_ = 0;
  std::string time_, moves_, drawn_, travel_, saved_, beside_, size_, chains_, off_, left_out_title_,
      problem_;
  bool untimed_ = false;     ///< saved_ has no time, because no speed with the tool off is given
  bool can_be_cut_ = false;  ///< the drawing can be cut, although problem_ says that no program can hold it
  std::vector<std::string> left_out_, understood_;
};

}  // namespace hw::panels
