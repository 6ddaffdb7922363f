#pragma once
// Whether a motion or program of a controller was begun through this session: the session has sent a command
// that may move since the controller last rested. Anything begun by others (its front panel, another program)
// does not count.
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
  /// The intent is sent, or queued.
  void posted(const IntentBody& body);
  /// `busy`: an intent is queued or under way. `rounds_ended`: count of status rounds.
  void seen(const Snapshot& now, bool busy, std::uint64_t rounds_ended);

  // ---- any thread
  [[nodiscard]] bool any() const { return any_; }

 private:
  [[nodiscard]] bool may_move(const IntentBody& body);
  [[nodiscard]] bool only_asks(const std::string& text);

  const Catalog& catalog_;
  std::vector<CommandForm> harmless_, moving_;  ///< filled at the first text
  std::optional<std::uint64_t> rests_in_;       ///< the first status round that shows the result
  std::atomic<bool> any_{false};
};

}  // namespace hw
