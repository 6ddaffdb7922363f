#include "gui/surface/pictures.h"

#include <utility>

namespace hw::gui {

ImTextureID Pictures::show(std::shared_ptr<const Picture> picture) {
  // ImGui only passes the pointer on; nothing writes through it.
  const ImTextureID id = const_cast<Picture*>(picture.get());
  if (!find(id)) shown_.push_back(std::move(picture));
  return id;
}

const Picture* Pictures::find(ImTextureID id) const {
  for (const auto& picture : shown_)
    if (picture.get() == id) return picture.get();
  return nullptr;
}

}  // namespace hw::gui
