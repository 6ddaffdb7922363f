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
  /// A damaged file: a fault; the file is set aside and the list is empty.
  Result<> load();
  /// Puts the address first in place of its older entry. An empty name keeps the older entry's.
  Result<> opened(std::string address, std::string name);
  /// Closed by the user while the console runs on: removes the address from last_time().
  Result<> closed(std::string_view address);
  Result<> renamed(std::string_view address, std::string name);
  Result<> remove(std::string_view address);
  [[nodiscard]] const std::vector<RecentConnection>& list() const { return list_; }
  /// The addresses opened by the last run of the console that opened any, newest first, to be reopened
  /// together. Without those removed or closed since.
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
