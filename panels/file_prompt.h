#pragma once
// "Where?" for opening and saving, over the panel that asked.
#include <filesystem>
#include <optional>
#include <string>

#include "gui/ui.h"

namespace hw::panels {

class FilePrompt {
 public:
  void ask_open(std::string title, std::string suffix);
  void ask_save(std::string title, std::filesystem::path suggested);
  [[nodiscard]] bool open() const { return open_; }
  /// Each frame; the path once it was chosen.
  std::optional<std::filesystem::path> draw(gui::Ui& ui);

 private:
  bool open_ = false, saving_ = false;
  std::string title_, path_;
};

}  // namespace hw::panels
