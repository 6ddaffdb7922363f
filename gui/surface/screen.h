#pragma once
// An ImGui context with its theme, fonts, input and registry. The window and the offscreen surface both draw
// their frames through it; they differ only in how they show them.
#include <functional>
#include <string>

#include <imgui.h>

#include "core/base/result.h"
#include "gui/surface/ui.h"

namespace hw::gui {

using Draw = std::function<void(Ui&)>;

class Screen {
 public:
  /// `fonts` must be built already.
  Screen(Fonts fonts, bool dark);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Takes effect with the next frame.
  void set_scale(float scale) { wanted_scale_ = scale; }
  void set_theme(bool dark);
  [[nodiscard]] bool dark() const { return theme_->dark; }
  [[nodiscard]] float scale() const { return fonts_.scale(); }

  /// Draws one frame at `now_s`. Its draw lists are in draw_data() until the next frame.
  void frame(double now_s, ImVec2 size_px, const Draw& draw);
  /// Selects this screen; tests have several in one process.
  void make_current() const { ImGui::SetCurrentContext(context_); }
  [[nodiscard]] ImDrawData* draw_data() const;
  /// Input is waiting for a frame of its own.
  [[nodiscard]] bool more_input() const { return !input_.empty(); }
  /// Seconds after the last frame at which another frame is due even if nothing happens.
  [[nodiscard]] double wake_in_s() const { return wake_in_s_; }
  /// Counts atlas builds: a texture of an older generation is out of date.
  [[nodiscard]] int atlas_generation() const { return atlas_generation_; }

  InputQueue& input() { return input_; }
  Keyboard& keyboard() { return keyboard_; }
  Gamepad& gamepad() { return gamepad_; }
  Registry& registry() { return registry_; }
  Focus& focus() { return focus_; }
  /// The pictures of the frame in draw_data().
  [[nodiscard]] const Pictures& pictures() const { return pictures_; }
  const Theme& theme() const { return *theme_; }

 private:
  void prepare(double now_s, ImVec2 size_px);

  Fonts fonts_;
  const Theme* theme_;
  ImGuiContext* context_;
  InputQueue input_;
  Keyboard keyboard_;
  Gamepad gamepad_{keyboard_};
  Registry registry_;
  Focus focus_;
  PressGuard press_guard_;
  Pictures pictures_;
  float wanted_scale_;
  bool style_old_ = true, typing_ = false;
  TabTaken tab_taken_ = TabTaken::no;
  int atlas_generation_ = 1;
  double last_s_ = -1, wake_in_s_ = 1e9;
};

/// Shows frames: in a window or in memory.
class Surface {
 public:
  virtual ~Surface() = default;
  virtual Screen& screen() = 0;
  /// Size in logical pixels and scale; takes effect with the next frame.
  virtual void resize(int width, int height, float scale) = 0;
  /// Draws one frame and shows it.
  virtual void frame(double now_s, const Draw& draw) = 0;
  /// Writes the last frame to a PNG file.
  virtual Result<> screenshot(const std::string& path) = 0;
};

}  // namespace hw::gui
