// Draws the row of slots and files: the controller's program, its text, and the file.
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/blocks/text_to_blocks.h"
#include "panels/lines.h"
#include "panels/program/program.h"

namespace hw::panels {

using namespace gui;
namespace {
constexpr float slots_height = 40;
constexpr std::array<std::string_view, 8> digits = {"0", "1", "2", "3", "4", "5", "6", "7"};
}  // namespace

void Program::draw_slots(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(slots_height / 2);
  const float slots_left = ui.px(f.area.x + 16);
  float x = slots_left;
  const std::string_view word = f.catalog.program.slot_word;
  if (f.area.width >= 800 || desk.programs.texts.count() == 1) {
    draw_text_line(ui, x, ui.px(f.area.right()), middle, Face::body, ui[Tone::ink2], word);
    x += std::ceil(text_width(ui, Face::body, word)) + ui.px(8);
  }
  const auto many =
      std::min<std::size_t>(static_cast<std::size_t>(desk.programs.texts.count()), digits.size());
  if (many > 1) {
    ImGui::SetCursorScreenPos(ImVec2(x, at.y + ui.px(4)));
    const int picked = segment(ui, "program/slot", std::span(digits.data(), many),
                               desk.programs.texts.chosen(), {.cell_width = 32});
    if (picked >= 0) desk.programs.texts.choose(picked);
    ImGui::SameLine(0, ui.px(16));
    x = ImGui::GetCursorScreenPos().x;
  }
  x = draw_start(f, x, at.y + ui.px(4));

  const float files_left = std::max(ui.px(f.area.right() - 4) - file_buttons_width(f), x);
  draw_file_name(f, {ImVec2(x, at.y), ImVec2(files_left, at.y + ui.px(slots_height))}, slots_left);
  ImGui::SetCursorScreenPos(ImVec2(files_left, at.y + ui.px(4)));
  draw_file_buttons(f);
  draw_line_across(f, at.y + ui.px(slots_height) - ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(slots_height)));
}

/// Draws the choice among the programs of a text. Run starts the chosen program, and Simulate tries it.
/// Returns the right end.
float Program::draw_start(Frame& f, float x, float top) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  const std::vector<int>& programs = texts.report(texts.chosen()).programs;
  const bool only_first = programs.size() == 1 && programs.front() == 0;
  if (f.catalog.program.threads == 0 || programs.empty() || only_first) return x;
  std::array<std::string_view, digits.size()> names;
  std::size_t many = 0;
  int chosen = -1;
  for (const int program : programs) {
    if (program < 0 || program >= static_cast<int>(digits.size()) || many == names.size()) continue;
    if (program == texts.start_of(texts.chosen())) chosen = static_cast<int>(many);
    names[many++] = digits[static_cast<std::size_t>(program)];
  }
  ImGui::SetCursorScreenPos(ImVec2(x, top));
  const int picked = segment(f.ui, "program/start", {names.data(), many}, chosen, {.cell_width = 32});
  if (picked >= 0) texts.choose_start(programs[static_cast<std::size_t>(picked)]);
  ImGui::SameLine(0, f.ui.px(16));
  return ImGui::GetCursorScreenPos().x;
}

// If they do not fit, "edited" goes first, then the name, which the tooltip of the slots still shows.
void Program::draw_file_name(Frame& f, Rect in, float slots_left) {
  Ui& ui = f.ui;
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  const std::string name = texts.file_name(texts.chosen());
  const bool edited = texts.edited(texts.chosen());
  const std::string_view shown = !name.empty() ? std::string_view(name) : edited ? "not in a file" : "";
  const Face face = name.empty() ? Face::body : Face::body_bold;
  const float whole = std::ceil(text_width(ui, face, shown)), least = std::min(whole, ui.px(48));
  const std::string tip = edited && !name.empty() ? name + ", edited" : std::string(shown);
  float mark = edited && !name.empty() ? std::ceil(text_width(ui, Face::body, "edited")) + ui.px(8) : 0;
  if (in.width() - mark < least) mark = 0;
  const bool left_out = in.width() < least;
  const float middle = std::floor(in.centre().y), name_right = std::min(in.max.x - mark, in.min.x + whole);
  if (!left_out)
    draw_text_line(ui, in.min.x, name_right + 1, middle, face, ui[name.empty() ? Tone::warn : Tone::ink],
                   shown);
  if (mark > 0)
    draw_text_line(ui, name_right + ui.px(8), in.max.x, middle, Face::body, ui[Tone::warn], "edited");
  if (left_out) in.min.x = slots_left;
  show(ui,
       {.id = "program/file",
        .kind = Kind::text,
        .label = "File",
        .value = shown,
        .tip = left_out ? std::string_view(tip) : std::string_view()},
       in);
}

namespace {
struct FileButton {
  const char *id, *label, *short_label, *keys;
};
constexpr FileButton file_buttons[] = {{"program/check", "Check", "Check", ""},
                                       {"program/open", "Open", "Open", ""},
                                       {"program/save", "Save", "Save", "ctrl S"},
                                       {"program/store", "Store in controller", "Store", ""}};

/// Whether a button is shown. Programs stored compiled have buttons to check, send and store in a row of
/// their own: see draw_compiled_row().
bool is_there(const FileButton& b, const Frame& f) {
  const std::string_view id = b.id;
  if (id == "program/check") return !f.catalog.program.compiled;
  return id != "program/store" || (f.catalog.can.store && !f.catalog.program.compiled);
}
}  // namespace

ButtonOptions Program::file_button_look(const Frame& f, const char* keys) {
  return {.style = ButtonStyle::quiet, .keys = f.area.width >= 800 ? keys : ""};
}

float Program::file_buttons_width(const Frame& f) {
  float width = f.ui.px(button_width(f.ui, "More", {.style = ButtonStyle::quiet}));
  for (const FileButton& b : file_buttons)
    if (is_there(b, f))
      width += f.ui.px(
          button_width(f.ui, f.area.width >= 800 ? b.label : b.short_label, file_button_look(f, b.keys)));
  return width;
}

void Program::draw_file_buttons(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const bool roomy = f.area.width >= 800;
  const std::string_view no_link = f.connected() ? std::string_view() : text_stays;
  float too_much = ImGui::GetCursorScreenPos().x + file_buttons_width(f) - ui.px(f.area.right() - 4);
  for (const FileButton& b : file_buttons) {
    if (!is_there(b, f)) continue;
    ButtonOptions look = file_button_look(f, b.keys);
    const std::string_view id = b.id;
    if (too_much > 0) {  // in a window smaller than the design allows, the first buttons are left out
      too_much -= ui.px(button_width(ui, roomy ? b.label : b.short_label, look));
      continue;
    }
    if (id == "program/store")
      look.disabled = !no_link.empty() ? no_link : desk.programs.job.busy() ? program_in_transfer : "";
    const bool clicked = button(ui, id, roomy ? b.label : b.short_label, look).clicked;
    ImGui::SameLine(0, 0);
    if (!clicked) continue;
    if (id == "program/check") check(f);
    if (id == "program/open") ask_open(f);
    if (id == "program/save") save(f);
    if (id == "program/store") start(f, ProgramJob::Goal::store);
  }
  draw_more(f);
}

void Program::draw_more(Frame& f) {
  static constexpr std::array<std::string_view, 7> names = {"Save as",
                                                            "New text",
                                                            "Find",
                                                            "Comment lines or back",
                                                            "Show as blocks",
                                                            "Load from controller",
                                                            "Empty in controller"};
  Desk& desk = f.tab.desk();
  // Otherwise the controller stores none, or the row for compiled programs has the last two buttons.
  const bool moves_texts = f.catalog.program.capacity > 0 && !f.catalog.program.compiled;
  const std::size_t many = moves_texts ? names.size() : 5;
  switch (menu(f.ui, "program/more", "More", std::span(names.data(), many))) {
    case 0: ask_save(f); break;
    case 1: ask_or_empty(f); break;
    case 2: editor_.editor(desk.programs.texts.chosen()).ask_find(); break;
    case 3: editor_.editor(desk.programs.texts.chosen()).toggle_comment(); break;
    case 4: TextToBlocks::show(f); break;
    case 5: start(f, ProgramJob::Goal::fetch); break;
    case 6: asking_clear_ = true; break;
    default: break;
  }
}

void Program::ask_open(const Frame& f) {
  open_.ask_open("Open a program", open_.folder(), {f.catalog.program.file_suffix, ".txt"});
}

void Program::ask_save(const Frame& f) {
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  const auto& path = texts.file(texts.chosen());
  const auto suggested = fmt::format("program{}", f.catalog.program.file_suffix);
  save_.ask_save("Save the program", path.empty() ? save_.folder() / suggested : path,
                 {f.catalog.program.file_suffix});
}

void Program::save(Frame& f) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  const auto& path = texts.file(texts.chosen());
  if (path.empty()) return ask_save(f);
  write(f, texts.chosen(), path, false);
}

namespace {

/// The content that would be overwritten; empty: the file has its known content, or does not exist.
std::string other_text_in(const std::filesystem::path& path, const std::optional<std::string>& known) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return {};
  const auto there = load_text(path);
  const std::string name = path.filename().string();
  if (!known)
    return fmt::format("Saving overwrites {}, which was not read since this text was recovered.", name);
  if (there && there->text == *known) return {};
  return fmt::format(
      "Another program has changed {} since it was opened or saved here. Saving overwrites those changes.",
      name);
}

}  // namespace

/// Writes the file. `overwrite`: even if its content is not known.
void Program::write(Frame& f, int slot, const std::filesystem::path& path, bool overwrite) {
  Desk& desk = f.tab.desk();
  struct Saved {
    std::string text, changed;
    Result<> result;
  };
  desk.work.worker().run(
      [path, overwrite, file = desk.programs.texts.to_save(slot),
       known = desk.programs.texts.known_in_file(slot)]() mutable {
        Saved saved;
        if (!overwrite) saved.changed = other_text_in(path, known);
        if (!saved.changed.empty()) return saved;
        saved.result = save_text(path, file);
        saved.text = std::move(file.text);
        return saved;
      },
      [&console = f.console, &texts = desk.programs.texts, asks = overwrite_, slot, path](Saved saved) {
        if (!saved.changed.empty()) {
          *asks = {true, slot, path, std::move(saved.changed)};
          return;
        }
        console.toasts().withdraw(asks.get());  // the message why the text was not saved
        if (!saved.result) return console.toast(Severity::fault, saved.result.error().sentence(), asks.get());
        texts.saved(slot, path, saved.text);
        console.toast(Severity::ok, fmt::format("Saved as {}.", path.string()));
      },
      desk.work.alive());
}

void Program::ask_or_open(Frame& f, const std::filesystem::path& path) {
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  if (!texts.edited(texts.chosen())) return open(f, path);
  to_open_ = path;
  question_ = fmt::format("The text of {} {} has unsaved changes. {} would replace it.",
                          f.catalog.program.slot_word, texts.chosen(), path.filename().string());
  asking_replace_ = true;
}

void Program::ask_or_empty(Frame& f) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  if (!texts.edited(texts.chosen())) return texts.opened(texts.chosen(), {}, TextFile());
  to_open_.clear();
  question_ =
      fmt::format("The text of {} {} has unsaved changes.", f.catalog.program.slot_word, texts.chosen());
  asking_replace_ = true;
}

void Program::open(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  desk.work.worker().run(
      [path] { return load_text(path); },
      [&console = f.console, &texts = desk.programs.texts, slot = desk.programs.texts.chosen(), path,
       attempt = &to_open_](Result<TextFile> file) {
        console.toasts().withdraw(attempt);
        if (!file) return console.toast(Severity::fault, file.error().sentence(), attempt);
        if (file->was_latin1)
          console.toast(Severity::plain, "The file is not in UTF-8. It was read as Latin-1.");
        texts.opened(slot, path, std::move(*file));
      },
      desk.work.alive());
}

void Program::draw_dialogs(Frame& f) {
  if (asking_replace_) {
    const bool emptied = to_open_.empty();
    const Dialog what{.title = emptied ? "Begin a new text?" : "Replace the text?",
                      .sentences = question_,
                      .yes = emptied ? "Begin anew" : "Replace",
                      .no = "Keep the text"};
    if (dialog(f.ui, "program/replace", asking_replace_, what) == Answer::yes) {
      ProgramTexts& texts = f.tab.desk().programs.texts;
      emptied ? texts.opened(texts.chosen(), {}, TextFile()) : open(f, to_open_);
    }
  }
  if (asking_clear_) {
    const Dialog what{.title = "Empty the program in the controller?",
                      .sentences = "It is deleted in the controller. The text here stays.",
                      .yes = "Empty it",
                      .no = "Leave it"};
    if (dialog(f.ui, "program/clear", asking_clear_, what) == Answer::yes) start(f, ProgramJob::Goal::clear);
  }
  if (overwrite_->asking) {
    const Dialog what{.title = "Overwrite the file?",
                      .sentences = overwrite_->question,
                      .yes = "Overwrite it",
                      .no = "Leave it unchanged"};
    if (dialog(f.ui, "program/overwrite", overwrite_->asking, what) == Answer::yes)
      write(f, overwrite_->slot, overwrite_->path, true);
  }
  if (const auto path = open_.draw(f.ui)) ask_or_open(f, *path);
  if (const auto path = save_.draw(f.ui)) write(f, f.tab.desk().programs.texts.chosen(), *path, true);
}

}  // namespace hw::panels
