#pragma once
// Program texts and blocks that are in no file yet survive a crash: written by atomic rename into the state
// folder while they are edited, offered again when the same controller is opened, forgotten when they are
// saved.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct UnsavedText {
  static constexpr int of_blocks = -1;
  int slot = 0;  ///< of a program text, or of_blocks: a sequence as its file would hold it
  std::string text;
  std::string path;  ///< the file it came from; empty: none
  bool operator==(const UnsavedText&) const = default;
};

class Autosave {
 public:
  explicit Autosave(UserFolders folders) : folders_(std::move(folders)) {}
  [[nodiscard]] bool enabled() const { return folders_.enabled; }
  /// Replaces what was kept for this controller; nothing unsaved: the file goes. May block: for a worker.
  Result<> keep(std::string_view key, const std::vector<UnsavedText>& texts) const;
  /// What a crash (or a closed window) left. A damaged file: a fault, the file is put aside.
  [[nodiscard]] Result<std::vector<UnsavedText>> restore(std::string_view key) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
