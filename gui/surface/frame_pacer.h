#pragma once
// Decides when the window draws: after input, after news from a controller, and when a displayed time is due,
// at most 60 times a second. At rest it draws nothing. Each change is drawn in more than one frame, because
// ImGui needs a second one: it scrolls a longer list to its end in the next frame, and hides a new dialog in
// its first.
#include <algorithm>
#include <atomic>

namespace hw::gui {

class FramePacer {
 public:
  static constexpr double frame_seconds = 1.0 / 60;
  static constexpr int frames_after_news = 2, frames_after_input = 3;

  /// The needs of the next frame: see Screen.
  struct Needs {
    bool more_input = false;
    double wake_in_s = 1e9;  ///< after the last frame
  };

  /// Window thread.
  void touched(int frames) { wanted_ = std::max(wanted_, frames); }
  /// Any thread, after publishing the news. Returns true when the window may be asleep and must be woken.
  [[nodiscard]] bool news() { return !news_.exchange(true); }
  /// Window thread. The frame shows everything published so far; later news requests another frame.
  void begin_frame(double now_s) {
    if (news_.exchange(false)) touched(frames_after_news);
    wanted_ = std::max(0, wanted_ - 1);
    last_s_ = now_s;
  }
  [[nodiscard]] bool is_due(double now_s, const Needs& needs) const {
    const double since = now_s - last_s_;
    return since >= frame_seconds * 0.98 && (wants(needs) || since >= needs.wake_in_s);
  }
  /// How long the window may sleep.
  [[nodiscard]] double wait_s(double now_s, const Needs& needs) const {
    return std::max(wants(needs) ? 0.0 : needs.wake_in_s, frame_seconds) - (now_s - last_s_);
  }

 private:
  [[nodiscard]] bool wants(const Needs& needs) const { return wanted_ > 0 || news_ || needs.more_input; }

  std::atomic<bool> news_{true};
  int wanted_ = frames_after_input;
  double last_s_ = -1;
};

}  // namespace hw::gui
