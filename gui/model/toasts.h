#pragma once
// What was done, or not, said once in one list at the bottom right. Faults stay until they are read or what
// they were about has changed, the rest goes after 6 s. What is said again is counted, not said twice.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/model/mood.h"

namespace hw::gui {

class Toasts {
 public:
  /// How a controller stands.
  struct Standing {
    bool linked = false, moving = false;
  };
  struct Toast {
    int number;  ///< `toast/NUMBER`
    Mood mood;
    std::string text;
    double until_s;  ///< on the clock of the frames; negative: not shown yet
    const void* about = nullptr;
    std::string of{};                 ///< the controller that it speaks of; empty: none
    std::string said{};               ///< as it is shown
    bool stays = false;               ///< until it is dismissed
    int times = 1;                    ///< how often it was said while it stands
    double since_s = 0;               ///< when it was said last
    std::optional<Standing> first{};  ///< how the controller that it is about stood then
  };
  /// Of the frame that is being drawn.
  struct InFrame {
    bool shown = false;        ///< somebody with room has shown the newest
    bool list_wanted = false;  ///< its press asks for all that stand
  };

  /// `about`: what it speaks of; see withdraw(). `of`: the name of its controller.
  void add(Mood mood, std::string text, const void* about = nullptr, std::string of = {});
  /// One that stays until it is dismissed, whatever its mood.
  void add_staying(Mood mood, std::string text);
  /// The controller that is in front: those that speak of another one name it. Nothing: there is but one.
  void look_at(std::optional<std::string_view> front);
  /// That has changed, so what was said about it is not true any more.
  void withdraw(const void* about);
  /// A controller that has its link again, or moves: what was said about it while it had none, or stood, has
  /// lost its reason.
  void look_at_controller(const void* about, Standing stands);
  void dismiss(int number);
  void dismiss_all();
  /// Once a frame: starts the time of new ones, drops what has had its time. True: the list is not what it
  /// was in the frame before.
  bool tick(double now_s);
  [[nodiscard]] const std::vector<Toast>& list() const { return list_; }
  /// Seconds until the next one goes.
  [[nodiscard]] double due_in_s(double now_s) const;
  InFrame in_frame;

  static constexpr double shown_for_s = 6;
  static constexpr std::size_t at_most = 12, longest = 600;

 private:
  void make_room();

  std::vector<Toast> list_;  ///< the newest last
  int next_number_ = 1;
  bool changed_ = false;
};

}  // namespace hw::gui
