#pragma once
// What was done, or not, said once low in the centre where it covers no control. Faults stay until they are
// read or what they were about has changed, the rest goes after 6 s. The same sentence is not said twice at
// the same time.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/model/mood.h"

namespace hw::gui {

class Toasts {
 public:
  struct Toast {
    int number;  ///< `toast/NUMBER`
    Mood mood;
    std::string text;
    double until_s;  ///< on the clock of the frames; negative: not shown yet
    const void* about = nullptr;
    std::string of{};      ///< the controller that it speaks of; empty: none
    std::string said{};    ///< as it is shown
    bool stays = false;    ///< until it is dismissed
    float x = -1, y = -1;  ///< where it lies, pixels: it does not wander; negative: nowhere yet
  };

  /// `about`: what it speaks of; see withdraw(). `of`: the name of its controller.
  void add(Mood mood, std::string text, const void* about = nullptr, std::string of = {});
  /// One that stays until it is dismissed, whatever its mood.
  void add_staying(Mood mood, std::string text);
  /// The controller that is in front: those that speak of another one name it. Nothing: there is but one.
  void look_at(std::optional<std::string_view> front);
  /// That has changed, so what was said about it is not true any more.
  void withdraw(const void* about);
  void dismiss(int number);
  /// Once a frame, before drawing: starts the time of new ones, drops what has had its time.
  void tick(double now_s);
  [[nodiscard]] const std::vector<Toast>& list() const { return list_; }
  [[nodiscard]] std::vector<Toast>& list() { return list_; }
  /// Seconds until the next one goes.
  [[nodiscard]] double due_in_s(double now_s) const;

  static constexpr double shown_for_s = 6;
  static constexpr std::size_t at_most = 4;

 private:
  std::vector<Toast> list_;
  int next_number_ = 1;
};

}  // namespace hw::gui
