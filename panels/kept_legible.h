#pragma once
// Keeps tooltips off sentences and lamps, as far as their window shows them.
#include <algorithm>

#include <imgui.h>

#include "gui/surface/ui.h"

namespace hw::panels {

inline void keep_legible(const gui::Ui& ui, const gui::Rect& r) {
  const ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 first = list->GetClipRectMin(), last = list->GetClipRectMax();
  ui.registry.keep_clear({ImVec2(std::max(r.min.x, first.x), std::max(r.min.y, first.y)),
                          ImVec2(std::min(r.max.x, last.x), std::min(r.max.y, last.y))});
}

}  // namespace hw::panels
