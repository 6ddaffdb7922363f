#include "panels/blocks.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/sequence_file.h"
#include "core/sequence/words.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"
#include "gui/area.h"
#include "gui/console.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/overwrite_question.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float palette_width = 148, text_width_wide = 264, path_height = 240;

/// "Step 3.2 (arc): why" is about the second step within the third.
std::optional<sequence::StepPath> path_in(std::string_view what) {
  constexpr std::string_view step = "Step ";
  if (!what.starts_with(step)) return std::nullopt;
  what.remove_prefix(step.size());
  sequence::StepPath path;
  for (;;) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(what.data(), what.data() + what.size(), number);
    if (error != std::errc() || number == 0) return std::nullopt;
    path.push_back(number - 1);
    what.remove_prefix(static_cast<std::size_t>(end - what.data()));
    if (!what.starts_with('.')) return path;
    what.remove_prefix(1);
  }
}

std::string number_of(const sequence::StepPath& path) {
  std::string text;
  for (const std::size_t place : path) text += fmt::format("{}{}", text.empty() ? "" : ".", place + 1);
  return text;
}

}  // namespace

void Blocks::draw(Frame& f) {
  editor_ = &f.tab.desk().blocks.editor;
  if (std::exchange(loads_, editor_->loads()) != editor_->loads()) choose(std::nullopt);
  for (const auto& path : f.tab.desk().take_dropped("blocks")) ask_or_open(f, path);
  use_keys(f);
  work_out(f);
  trial_.follow(f, problem_.empty() ? text_ : SequenceText());
  draw_toolbar(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float asked = overwrite_question_height(f), bottom = f.ui.px(f.area.bottom());
  const float height = (bottom - asked - at.y) / f.ui.scale;
  const bool palette = f.area.width >= 560, side = f.area.width >= 760;
  const float left = palette ? palette_width : 0, right = side ? text_width_wide : 0;
  if (palette) draw_palette(f, height);
  ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + left), at.y));
  draw_list(f, left, f.area.width - left - right, height);
  if (side) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + f.area.width - right), at.y));
    const float path = f.catalog.axes.size() > 1 && height >= 420 ? path_height : 0;
    draw_text_side(f, height - path);
    if (path > 0) draw_path_side(f, at.y + f.ui.px(height - path), path);
  }
  if (asked > 0) draw_overwrite_question(f, bottom - asked, asked);
  draw_dialogs(f);
}

/// Only when something has changed: a panel at rest works nothing out.
void Blocks::work_out(Frame& f) {
  if (std::exchange(worked_out_, editor_->version()) == editor_->version()) return;
  const Language* language = f.tab.desk().language();
  problem_.clear(), facts_.clear();
  text_ = SequenceText();
  rows_.clear();
  for (const sequence::StepRow& r : editor_->rows())
    rows_.push_back({r.path, number_of(r.path), std::string(sequence::title_of(r.step->body)),
                     sequence::summary_of(r.step->body, editor_->sequence()), r.step->skipped, false});
  if (!language)
    return problem_.assign("This controller has no language that blocks could be written in."), void();
  auto written = language->write(editor_->sequence(), f.catalog);
  if (!written) {
    problem_ = written.error().what;
    return find_refused();
  }
  text_ = std::move(*written);
  const ProgramReport report = language->analyse(text_.text, 0);
  for (const Problem& p : report.problems)
    if (p.error && problem_.empty()) problem_ = p.sentence;
  if (!text_.remarks.empty()) facts_ = text_.remarks.front();
}

void Blocks::find_refused() {
  const auto refused = path_in(problem_);
  for (Row& row : rows_) row.refused = refused && row.path == *refused;
}

// ---- what is done with all of it

void Blocks::ask_or_open(Frame& f, const std::filesystem::path& path) {
  to_open_ = path;
  asking_open_ = f.tab.desk().blocks.edited();
  if (!asking_open_) open(f, to_open_);
}

void Blocks::open(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  desk.worker().run(
      [path]() -> Result<sequence::Sequence> {
        constexpr std::uintmax_t largest = 64u << 20;
        const auto text = read_file(path, largest);
        if (!text) return fail(text.error());
        return sequence::read_sequence(*text, path.filename().string());
      },
      [&console = f.console, &blocks = desk.blocks, path](Result<sequence::Sequence> sequence) {
        if (!sequence) return console.toast(Mood::fault, sequence.error().sentence());
        blocks.opened(path, std::move(*sequence));
      },
      desk.alive());
}

void Blocks::save(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  desk.worker().run(
      [path, sequence = desk.blocks.editor.shared()] {
        return write_file(path, sequence::write_sequence(*sequence));
      },
      [&console = f.console, &blocks = desk.blocks, version = desk.blocks.editor.version(),
       path](Result<> written) {
        if (!written) return console.toast(Mood::fault, written.error().sentence());
        blocks.saved(path, version);
        console.toast(Mood::ok, fmt::format("Saved as {}.", path.string()));
      },
      desk.alive());
}

// ---- drawing

void Blocks::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  run_.draw(f, text_,
            editor_->sequence().steps.empty() ? "There are no blocks yet." : std::string_view(problem_));
  const auto next = [&ui](float gap) { ImGui::SameLine(0, ui.px(gap)); };
  next(16);
  if (button(ui, "blocks/undo", "Undo",
             {.style = ButtonStyle::quiet,
              .disabled = editor_->can_undo() ? "" : "Nothing to take back.",
              .height = 40})
          .clicked)
    editor_->undo(), choose(chosen_);
  next(0);
  if (button(ui, "blocks/redo", "Redo",
             {.style = ButtonStyle::quiet,
              .disabled = editor_->can_redo() ? "" : "Nothing was taken back.",
              .height = 40})
          .clicked)
    editor_->redo(), choose(chosen_);
  next(0);
  draw_files(f);
  end_toolbar(f, at);
}

void Blocks::draw_files(Frame& f) {
  Ui& ui = f.ui;
  const BlockList& blocks = f.tab.desk().blocks;
  const float y = ImGui::GetCursorScreenPos().y;
  const ButtonOptions look{.style = ButtonStyle::quiet, .height = 40};
  const float width = ui.px(button_width(ui, "Open", look)) + ui.px(button_width(ui, "Save", look));
  const float x = ui.px(f.area.right() - 8) - width;
  const std::string name = blocks.file().filename().string();
  if (!name.empty())
    draw_text_line(ui, ImGui::GetCursorScreenPos().x + ui.px(8), x - ui.px(8), y + ui.px(20), Face::body_bold,
                   ui[blocks.edited() ? Tone::warn : Tone::ink], name);
  ImGui::SetCursorScreenPos(ImVec2(x, y));
  if (button(ui, "blocks/open", "Open", look).clicked) ask_open();
  ImGui::SameLine(0, 0);
  if (button(ui, "blocks/save", "Save", look).clicked) ask_save(f);
}

void Blocks::draw_text_side(Frame& f, float height) {
  Ui& ui = f.ui;
  draw_line_down(f);
  begin_part(ui, "blocks/side", 0, ui.px(height), Tone::panel, 16);
  const float width = ImGui::GetContentRegionAvail().x / ui.scale;
  section_title(ui, "Text it writes", facts_.empty() ? "" : "with a remark");
  if (!problem_.empty()) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::fault, problem_, width);
    show(ui, {"blocks/problem", Kind::text, "Problem", problem_},
         {from, ImVec2(from.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
    gap(ui, 8);
  }
  if (!facts_.empty()) {
    wrapped(ui, Face::small, Tone::ink2, facts_, width);
    gap(ui, 8);
  }
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float line = ui.px(20);
  const int chosen = chosen_row();
  std::string_view rest = text_.text;
  for (std::size_t n = 0; n < text_.step_of_line.size(); ++n) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const float y = from.y + static_cast<float>(n) * line;
    if (chosen >= 0 && text_.step_of_line[n] == chosen)
      draw_across(ui, y, y + line, ui[Tone::sel], ui[Tone::ink]);
    draw_text_line(ui, from.x, from.x + ui.px(28), y + line / 2, Face::code_time, ui[Tone::ink3],
                   Path("{}", n + 1));
    draw_text_line(ui, from.x + ui.px(32), from.x + ui.px(width), y + line / 2, Face::code_field,
                   ui[Tone::ink], rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  ImGui::Dummy(ImVec2(1, line * static_cast<float>(text_.step_of_line.size())));
  show(ui, {"blocks/text", Kind::text, "Text it writes", text_.text},
       {from, ImVec2(from.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  end_part();
}

void Blocks::draw_path_side(Frame& f, float y, float height) {
  Ui& ui = f.ui;
  const float x = ui.px(f.area.right() - text_width_wide) + ui.hair();
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(ui.px(f.area.right()), y + ui.hair()),
                                            ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(x, y + ui.hair()));
  trial_.draw_path(f, chosen_row(), text_width_wide - 1, height - 1);
  if (const int step = trial_.clicked_step(); step >= 0 && step < static_cast<int>(rows_.size()))
    choose(rows_[ix(step)].path);
}

int Blocks::chosen_row() const {
  for (std::size_t i = 0; chosen_ && i < rows_.size(); ++i)
    if (rows_[i].path == *chosen_) return static_cast<int>(i);
  return -1;
}

void Blocks::ask_open() { open_.ask_open("Open a sequence", open_.folder(), {".toml"}); }

void Blocks::ask_save(const Frame& f) {
  const auto& path = f.tab.desk().blocks.file();
  save_.ask_save("Save the sequence", path.empty() ? save_.folder() / "sequence.toml" : path, {".toml"});
}

/// As the buttons; arrows alone jog, so a block is moved with Alt.
void Blocks::use_keys(Frame& f) {
  const Keyboard& keys = f.ui.keyboard;
  if (keys.pressed(Command::save)) ask_save(f);
  if (keys.pressed(Command::open)) ask_open();
  if (keys.typing() || f.ui.registry.top_layer() > 0) return;
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, true); };
  if (io.KeyCtrl && pressed('Z')) io.KeyShift ? editor_->redo() : editor_->undo(), choose(chosen_);
  if (io.KeyCtrl && pressed('Y')) editor_->redo(), choose(chosen_);
  if (!chosen_) return;
  if (io.KeyAlt && pressed(GLFW_KEY_UP)) move(-1);
  if (io.KeyAlt && pressed(GLFW_KEY_DOWN)) move(1);
  if (io.KeyCtrl && pressed('D')) change_chosen(&sequence::Editor::duplicate);
  if (io.KeyCtrl && pressed('G')) change_chosen(&sequence::Editor::put_into_loop);
  if (pressed(GLFW_KEY_DELETE)) change_chosen(&sequence::Editor::remove);
}

void Blocks::draw_dialogs(Frame& f) {
  run_.draw_dialog(f, text_);
  if (const auto path = open_.draw(f.ui)) ask_or_open(f, *path);
  if (asking_open_) {
    const Dialog what{.title = "Replace the blocks?",
                      .sentences = "They have changes that are in no file.",
                      .yes = "Replace",
                      .no = "Keep them"};
    if (dialog(f.ui, "blocks/discard", asking_open_, what) == Answer::yes) open(f, to_open_);
  }
  if (const auto path = save_.draw(f.ui)) save(f, *path);
}

}  // namespace hw::panels
