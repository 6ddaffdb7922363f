#pragma once
// The list of the contour panel as a file: a sequence of one step, a contour or a staircase, that Blocks
// opens too.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"
#include "gui/widgets/file_dialog.h"

namespace hw::panels {

/// A sequence of one contour or staircase in a unit of `per_step`, from one in steps.
sequence::Sequence in_unit(sequence::Sequence in_steps, double per_step, const std::string& unit);
/// Back: one step, whose numbers are steps of its axes. Whatever else the file would do is a fault.
Result<sequence::Sequence> only_step_of(const sequence::Sequence& sequence, const std::string& file);

class ContourFile {
 public:
  /// Open and Save at the right end of the toolbar, or below where there is no room.
  void draw_buttons(gui::Frame& frame, std::string_view why_not_save, std::string_view name);
  /// What was opened, once, in steps; a fault is told as a toast.
  std::optional<sequence::Sequence> draw_open(gui::Frame& frame);
  /// Where to, once.
  std::optional<std::filesystem::path> draw_save(gui::Frame& frame) { return save_.draw(frame.ui); }
  void save(gui::Frame& frame, const std::filesystem::path& path, const sequence::Sequence& sequence);
  /// Once: it is in the file.
  bool take_saved();

 private:
  gui::FileDialog open_, save_;
  std::shared_ptr<bool> saved_ = std::make_shared<bool>(false);
};

}  // namespace hw::panels
