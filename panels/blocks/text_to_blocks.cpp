#include "panels/blocks/text_to_blocks.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/device/language.h"
#include "core/sequence/steps_in.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/message.h"

namespace hw::panels {

using namespace gui;
namespace {

std::string what_came(const SequenceRead& read) {
  const int count = sequence::count_steps(read.sequence.steps);
  std::string text = fmt::format("The text has become {} {}. Undo restores the earlier ones.", count,
                                 count == 1 ? "block" : "blocks");
  constexpr std::size_t most = 2;
  for (std::size_t i = 0; i < std::min(read.remarks.size(), most); ++i) text += " " + read.remarks[i];
  const std::size_t more = read.remarks.size() - std::min(read.remarks.size(), most);
  if (more > 0) text += fmt::format(" And {} more remark{}.", more, more == 1 ? "" : "s");
  return text;
}

}  // namespace

std::string_view TextToBlocks::why_not(const Frame& f) {
  Desk& desk = f.tab.desk();
  if (!desk.programs.language()) return "Blocks cannot be read from the language of this controller.";
  if (desk.programs.texts.text(desk.programs.texts.chosen()).empty()) return "The program is empty.";
  return {};
}

void TextToBlocks::start(Frame& f) {
  asking_ = f.tab.desk().blocks.edited();
  if (!asking_) read(f);
}

void TextToBlocks::show(Frame& f) {
  if (!f.tab.desk().blocks.edited()) {
    read(f);
    return f.show_panel("blocks");
  }
  f.show_panel("blocks", "blocks/from_text");
  f.toast(Severity::plain, "The blocks have unsaved changes. From the text asks before it replaces them.");
}

void TextToBlocks::read(Frame& f) {
  if (const auto why = why_not(f); !why.empty()) return f.toast(Severity::warn, std::string(why));
  Desk& desk = f.tab.desk();
  desk.work.worker().run(
      [language = desk.programs.language(), text = desk.programs.texts.text(desk.programs.texts.chosen()),
       frame = desk.blocks.editor.shared(), catalog = std::make_shared<const Catalog>(f.catalog)] {
        return language->read(text, *frame, *catalog);
      },
      [&console = f.console, &tab = f.tab](Result<SequenceRead> read) {
        if (!read)
          return console.toast(tab, Severity::warn, read.error().sentence(), &tab.desk().programs.texts);
        console.toast(tab, Severity::ok, what_came(*read));
        tab.desk().blocks.became(std::move(read->sequence));
      },
      desk.work.alive());
  f.ui.wake_in(0);
}

void TextToBlocks::draw_dialog(Frame& f) {
  if (!asking_) return;
  const Dialog what{
      .title = "Replace the blocks?",
      .sentences =
          "The blocks have unsaved changes. Blocks from the text would replace them; undo restores them.",
      .yes = "Replace",
      .no = "Keep them"};
  if (dialog(f.ui, "blocks/replace_all", asking_, what) == Answer::yes) read(f);
}

}  // namespace hw::panels
