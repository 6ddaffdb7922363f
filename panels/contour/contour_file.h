#pragma once
// Saves and opens the list of the contour panel: a sequence of one contour or staircase, which Blocks can
// open too.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/sequence/sequence.h"
#include "gui/shell/frame.h"
#include "gui/widgets/file_dialog.h"

namespace hw::panels {

/// Converts a sequence of one contour or staircase from steps to a unit of `per_step`.
sequence::Sequence in_unit(sequence::Sequence in_steps, double per_step, const std::string& unit);
/// The reverse: a sequence of one step, in steps of its axes. A fault if the file holds anything else.
Result<sequence::Sequence> only_step_of(const sequence::Sequence& sequence, const std::string& file);

class ContourFile {
 public:
  /// Draws Open and Save at the right end of the toolbar, or below it if they do not fit.
  void draw_buttons(gui::Frame& frame, std::string_view why_not_save, std::string_view name);
  /// Returns, once, the opened sequence in steps. A toast shows a fault.
  std::optional<sequence::Sequence> draw_open(gui::Frame& frame);
  /// Returns, once, the file to save to.
  std::optional<std::filesystem::path> draw_save(gui::Frame& frame) { return save_.draw(frame.ui); }
  void save(gui::Frame& frame, const std::filesystem::path& path, const sequence::Sequence& sequence);
  /// Returns true, once, when the list is in the file.
  bool take_saved();

 private:
  gui::FileDialog open_, save_;
  std::shared_ptr<bool> saved_ = std::make_shared<bool>(false);
};

}  // namespace hw::panels
