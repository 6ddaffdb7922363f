// The least that a window of this look can be: GLFW, GL, ImGui and the same font atlas, nothing in it. The
// anchor for the start and the memory of the console. Says on stderr when its first frame is shown; stays
// until it is told to go.
#include <cstdio>
#include <future>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "gui/surface/fonts.h"

int main() {
  if (!glfwInit()) return 1;
  auto fonts = std::async(std::launch::async, [] {
    hw::gui::Fonts f;
    f.build(1);
    return f;
  });
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  GLFWwindow* const window = glfwCreateWindow(1440, 900, "bare", nullptr, nullptr);
  if (!window) return 1;
  glfwMakeContextCurrent(window);
  glfwSwapInterval(0);
  const hw::gui::Fonts built = fonts.get();
  ImGui::CreateContext(&built.atlas());
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 150");
  for (bool first = true; !glfwWindowShouldClose(window); first = false) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    ImGui::Render();
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
    if (first) std::fputs("first frame\n", stderr);
    glfwWaitEvents();
  }
  return 0;
}
