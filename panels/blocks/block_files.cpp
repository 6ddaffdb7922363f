#include "panels/blocks/block_files.h"

#include <utility>

#include <fmt/format.h>

#include "core/sequence/sequence_file.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"
#include "gui/input/keyboard.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"

namespace hw::panels {

using namespace gui;

void BlockFiles::follow(Frame& f) {
  for (const auto& path : f.tab.desk().take_dropped("blocks")) ask_or_open(f, path);
  if (f.ui.keyboard.pressed(Command::save)) ask_save(f);
  if (f.ui.keyboard.pressed(Command::open)) ask_open();
}

void BlockFiles::ask_open() { open_.ask_open("Open a sequence", open_.folder(), {".toml"}); }

void BlockFiles::ask_save(const Frame& f) {
  const auto& path = f.tab.desk().blocks.file();
  save_.ask_save("Save the sequence", path.empty() ? save_.folder() / "sequence.toml" : path, {".toml"});
}

void BlockFiles::ask_or_open(Frame& f, const std::filesystem::path& path) {
  to_open_ = path;
  asking_open_ = f.tab.desk().blocks.edited();
  if (!asking_open_) open(f, to_open_);
}

void BlockFiles::open(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  f.withdraw(&desk.blocks);  // the message why the last file was not opened or saved
  desk.work.worker().run(
      [path]() -> Result<sequence::Sequence> {
        constexpr std::uintmax_t largest = 64u << 20;
        const auto text = read_file(path, largest);
        if (!text) return fail(text.error());
        return sequence::read_sequence(*text, path.filename().string());
      },
      [&console = f.console, &blocks = desk.blocks, path](Result<sequence::Sequence> sequence) {
        if (!sequence) return console.toast(Severity::fault, sequence.error().sentence(), &blocks);
        blocks.opened(path, std::move(*sequence));
      },
      desk.work.alive());
}

void BlockFiles::save(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  f.withdraw(&desk.blocks);
  desk.work.worker().run(
      [path, sequence = desk.blocks.editor.shared()] {
        return write_file(path, sequence::write_sequence(*sequence));
      },
      [&console = f.console, &blocks = desk.blocks, version = desk.blocks.editor.version(),
       path](Result<> written) {
        if (!written) return console.toast(Severity::fault, written.error().sentence(), &blocks);
        blocks.saved(path, version);
        console.toast(Severity::ok, fmt::format("Saved as {}.", path.string()));
      },
      desk.work.alive());
}

/// The look of "Open" or "Save", with or without its word.
static ButtonOptions look_of_file(Icon icon, const char* label, bool wordless) {
  ButtonOptions look{.style = ButtonStyle::quiet, .height = 40};
  if (wordless) look.icon = icon, look.tip = label, look.wordless = true;
  return look;
}

float BlockFiles::width(const Ui& ui, bool wordless) {
  return button_width(ui, "Open", look_of_file(Icon::folder, "Open", wordless)) +
         button_width(ui, "Save", look_of_file(Icon::save, "Save", wordless));
}

void BlockFiles::draw(Frame& f, bool wordless) {
  constexpr float least_name = 72;
  Ui& ui = f.ui;
  const BlockList& blocks = f.tab.desk().blocks;
  const float width = BlockFiles::width(ui, wordless);
  next_in_toolbar(f, 0, width);
  const ImVec2 next = ImGui::GetCursorScreenPos();
  const bool own_row = next.y > ImGui::GetItemRectMax().y;
  const float x = own_row ? next.x : ui.px(f.area.right() - 8 - width);
  if (std::exchange(named_at_, blocks.changes()) != blocks.changes())
    name_ = blocks.file().filename().string();
  has_room_ = !own_row && x - next.x >= ui.px(least_name);
  if (has_room_) draw_name(f, next.x + ui.px(8), x - ui.px(8), next.y + ui.px(20));
  ImGui::SetCursorScreenPos(ImVec2(x, next.y));
  if (button(ui, "blocks/open", "Open", look_of_file(Icon::folder, "Open", wordless)).clicked) ask_open();
  ImGui::SameLine(0, 0);
  if (button(ui, "blocks/save", "Save", look_of_file(Icon::save, "Save", wordless)).clicked) ask_save(f);
}

void BlockFiles::draw_name(const Frame& f, float left, float right, float middle) const {
  const bool edited = f.tab.desk().blocks.edited();
  draw_text_line(f.ui, left, right, middle, Face::body_bold, f.ui[edited ? Tone::warn : Tone::ink], name_);
}

void BlockFiles::draw_dialogs(Frame& f) {
  if (const auto path = open_.draw(f.ui)) ask_or_open(f, *path);
  if (asking_open_) {
    const Dialog what{.title = "Replace the blocks?",
                      .sentences = "The blocks have unsaved changes.",
                      .yes = "Replace",
                      .no = "Keep them"};
    if (dialog(f.ui, "blocks/discard", asking_open_, what) == Answer::yes) open(f, to_open_);
  }
  if (const auto path = save_.draw(f.ui)) save(f, *path);
}

}  // namespace hw::panels
