#pragma once
// What was done, or not, said once at the bottom right of the centre. Faults stay until they are read, the
// rest goes after 6 s. The same sentence is not said twice at the same time.
#include <string>
#include <vector>

#include "gui/mood.h"

namespace hw::gui {

class Toasts {
 public:
  struct Toast {
    int number;  ///< `toast/NUMBER`
    Mood mood;
    std::string text;
    double until_s;  ///< on the clock of the frames; negative: not shown yet
  };

  void add(Mood mood, std::string text);
  void dismiss(int number);
  /// Once a frame, before drawing: starts the time of new ones, drops what has had its time.
  void tick(double now_s);
  [[nodiscard]] const std::vector<Toast>& list() const { return list_; }
  /// Seconds until the next one goes.
  [[nodiscard]] double due_in_s(double now_s) const;

  static constexpr double shown_for_s = 6;
  static constexpr std::size_t at_most = 4;

 private:
  std::vector<Toast> list_;
  int next_number_ = 1;
};

}  // namespace hw::gui
