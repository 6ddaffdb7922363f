#pragma once
// How the user's session ended without him (a signal, a logout, a display that went away), and what became of
// the controllers: written into the state folder, told at the next start, then forgotten.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct LastEnd {
  enum class Fate : int {
    at_rest,    ///< it was stopped, and seen to rest
    told,       ///< the stop went out; that it rests was not seen
    not_told,   ///< no stop could be sent
    left_alone  ///< somebody else had begun it
  };
  struct Controller {
    std::string name, what;  ///< "Table"; "axis X was moving"
    Fate fate = Fate::told;
    bool operator==(const Controller&) const = default;
  };
  std::string date, time;  ///< "2026-11-23", "14:02:11"
  std::string how;         ///< "SIGTERM"
  std::vector<Controller> controllers;
  bool operator==(const LastEnd&) const = default;

  /// For a person who starts it on `today`.
  [[nodiscard]] std::string sentence(const std::string& today) const;
  /// All of them are known to rest, or were left alone.
  [[nodiscard]] bool harmless() const;
};

class LastEnds {
 public:
  explicit LastEnds(UserFolders folders) : folders_(std::move(folders)) {}
  /// Beside those that nobody has read yet; in the place of one of the same date, time and way.
  Result<> keep(const LastEnd& end) const;
  /// Oldest first; they are forgotten. A damaged file: a fault, the file is put aside.
  [[nodiscard]] Result<std::vector<LastEnd>> take() const;

 private:
  [[nodiscard]] Result<std::vector<LastEnd>> read() const;
  [[nodiscard]] std::filesystem::path file() const { return folders_.state / "last-end.json"; }
  UserFolders folders_;
};

/// "2026-11-23", where the user is.
std::string date_of_today();

}  // namespace hw
