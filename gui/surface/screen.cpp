#include "gui/surface/screen.h"

#include <imgui_internal.h>

namespace hw::gui {

Screen::Screen(Fonts fonts, bool dark)
    : fonts_(std::move(fonts)),
      theme_(dark ? &dark_theme : &light_theme),
      context_(ImGui::CreateContext(&fonts_.atlas())),
      wanted_scale_(fonts_.scale()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = io.LogFilename = nullptr;  // sizes belong to the session file
  io.ConfigInputTextCursorBlink = false;      // a console at rest draws no frame
  io.ConfigFlags = ImGuiConfigFlags_None;     // navigation stays off: it takes Ctrl+Tab and the arrows
  map_keys(io);
  input_.set_listeners(
      [this](const InputEvent& event) {
        const bool taken = keyboard_.on_arrival(event);  // Esc stops before anything else is handled
        return gamepad_.on_arrival(event) || taken;
      },
      [this](const InputEvent& event) { return gamepad_.in_turn(event) || keyboard_.in_turn(event); });
}

Screen::~Screen() { ImGui::DestroyContext(context_); }

void Screen::set_theme(bool dark) {
  theme_ = dark ? &dark_theme : &light_theme;
  style_old_ = true;
}

void Screen::prepare(double now_s, ImVec2 size_px) {
  ImGui::SetCurrentContext(context_);
  if (wanted_scale_ != fonts_.scale()) {
    fonts_.build(wanted_scale_);
    ++atlas_generation_;
    style_old_ = true;
  }
  if (style_old_) apply(*theme_, fonts_.scale(), ImGui::GetStyle());
  style_old_ = false;
  ImGuiIO& io = ImGui::GetIO();
  io.FontDefault = fonts_[Face::body];
  io.DisplaySize = size_px;
  io.DeltaTime = last_s_ < 0 ? 1.0f / 60 : static_cast<float>(std::max(now_s - last_s_, 1e-4));
  last_s_ = now_s;
}

void Screen::frame(double now_s, ImVec2 size_px, const Draw& draw) {
  prepare(now_s, size_px);
  input_.feed(ImGui::GetIO(), focus_.entering());
  keyboard_.begin_frame();
  gamepad_.begin_frame(now_s);
  ImGui::NewFrame();
  focus_.begin_frame(registry_, {now_s, input_.key_moved_at_s()}, typing_, tab_taken_);
  registry_.begin_frame();
  pictures_.begin_frame();
  Ui ui(*theme_, fonts_, registry_, focus_, press_guard_, keyboard_, gamepad_, input_, pictures_, now_s,
        size_px);
  draw(ui);
  ImGui::Render();
  registry_.end_frame();
  press_guard_.end_frame();
  const ImGuiContext& g = *context_;
  typing_ = ui.typing() || (g.ActiveId != 0 && g.ActiveId == g.InputTextState.ID);
  focus_.end_frame(typing_);
  tab_taken_ = typing_ ? ui.tab_taken() : TabTaken::no;
  const bool covered = registry_.top_layer() > 0;
  keyboard_.set_typing(typing_ || ui.takes_arrows() || covered);
  keyboard_.set_covered(covered);
  if (keyboard_.jogging()) ui.wake_in(1.0 / 30);  // a hold sends keep-alives in each frame
  wake_in_s_ = input_.empty() && !focus_.entering() ? ui.wake_in_s() : 0;
}

ImDrawData* Screen::draw_data() const {
  ImGui::SetCurrentContext(context_);
  return ImGui::GetDrawData();
}

}  // namespace hw::gui
