#pragma once
// Keeps unsaved program texts and blocks through a crash: written by atomic rename to the state folder during
// editing, offered when the same controller is opened again, deleted once saved.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct UnsavedText {
  static constexpr int of_blocks = -1;
  int slot = 0;  ///< of a program text, or of_blocks: a sequence in its file format
  std::string text;
  std::string path;  ///< source file; empty: none
  bool operator==(const UnsavedText&) const = default;
};

class Autosave {
 public:
  explicit Autosave(UserFolders folders) : folders_(std::move(folders)) {}
  [[nodiscard]] bool enabled() const { return folders_.enabled; }
  /// Replaces the texts kept for this controller; no texts: deletes the file. May block: for a worker.
  Result<> keep(std::string_view key, const std::vector<UnsavedText>& texts) const;
  /// The texts left by a crash (or a closed window). A damaged file: a fault; the file is set aside.
  [[nodiscard]] Result<std::vector<UnsavedText>> restore(std::string_view key) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
