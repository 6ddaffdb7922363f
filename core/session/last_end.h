#pragma once
// How the user's session was ended from outside (a signal, a logout, a lost display), and what became of the
// controllers. Written to the state folder, shown at the next start, then deleted.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct LastEnd {
  enum class Outcome : int {
    at_rest,       ///< stopped, and seen at rest
    stop_sent,     ///< stop sent; not seen at rest
    no_stop_sent,  ///< no stop could be sent
    left_alone     ///< not begun by this session
  };
  struct Controller {
    std::string name, what;  ///< "Table"; "axis X was moving"
    Outcome outcome = Outcome::stop_sent;
    bool operator==(const Controller&) const = default;
  };
  std::string date, time;  ///< "2026-11-23", "14:02:11"
  std::string how;         ///< "SIGTERM"
  std::vector<Controller> controllers;
  bool operator==(const LastEnd&) const = default;

  /// For the user who starts the console on `today`.
  [[nodiscard]] std::string sentence(const std::string& today) const;
  /// All controllers are known to rest, or were left alone.
  [[nodiscard]] bool harmless() const;
};

class LastEnds {
 public:
  explicit LastEnds(UserFolders folders) : folders_(std::move(folders)) {}
  /// Adds to the unread ends; replaces one with the same `date`, `time` and `how`.
  Result<> keep(const LastEnd& end) const;
  /// Returns the kept ends, oldest first, and deletes them. A damaged file: a fault; the file is set aside.
  [[nodiscard]] Result<std::vector<LastEnd>> take() const;

 private:
  [[nodiscard]] Result<std::vector<LastEnd>> read() const;
  [[nodiscard]] std::filesystem::path file() const { return folders_.state / "last-end.json"; }
  UserFolders folders_;
};

/// "2026-11-23", local time.
std::string date_of_today();

}  // namespace hw
