#include "gui/model/panel.h"

namespace hw::gui {

std::string OpenPanels::unkept() const {
  std::string sentences;
  for (const auto& panel : all)
    if (const std::string_view sentence = panel ? panel->unkept() : ""; !sentence.empty())
      sentences.append(sentences.empty() ? "" : " ").append(sentence);
  return sentences;
}

}  // namespace hw::gui
