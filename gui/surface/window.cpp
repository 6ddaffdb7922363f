#include "gui/surface/window.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>

#include "gui/surface/offscreen.h"

namespace hw::gui {
namespace {

constexpr int frames_after_input = FramePacer::frames_after_input;
constexpr double look_at_keys_every_s = 0.05;  // while a key is down
enum { cursor_arrow, cursor_text, cursor_ew, cursor_ns };

std::string glfw_error() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? std::string(" (") + words + ")" : std::string();
}

Modifiers modifiers_of(int mods) {
  return {(mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0,
          (mods & GLFW_MOD_SUPER) != 0};
}

float monitor_scale() {
  float x = 1, y = 1;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) glfwGetMonitorContentScale(monitor, &x, &y);
  return x > 0 ? x : 1;
}

}  // namespace

struct Window::Callbacks {
  static Window& of(GLFWwindow* w) { return *static_cast<Window*>(glfwGetWindowUserPointer(w)); }

  static void key(GLFWwindow* w, int key, int code, int action, int mods) {
    if (key < 0) return;
    if (of(w).grabs_.is_given_back()) of(w).follow_grabs();
    const bool down = action != GLFW_RELEASE;
    if (!down)
      of(w).keys_.release(key, code);
    else if (!of(w).keys_.is_press(key, code, action == GLFW_REPEAT))
      return of(w).touched(1);  // ImGui makes its own repeats, but needs frames for them
    of(w).push(InputEvent::key(key, down, of(w).now_s()).with(modifiers_of(mods)));
  }
  static void character(GLFWwindow* w, unsigned code) { of(w).push(InputEvent::text(code, of(w).now_s())); }
  static void button(GLFWwindow* w, int button, int action, int mods) {
    if (!of(w).pointer_) of(w).find_pointer();
    of(w).push(InputEvent::mouse_button(button, action == GLFW_PRESS, *of(w).pointer_, of(w).now_s())
                   .with(modifiers_of(mods)));
  }
  static void cursor(GLFWwindow* w, double x, double y) {
    const ImVec2 at = of(w).to_pixels(x, y);
    of(w).pointer_ = at;
    of(w).push(InputEvent::mouse_move(at.x, at.y, of(w).now_s()));
  }
  static void enter(GLFWwindow* w, int entered) {
    if (entered) return of(w).find_pointer();
    if (glfwGetMouseButton(w, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) return;
    of(w).pointer_.reset();
    of(w).push(InputEvent::mouse_move(-FLT_MAX, -FLT_MAX, of(w).now_s()));
  }
  static void scroll(GLFWwindow* w, double x, double y) {
    of(w).push(InputEvent::wheel(static_cast<float>(x), static_cast<float>(y), of(w).now_s()));
  }
  static void focus(GLFWwindow* w, int focused) { focused ? of(w).regain_keyboard() : of(w).lose_keyboard(); }
  // No mouse move is reported when the window moves under a resting pointer.
  static void position(GLFWwindow* w, int, int) { of(w).look_for_pointer(); }
  static void size(GLFWwindow* w, int, int) {
    of(w).look_for_pointer();
    of(w).touched(2);
  }
  static void refresh(GLFWwindow* w) { of(w).touched(1); }
  static void scale(GLFWwindow* w, float x, float) {
    of(w).screen_->set_scale(x * of(w).options_.scale);
    of(w).touched(2);
  }
  static void drop(GLFWwindow* w, int count, const char** paths) {
    if (of(w).on_drop) of(w).on_drop(std::vector<std::string>(paths, paths + count));
    of(w).touched(frames_after_input);
  }
  static void close(GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    if (!of(w).on_close || of(w).on_close()) of(w).closing_ = true;
    of(w).touched(frames_after_input);
  }
};

Window::Window(WindowOptions options) : options_(std::move(options)) {}

static std::future<Fonts> build_fonts(float scale) {
  return std::async(std::launch::async, [scale] {
    Fonts f;
    f.build(scale);
    return f;
  });
}

Result<std::unique_ptr<Window>> Window::open(WindowOptions options) {
  // Building the atlas takes about as long as opening the window, so both run at once. The monitor's scale,
  // usually 1, is known only later.
  std::future<Fonts> fonts = build_fonts(options.scale);
  if (!glfwInit())
    return fail(FaultKind::port, "No window can be opened: there is no display" + glfw_error() + ".",
                "Nothing was started.",
                "Start it in a desktop session, or use `handwheel run SCRIPT --gui`.");
  std::unique_ptr<Window> window(new Window(std::move(options)));
  const Result<> made = window->create(std::move(fonts));
  if (!made) return fail(made.error());
  return window;
}

Result<> Window::create(std::future<Fonts> unscaled) {
  opened_at_s_ = glfwGetTime();
  const float scale = monitor_scale() * options_.scale;
  std::future<Fonts> fonts = scale == options_.scale ? std::move(unscaled) : build_fonts(scale);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
  const auto pixels = [&](int logical) {
    return static_cast<int>(std::lround(static_cast<float>(logical) * scale));
  };
  window_ = glfwCreateWindow(pixels(options_.width), pixels(options_.height), options_.title.c_str(), nullptr,
                             nullptr);
  if (!window_)
    return fail(FaultKind::port, "The window could not be opened: no OpenGL 3.2" + glfw_error() + ".",
                "Nothing was started.", "Install a graphics driver or Mesa (libgl1-mesa-dri).");
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(0);  // waiting in a swap would delay Esc; the loop limits the rate to 60 frames a second
  screen_ = std::make_unique<Screen>(fonts.get(), options_.dark);
  gl_ready_ = ImGui_ImplOpenGL3_Init("#version 150");
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  glfwSetWindowSizeLimits(window_, pixels(480), pixels(320), GLFW_DONT_CARE, GLFW_DONT_CARE);
  connect_callbacks();
  connect_clipboard();
  grabs_.watch(window_);
  gamepads_.watch();
  return {};
}

Window::~Window() {
  if (screen_) screen_->make_current();
  if (gl_ready_) textures_.forget(), ImGui_ImplOpenGL3_Shutdown();
  screen_.reset();
  for (GLFWcursor* cursor : cursors_)
    if (cursor) glfwDestroyCursor(cursor);
  if (window_) glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::connect_callbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, Callbacks::key);
  glfwSetCharCallback(window_, Callbacks::character);
  glfwSetMouseButtonCallback(window_, Callbacks::button);
  glfwSetCursorPosCallback(window_, Callbacks::cursor);
  glfwSetCursorEnterCallback(window_, Callbacks::enter);
  glfwSetScrollCallback(window_, Callbacks::scroll);
  glfwSetWindowFocusCallback(window_, Callbacks::focus);
  glfwSetWindowPosCallback(window_, Callbacks::position);
  glfwSetFramebufferSizeCallback(window_, Callbacks::size);
  glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
  glfwSetWindowContentScaleCallback(window_, Callbacks::scale);
  glfwSetDropCallback(window_, Callbacks::drop);
  glfwSetWindowCloseCallback(window_, Callbacks::close);
}

void Window::connect_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = window_;
  io.SetClipboardTextFn = [](void* w, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
  };
  io.GetClipboardTextFn = [](void* w) { return glfwGetClipboardString(static_cast<GLFWwindow*>(w)); };
}

double Window::now_s() const { return options_.now_s ? options_.now_s() : glfwGetTime() - opened_at_s_; }

ImVec2 Window::to_pixels(double x, double y) const {
  int w = 1, h = 1, fw = 1, fh = 1;
  glfwGetWindowSize(window_, &w, &h);
  glfwGetFramebufferSize(window_, &fw, &fh);
  return ImVec2(static_cast<float>(x * fw / std::max(1, w)), static_cast<float>(y * fh / std::max(1, h)));
}

void Window::push(const InputEvent& event) {
  screen_->input().push(event);
  touched(frames_after_input);
}

void Window::lose_keyboard() {
  keys_.forget();
  pointer_.reset();
  push(InputEvent::focus_lost(now_s()));
}

void Window::regain_keyboard() {
  keys_.come_back();
  look_for_pointer();
  touched(1);
}

void Window::follow_grabs() {
  for (const bool taken : grabs_.take_news()) taken ? lose_keyboard() : regain_keyboard();
}

void Window::let_go_of_lost_keys() {
  for (const int key : keys_.lost()) push(InputEvent::key(key, false, now_s()));
}

void Window::follow_gamepad() {
  const auto push = [this](const InputEvent& event) { screen_->input().push(event); };
  Gamepad& gamepad = screen_->gamepad();
  if (gamepads_.has_news(now_s(), push)) {
    gamepad.came(gamepads_.name());
    touched(frames_after_input);
  }
  gamepad.armed() ? gamepads_.look_if_due(now_s(), push) : gamepads_.rest();
  if (screen_->more_input()) touched(frames_after_input);
}

void Window::find_pointer() {
  double x = 0, y = 0;
  glfwGetCursorPos(window_, &x, &y);
  Callbacks::cursor(window_, x, y);
}

void Window::look_for_pointer() {
  if (glfwGetWindowAttrib(window_, GLFW_HOVERED)) return find_pointer();
  pointer_.reset();
}

void Window::wake() {
  if (pacer_.news()) glfwPostEmptyEvent();
}

void Window::resize(int width, int height, float scale) {
  options_.scale = scale;
  const float all = monitor_scale() * scale;
  screen_->set_scale(all);
  glfwSetWindowSize(window_, static_cast<int>(std::lround(static_cast<float>(width) * all)),
                    static_cast<int>(std::lround(static_cast<float>(height) * all)));
  touched(frames_after_input);
}

void Window::set_user_scale(float scale) {
  options_.scale = scale;
  screen_->set_scale(monitor_scale() * scale);
  touched(2);
}

FramePacer::Needs Window::needs() const { return {screen_->more_input(), screen_->wake_in_s()}; }

void Window::wait() {
  double until = pacer_.wait_s(now_s(), needs());
  if (keys_.any()) until = std::min(until, look_at_keys_every_s);
  if (screen_->gamepad().armed()) until = std::min(until, gamepads_.due_in_s(now_s()));
  if (until <= 0)
    glfwPollEvents();
  else
    glfwWaitEventsTimeout(std::min(until, 3600.0));
}

void Window::run(const Draw& draw) {
  while (!closing_) {
    wait();
    follow_grabs();
    let_go_of_lost_keys();
    follow_gamepad();
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) {
      glfwWaitEventsTimeout(0.5);
      touched(1);
    }
    if (!pacer_.is_due(now_s(), needs())) continue;
    pacer_.begin_frame(now_s());
    frame(now_s(), draw);
  }
}

void Window::frame(double now_s, const Draw& draw) {
  int w = 0, h = 0;
  glfwGetFramebufferSize(window_, &w, &h);
  screen_->frame(now_s, ImVec2(static_cast<float>(std::max(w, 1)), static_cast<float>(std::max(h, 1))), draw);
  if (screen_->atlas_generation() != atlas_generation_) {
    if (atlas_generation_ == 0)
      ImGui_ImplOpenGL3_NewFrame();  // creates shaders and texture
    else
      ImGui_ImplOpenGL3_DestroyFontsTexture(), ImGui_ImplOpenGL3_CreateFontsTexture();
    atlas_generation_ = screen_->atlas_generation();
  }
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(screen_->theme()[Tone::ground]);
  glViewport(0, 0, w, h);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  textures_.render(*screen_->draw_data(), screen_->pictures());
  glfwSwapBuffers(window_);
  show_cursor();
  if (++frames_ == 1 && on_first_frame) on_first_frame();
}

void Window::show_cursor() {
  int wanted = cursor_arrow;
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput: wanted = cursor_text; break;
    case ImGuiMouseCursor_ResizeEW: wanted = cursor_ew; break;
    case ImGuiMouseCursor_ResizeNS: wanted = cursor_ns; break;
    default: break;
  }
  if (wanted == cursor_shown_) return;
  constexpr int shapes[] = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};
  if (!cursors_[wanted]) cursors_[wanted] = glfwCreateStandardCursor(shapes[wanted]);
  glfwSetCursor(window_, cursors_[wanted]);
  cursor_shown_ = wanted;
}

Result<> Window::screenshot(const std::string& path) {
  int w = 0, h = 0;
  glfwGetFramebufferSize(window_, &w, &h);
  ImDrawData* data = screen_->draw_data();
  if (!data || w <= 0 || h <= 0)
    return fail(FaultKind::internal, "No frame has been drawn yet, so there is no picture.");
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(screen_->theme()[Tone::ground]);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  textures_.render(*data, screen_->pictures());
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  glReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const auto row = [&](int y) { return pixels.begin() + static_cast<std::ptrdiff_t>(y) * w; };
  for (int y = 0; y < h / 2; ++y) std::swap_ranges(row(y), row(y) + w, row(h - 1 - y));
  return write_png(path, pixels, w, h);
}

}  // namespace hw::gui
