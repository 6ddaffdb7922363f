#pragma once
// The last connections, newest first.
#include <string>
#include <vector>

#include "core/session/user_files.h"

namespace hw {

struct RecentConnection {
  std::string address;  ///< canonical
  std::string name;     ///< the user's name for the controller
  bool operator==(const RecentConnection&) const = default;
};

class RecentConnections {
 public:
  explicit RecentConnections(UserFolders folders) : folders_(std::move(folders)) {}
  /// A damaged file: a fault, the file is put aside and the list is empty.
  Result<> load();
  /// To the front; an older entry of the same address goes. An empty name keeps the older entry's.
  Result<> opened(std::string address, std::string name);
  /// By hand, while the console goes on: it is not among what is opened again at once.
  Result<> closed(std::string_view address);
  Result<> renamed(std::string_view address, std::string name);
  Result<> remove(std::string_view address);
  [[nodiscard]] const std::vector<RecentConnection>& list() const { return list_; }
  /// What the last run of the console that opened anything has opened, newest first: it can all be opened
  /// again at once. What was removed or closed since is not among it.
  [[nodiscard]] const std::vector<std::string>& last_time() const { return last_time_; }
  [[nodiscard]] bool is_of_last_time(std::string_view address) const;

  static constexpr std::size_t capacity = 12;

 private:
  [[nodiscard]] Result<> save() const;
  UserFolders folders_;
  std::vector<RecentConnection> list_;
  std::vector<std::string> last_time_, this_time_;  ///< addresses
};

}  // namespace hw
