#pragma once
// Dry runs of program texts, worked out beside the frame. The newest of each slot is kept with the text that
// it is of, so that the screen can say whether it still holds. GUI thread.
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/device/language.h"
#include "gui/worker.h"

namespace hw::gui {

class Rehearsals {
 public:
  struct Outcome {
    std::string text;  ///< what was rehearsed
    Result<Rehearsal> result;
  };

  /// Nothing happens while one is under way for this slot.
  void start(const Language& language, std::string text, RehearseOptions options, Worker& worker);
  [[nodiscard]] bool under_way(int slot) const { return running_.contains(slot); }
  /// Null: none yet.
  [[nodiscard]] const Outcome* of(int slot) const;
  /// First line (from 0) in which the present text differs from the rehearsed one; -1: none.
  [[nodiscard]] int older_than_line(int slot, std::string_view text) const;
  /// Changes with each result.
  [[nodiscard]] int version() const { return version_; }

 private:
  std::map<int, Outcome> outcomes_;
  std::map<int, bool> running_;
  int version_ = 0;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
