#include "tests/gui/lib/gl_canvas.h"

#include <algorithm>
#include <cstring>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <backends/imgui_impl_opengl3.h>

namespace hw::gui {
namespace {

template <class F>
F proc(const char* name) {
  return reinterpret_cast<F>(eglGetProcAddress(name));
}

bool has(const char* list, const char* word) { return list && std::strstr(list, word); }

}  // namespace

struct GlCanvas::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  PFNGLGENFRAMEBUFFERSPROC gen_frame_buffers = nullptr;
  PFNGLBINDFRAMEBUFFERPROC bind_frame_buffer = nullptr;
  PFNGLFRAMEBUFFERTEXTURE2DPROC attach_texture = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC status = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC delete_frame_buffers = nullptr;
  bool backend = false;

  bool make_current() const {
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  }
  bool open() {
    if (!has(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) return false;
    const auto get_display = proc<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (!get_display) return false;
    display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
    if (!eglBindAPI(EGL_OPENGL_API)) return false;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) return false;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT || !make_current()) return false;
    gen_frame_buffers = proc<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers");
    bind_frame_buffer = proc<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
    attach_texture = proc<PFNGLFRAMEBUFFERTEXTURE2DPROC>("glFramebufferTexture2D");
    status = proc<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus");
    delete_frame_buffers = proc<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers");
    return gen_frame_buffers && bind_frame_buffer && attach_texture && status && delete_frame_buffers;
  }
  ~Egl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

GlCanvas::GlCanvas(std::unique_ptr<Egl> egl) : egl_(std::move(egl)) {}

std::unique_ptr<GlCanvas> GlCanvas::open() {
  auto egl = std::make_unique<Egl>();
  if (!egl->open()) return nullptr;
  return std::unique_ptr<GlCanvas>(new GlCanvas(std::move(egl)));
}

GlCanvas::~GlCanvas() {
  if (!egl_->make_current()) return;
  textures_.forget();
  if (egl_->backend && ImGui::GetCurrentContext()) ImGui_ImplOpenGL3_Shutdown();
  if (frame_buffer_) egl_->delete_frame_buffers(1, &frame_buffer_);
  if (colour_) glDeleteTextures(1, &colour_);
}

bool GlCanvas::size_to(int width, int height) {
  if (!frame_buffer_) {
    egl_->gen_frame_buffers(1, &frame_buffer_);
    glGenTextures(1, &colour_);
  }
  egl_->bind_frame_buffer(GL_FRAMEBUFFER, frame_buffer_);
  if (width != width_ || height != height_) {
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    egl_->attach_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    width_ = width;
    height_ = height;
  }
  return egl_->status(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool GlCanvas::draw(const Screen& screen) {
  if (!screen.draw_data()) return false;
  ImDrawData& data = *screen.draw_data();
  const int width = static_cast<int>(data.DisplaySize.x), height = static_cast<int>(data.DisplaySize.y);
  if (!egl_->make_current()) return false;
  if (!egl_->backend) egl_->backend = ImGui_ImplOpenGL3_Init("#version 150");
  if (!egl_->backend || !size_to(width, height)) return false;
  if (screen.atlas_generation() != atlas_generation_) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_NewFrame();  // makes the shaders the first time
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    atlas_generation_ = screen.atlas_generation();
  }
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(screen.theme()[Tone::ground]);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(c.x, c.y, c.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  textures_.render(data, screen.pictures());
  glFinish();
  return glGetError() == GL_NO_ERROR;
}

bool GlCanvas::read(std::vector<std::uint32_t>& pixels) {
  if (!egl_->make_current()) return false;
  pixels.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const auto row = [&](int y) { return pixels.begin() + static_cast<std::ptrdiff_t>(y) * width_; };
  for (int y = 0; y < height_ / 2; ++y) std::swap_ranges(row(y), row(y) + width_, row(height_ - 1 - y));
  return glGetError() == GL_NO_ERROR;
}

}  // namespace hw::gui
