#pragma once
// Times and distances of the console's stops with this controller and its mechanics, as seen by the core:
// from the user's press or release (see Tab::user_acted) to the first byte on the wire, and to rest. GUI
// thread.
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

#include "core/device/snapshot.h"
#include "gui/model/ending_words.h"

namespace hw::gui {

class StopTimes {
 public:
  /// Takes the ending of a timed stop; ignores all others.
  void add(const Ending& ending, const ShowPosition& position);
  /// "Last stop: first byte after 0.2 ms, slowing down seen after 31 ms, at rest after 84 ms, 1.700 mm on. In
  /// 99 of 100 of the last 100 stops the first byte went out within 0.2 ms and the axis was at rest within
  /// 120 ms and 2.000 mm."
  /// Empty: no stop was timed yet.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// The effect of the Stop button, and its words.
  [[nodiscard]] std::string_view tip() const { return tip_; }

 private:
  static constexpr std::size_t most = 200;
  [[nodiscard]] std::string of_all(AxisId axis, const ShowPosition& position) const;

  std::deque<Ending> stops_;  ///< newest last
  static constexpr std::string_view twice =
      "Stops this controller with its ramp. Again, or Shift Esc: at once, without a ramp.";
  std::string words_, tip_{twice};
};

}  // namespace hw::gui
