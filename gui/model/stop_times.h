#pragma once
// Times and distances of the console's stops with this controller and its mechanics, as seen by the core:
// from the press or release of the hand (see Tab::hand_acted) to the first byte on the wire, and to rest. GUI
// thread.
#include <cstddef>
#include <deque>
#include <string>

#include "core/device/snapshot.h"
#include "gui/model/ending_words.h"

namespace hw::gui {

class StopTimes {
 public:
  /// Takes the ending of a timed stop; ignores all others.
  void add(const Ending& ending, const ShowPosition& position);
  /// "Last stop: first byte after 0.2 ms, slowing down seen after 31 ms, at rest after 84 ms, 1.700 mm on. Of
  /// 100 stops 99 in 100 were at rest within 120 ms and 2.000 mm." Empty: no stop was timed yet. The second
  /// time is omitted for a controller that reports neither its speed nor its phase.
  [[nodiscard]] const std::string& words() const { return words_; }

 private:
  static constexpr std::size_t most = 200;
  std::deque<Ending> stops_;  ///< newest last
  std::string words_;
};

}  // namespace hw::gui
