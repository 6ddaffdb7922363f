#pragma once
// The file dialog: a path to type (Tab completes, Up and Down move in the list), the folder's content, and
// errors in sentences. Modal; Esc closes.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/surface/ui.h"
#include "gui/widgets/text_field.h"

namespace hw::gui {

class FileDialog {
 public:
  /// `start`: a folder, or a file in the folder to show. `suffixes` like {".prg", ".txt"}: other files are
  /// hidden until asked for; empty: all are shown.
  void ask_open(std::string title, const std::filesystem::path& start,
                std::vector<std::string> suffixes = {});
  /// `start`: folder and suggested name. A name without suffix gets the first one.
  void ask_save(std::string title, const std::filesystem::path& start,
                std::vector<std::string> suffixes = {});
  [[nodiscard]] bool is_open() const { return open_; }
  /// Call in each frame. Returns the chosen path once; the dialog is then closed. Ids: `file/path`,
  /// `file/open`, `file/save`, `file/cancel`, `file/up`, `file/all`, `file/NAME`.
  std::optional<std::filesystem::path> draw(Ui& ui);
  /// The last folder shown.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Entry {
    std::string name, about;
    bool folder = false;
  };
  void start(std::string title, const std::filesystem::path& at, std::vector<std::string> suffixes,
             bool saving);
  void look_into(const std::filesystem::path& folder);
  void read_folder();
  void show_name(std::string_view name);
  [[nodiscard]] std::filesystem::path typed() const;
  [[nodiscard]] bool shown(std::string_view name, bool folder) const;
  std::optional<std::filesystem::path> accept();
  bool complete(std::string& text, std::size_t& cursor);
  bool walk(std::string& text, int direction);
  std::optional<std::filesystem::path> draw_head(Ui& ui);
  std::optional<std::filesystem::path> draw_list(Ui& ui, float height);
  std::optional<std::filesystem::path> draw_foot(Ui& ui);

  std::string title_, path_text_, sentence_;
  std::filesystem::path folder_, replaced_;
  std::vector<std::string> suffixes_;
  std::vector<Entry> entries_;
  LineHelp help_;
  int chosen_ = -1;
  bool open_ = false, saving_ = false, all_ = false, appeared_ = false, reveal_ = false;
};

}  // namespace hw::gui
