#pragma once
// Settings that are written for one motion, and put back behind it: at once, or as soon as a stop or a lost
// wire lets it.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class BorrowedSetting {
 public:
  /// `given_back` is told the name: it was read with the borrowed value, perhaps.
  BorrowedSetting(Conversation& talk, std::function<void(std::string_view name)> given_back)
      : talk_(talk), given_back_(std::move(given_back)) {}

  /// `shown`: what it is, as far as is known. What it is read as is what is put back.
  Task<Result<>> borrow(std::string name, std::int64_t value, std::optional<std::int64_t> shown);
  Task<Result<>> give_back();
  /// Before anything that it would act on, or store.
  Task<Result<>> give_back_first();
  [[nodiscard]] bool is_out() const { return !borrowed_.empty(); }
  /// Whoever has set it since the wire was lost is right.
  void leave_alone() {
    for (Borrowed& one : borrowed_) one.left_alone = true;
  }
  /// The controller has forgotten it.
  void forget() { borrowed_.clear(); }
  /// What somebody must do when the console goes now; empty: nothing.
  [[nodiscard]] std::string leaves_behind() const;

 private:
  struct Borrowed {
    std::string name;
    std::int64_t before, for_now;
    bool left_alone = false;
  };
  /// A stop that comes first leaves it among the borrowed.
  Task<Result<>> give_back_last();
  Task<Result<>> put_back(Borrowed setting);
  Conversation& talk_;
  std::function<void(std::string_view)> given_back_;
  std::vector<Borrowed> borrowed_;
};

}  // namespace hw::arcus
