#include "gui/surface/gl_textures.h"

#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>
#include <backends/imgui_impl_opengl3.h>

namespace hw::gui {

void GlTextures::render(ImDrawData& data, const Pictures& pictures) {
  drop_those_gone();
  for (const auto& picture : pictures.shown()) bring(picture);
  renamed_.clear();
  for (int n = 0; n < data.CmdListsCount; ++n)
    for (ImDrawCmd& command : data.CmdLists[n]->CmdBuffer) {
      const auto found = known_.find(command.TextureId);
      if (found == known_.end()) {
        command.TextureId = ImGui::GetIO().Fonts->TexID;
        continue;
      }
      renamed_.emplace_back(&command, command.TextureId);
      command.TextureId = reinterpret_cast<ImTextureID>(std::uintptr_t{found->second.name});
    }
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  for (const auto& [command, id] : renamed_) command->TextureId = id;
}

void GlTextures::bring(const std::shared_ptr<const Picture>& picture) {
  Known& known = known_[picture.get()];
  if (known.name != 0) return;
  known.picture = picture;
  glGenTextures(1, &known.name);
  glBindTexture(GL_TEXTURE_2D, known.name);
  // With software GL, bilinear filtering would take as long as a frame, and a scaled picture is shown for 0.1
  // s only.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               picture->pixels.data());
}

// Drops the textures of pictures that no longer exist. Pictures keeps those of the latest frame.
void GlTextures::drop_those_gone() {
  for (auto it = known_.begin(); it != known_.end();) {
    if (!it->second.picture.expired()) {
      ++it;
      continue;
    }
    glDeleteTextures(1, &it->second.name);
    it = known_.erase(it);
  }
}

void GlTextures::forget() {
  for (const auto& [id, known] : known_) glDeleteTextures(1, &known.name);
  known_.clear();
}

}  // namespace hw::gui
