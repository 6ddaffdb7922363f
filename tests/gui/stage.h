#pragma once
// A surface without display, a clock of 60 frames a second, and hands: what every GUI test needs.
#include <functional>

#include "gui/surface/automation.h"
#include "gui/surface/offscreen.h"

namespace hw::gui {

struct Stage {
  Offscreen surface;
  double now_s = 0;
  Draw draw;
  Automation hand;

  explicit Stage(Draw d, int width = 1440, int height = 900, float scale = 1, bool dark = true)
      : surface(width, height, scale, dark),
        draw(std::move(d)),
        hand(
            surface, [this] { frame(); }, [this] { return now_s; }) {}
  void frame() {
    now_s += 1.0 / 60;
    surface.frame(now_s, draw);
  }
  void frames(int n) {
    for (int i = 0; i < n; ++i) frame();
  }
  void push(const InputEvent& e) { surface.screen().input().push(e); }
  const Widget* find(std::string_view id) { return surface.screen().registry().find(id); }
};

/// Draws `body` in one window that fills the screen.
inline Draw in_window(std::function<void(Ui&)> body) {
  return [body = std::move(body)](Ui& ui) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ui.size_px);
    ImGui::Begin("test", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    body(ui);
    ImGui::End();
  };
}

}  // namespace hw::gui
