#pragma once
// Limit switches, from the words of the status reply.
#include <cstdint>
#include <vector>

#include "core/devices/arcus/console.h"
#include "core/devices/arcus/conversation.h"
#include "core/devices/arcus/second_look.h"

namespace hw::arcus {

class LimitSwitches {
 public:
  LimitSwitches(const Console& console, Conversation& conversation)
      : console_(console), conversation_(conversation) {}

  /// Takes the words asked for at `asked_at`, unless newer ones are shown. Watchers are notified at once.
  void take(const std::vector<std::int64_t>& words, Instant asked_at);
  /// Until `until` the words are also read between the questions of a round.
  void watch(Instant until) { watched_until_ = until; }
  [[nodiscard]] bool glance_is_due() const;
  Task<> glance();

 private:
  const Console& console_;
  Conversation& conversation_;
  SecondLook look_;
  Instant shown_of_{};  ///< when the words had been asked for
  Instant watched_until_{}, glanced_at_{};
};

/// Count of the numbers in a status reply.
std::size_t fields_of_status(const Console& console);

}  // namespace hw::arcus
