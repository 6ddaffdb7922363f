#pragma once
// Whether what moves or runs in a controller was begun through this session: something that sets in motion
// has gone out since it last rested. What somebody else begins (its front panel, another program) is not.
#include <atomic>
#include <optional>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/command_form.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw {

class BegunHere {
 public:
  /// The catalog outlives it.
  explicit BegunHere(const Catalog& catalog) : catalog_(catalog) {}

  // ---- io thread
  /// It goes out, or waits to.
  void posted(const IntentBody& body);
  /// What is known now. `busy`: something waits to be sent, or is under way; `rounds_ended`: of status.
  void seen(const Snapshot& now, bool busy, std::uint64_t rounds_ended);

  // ---- any thread
  [[nodiscard]] bool any() const { return any_; }

 private:
  [[nodiscard]] bool may_move(const IntentBody& body);
  [[nodiscard]] bool only_asks(const std::string& text);

  const Catalog& catalog_;
  std::vector<CommandForm> harmless_, moving_;  ///< made when the first text comes
  std::optional<std::uint64_t> rests_in_;       ///< the first round of status that shows what came of it
  std::atomic<bool> any_{false};
};

}  // namespace hw
