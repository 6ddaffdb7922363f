#pragma once
// How long the console's stops took with this controller and what hangs on it, as its core has seen them:
// from the press or release of the hand (see Tab::hand_acted), to the first byte on the wire, and to
// rest. GUI thread.
#include <cstddef>
#include <deque>
#include <string>

#include "core/device/snapshot.h"
#include "gui/model/ending_words.h"

namespace hw::gui {

class StopTimes {
 public:
  /// Takes it if it is a stop that was timed.
  void add(const Ending& ending, const ShowPosition& position);
  /// "Last stop: first byte after 0.2 ms, at rest after 84 ms, 1.700 mm on. Of 100 stops 99 were at rest
  /// within 120 ms and 2.000 mm." Empty: none was timed yet.
  [[nodiscard]] const std::string& words() const { return words_; }

 private:
  static constexpr std::size_t most = 200;
  std::deque<Ending> stops_;  ///< the newest behind
  std::string words_;
};

}  // namespace hw::gui
