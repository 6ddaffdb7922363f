#pragma once
// Messages about what was done or failed, in one list at the bottom right. Faults stay until they are
// dismissed or their subject has changed; the others go after 6 s. A repeated message is counted, not shown
// twice.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/model/severity.h"

namespace hw::gui {

class Toasts {
 public:
  /// State of a controller.
  struct Standing {
    bool linked = false, moving = false;
  };
  struct Toast {
    int number;  ///< `toast/NUMBER`
    Severity severity;
    std::string text;
    double until_s;  ///< on the clock of the frames; negative: not shown yet
    const void* about = nullptr;
    std::string of{};                 ///< the controller's name; empty: none
    std::string shown_text{};         ///< text as shown
    bool stays = false;               ///< until it is dismissed
    int times = 1;                    ///< how often it was added while it stands
    double since_s = 0;               ///< time of the latest addition
    std::optional<Standing> first{};  ///< its controller's state at first sight
  };
  /// Of the frame that is being drawn.
  struct InFrame {
    bool shown = false;        ///< the newest was shown by a view with room for it
    bool list_wanted = false;  ///< pressed there: show the whole list
  };

  /// `about`: its subject, see withdraw(). `of`: the name of its controller.
  void add(Severity severity, std::string text, const void* about = nullptr, std::string of = {});
  /// Adds a toast that stays until it is dismissed, whatever its severity.
  void add_staying(Severity severity, std::string text);
  /// Sets the controller in front: toasts of any other name it. Nothing: there is only one.
  void look_at(std::optional<std::string_view> front);
  /// Removes the toasts about a subject that has changed, as they are no longer true.
  void withdraw(const void* about);
  /// Removes toasts that have lost their reason: those from before the controller got its link back or began
  /// to move.
  void look_at_controller(const void* about, Standing stands);
  void dismiss(int number);
  void dismiss_all();
  /// Once a frame: starts the time of new toasts, drops expired ones. True: the list has changed since the
  /// last frame.
  bool tick(double now_s);
  [[nodiscard]] const std::vector<Toast>& list() const { return list_; }
  /// Seconds until the next toast expires.
  [[nodiscard]] double due_in_s(double now_s) const;
  InFrame in_frame;

  static constexpr double shown_for_s = 6;
  static constexpr std::size_t at_most = 12, longest = 600;

 private:
  void make_room();

  std::vector<Toast> list_;  ///< newest last
  int next_number_ = 1;
  bool changed_ = false;
};

}  // namespace hw::gui
