#include "panels/file_prompt.h"

#include <utility>

#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"

namespace hw::panels {

using namespace gui;

void FilePrompt::ask_open(std::string title, std::string) {
  open_ = true;
  saving_ = false;
  title_ = std::move(title);
}

void FilePrompt::ask_save(std::string title, std::filesystem::path suggested) {
  open_ = saving_ = true;
  title_ = std::move(title);
  path_ = suggested.string();
}

std::optional<std::filesystem::path> FilePrompt::draw(Ui& ui) {
  std::optional<std::filesystem::path> chosen;
  if (!open_ || !begin_modal(ui, "file", open_, 520)) return chosen;
  section_title(ui, title_);
  const Field field = text_field(ui, "file/path", "Path", path_, {.placeholder = "Path of the file"});
  gap(ui, 12);
  const bool yes =
      button(ui, "file/yes", saving_ ? "Save" : "Open", {.disabled = path_.empty() ? "Give a path." : ""})
          .clicked;
  ImGui::SameLine(0, ui.px(8));
  const bool no = button(ui, "file/no", "Cancel").clicked || ui.cancelled();
  gap(ui, 16);
  end_modal();
  if ((yes || field.entered) && !path_.empty()) chosen = path_;
  if (chosen || no) open_ = false;
  return chosen;
}

}  // namespace hw::panels
