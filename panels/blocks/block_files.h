#pragma once
// Blocks and their file. Ids: `blocks/open`, `blocks/save`, `blocks/discard`.
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
  /// Draws the name and the buttons from ImGui's cursor to the right edge.
  void draw(gui::Frame& frame);
  void draw_dialogs(gui::Frame& frame);

 private:
  void ask_open();
  void ask_save(const gui::Frame& frame);
  void ask_or_open(gui::Frame& frame, const std::filesystem::path& path);
  static void open(gui::Frame& frame, const std::filesystem::path& path);
  static void save(gui::Frame& frame, const std::filesystem::path& path);

  gui::FileDialog open_, save_;
  std::filesystem::path to_open_;  ///< the file the question is about
  bool asking_open_ = false;
  std::string name_;                            ///< of the file, without its folder
  std::uint64_t named_at_ = ~std::uint64_t{0};  ///< BlockList::changes() when `name_` was made
};

}  // namespace hw::panels
