#pragma once
// Opens and saves blocks. Ids: `blocks/open`, `blocks/save`, `blocks/discard`.
#include <cstdint>
#include <filesystem>
#include <string>

#include "gui/shell/frame.h"
#include "gui/widgets/file_dialog.h"

namespace hw::panels {

class BlockFiles {
 public:
  /// Call once a frame. Handles files dropped on the window, and the chords.
  void follow(gui::Frame& frame);
  /// Draws the name and the buttons from ImGui's cursor to the right edge. `wordless`: the buttons are icons.
  void draw(gui::Frame& frame, bool wordless);
  /// Width of the buttons, logical.
  [[nodiscard]] static float width(const gui::Ui& ui, bool wordless);
  /// Whether the name did not fit there, so that draw_name() must draw it elsewhere.
  [[nodiscard]] bool wants_room() const { return !has_room_ && !name_.empty(); }
  /// Draws the name between `left` and `right` (pixels), cut if it is too long.
  void draw_name(const gui::Frame& frame, float left, float right, float middle) const;
  void draw_dialogs(gui::Frame& frame);

 private:
  void ask_open();
  void ask_save(const gui::Frame& frame);
  void ask_or_open(gui::Frame& frame, const std::filesystem::path& path);
  static void open(gui::Frame& frame, const std::filesystem::path& path);
  static void save(gui::Frame& frame, const std::filesystem::path& path);

  gui::FileDialog open_, save_;
  std::filesystem::path to_open_;  ///< the file that the question is about
  bool asking_open_ = false, has_room_ = false;
  std::string name_;                            ///< name of the file, without its folder
  std::uint64_t named_at_ = ~std::uint64_t{0};  ///< BlockList::changes() when `name_` was made
};

}  // namespace hw::panels
