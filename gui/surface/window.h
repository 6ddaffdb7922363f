#pragma once
// The window: GLFW and GL with an event-driven loop. Frames are drawn on events, at most 60 times a second,
// and none at rest. The callbacks put keys and buttons into the input queue at once, so that Esc stops before
// the next frame.
#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "gui/input/gamepad_source.h"
#include "gui/input/keyboard_grabs.h"
#include "gui/input/physical_keys.h"
#include "gui/surface/frame_pacer.h"
#include "gui/surface/gl_textures.h"
#include "gui/surface/screen.h"

struct GLFWwindow;
struct GLFWcursor;

namespace hw::gui {

struct WindowOptions {
  std::string title = "Handwheel";
  int width = 1440, height = 900;  ///< logical
  float scale = 1;                 ///< the user's scale, multiplied by the monitor's
  bool dark = true;
  std::function<double()>
      now_s;  ///< clock of the frames in seconds; empty: counts from the opening of the window
};

class Window : public Surface {
 public:
  /// The fonts are built on a separate thread while the window opens.
  static Result<std::unique_ptr<Window>> open(WindowOptions options);
  ~Window() override;

  /// Runs until the window is closed (and on_close agrees) or close() is called.
  void run(const Draw& draw);
  void close() { closing_ = true; }
  /// Requests a frame. Any thread.
  void wake();

  Screen& screen() override { return *screen_; }
  void resize(int width, int height, float scale) override;
  void frame(double now_s, const Draw& draw) override;
  Result<> screenshot(const std::string& path) override;
  /// The user's scale, multiplied by the monitor's; the window itself keeps its size.
  void set_user_scale(float scale);
  [[nodiscard]] double now_s() const;
  [[nodiscard]] long frames() const { return frames_; }

  std::function<bool()> on_close;                                ///< false: stay open (unsaved texts)
  std::function<void(const std::vector<std::string>&)> on_drop;  ///< paths of dropped files
  std::function<void()> on_first_frame;

 private:
  explicit Window(WindowOptions options);
  Result<> create(std::future<Fonts> unscaled);
  void connect_callbacks();
  void connect_clipboard();
  void push(const InputEvent& event);
  void lose_keyboard();
  void regain_keyboard();
  void follow_grabs();
  void let_go_of_lost_keys();
  void follow_gamepad();
  void find_pointer();
  void look_for_pointer();
  void touched(int frames) { pacer_.touched(frames); }
  void wait();
  [[nodiscard]] FramePacer::Needs needs() const;
  void show_cursor();
  [[nodiscard]] ImVec2 to_pixels(double x, double y) const;
  struct Callbacks;
  friend struct Callbacks;

  WindowOptions options_;
  GLFWwindow* window_ = nullptr;
  GLFWcursor* cursors_[4] = {};
  int cursor_shown_ = -1;
  std::unique_ptr<Screen> screen_;
  GlTextures textures_;
  PhysicalKeys keys_;
  KeyboardGrabs grabs_;
  GamepadSource gamepads_;
  std::optional<ImVec2> pointer_;  ///< position by the events; nullopt: not reported yet
  FramePacer pacer_;
  std::atomic<bool> closing_{false};
  bool gl_ready_ = false;
  int atlas_generation_ = 0;
  double opened_at_s_ = 0;
  long frames_ = 0;
};

}  // namespace hw::gui
