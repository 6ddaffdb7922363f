#include "panels/program.h"

#include <array>
#include <cmath>

#include <fmt/core.h>

#include "gui/console.h"
#include "gui/keyboard.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float toolbar_height = 56, slots_height = 40, note_height = 40, line_height = 36, ask_height = 92;
constexpr float rehearsal_width = 272;

bool under_way(const ProgramState& p) {
  return p.owned && (p.run == RunState::running || p.run == RunState::waiting || p.run == RunState::held);
}

bool column_fits(const Frame& f) { return f.tier == Tier::wide && f.area.width >= 760; }

void line_across(const Frame& f, float y) {
  Ui& ui = f.ui;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(ui.px(f.area.x), y),
                                            ImVec2(ui.px(f.area.right()), y + ui.hair()), ui[Tone::line]);
}

}  // namespace

void Program::draw(Frame& f) {
  follow(f);
  shortcuts(f);
  draw_toolbar(f);
  draw_slots(f);
  const float bottom = draw_below(f);
  draw_work(f, bottom);
  draw_dialogs(f);
}

void Program::follow(Frame& f) {
  Desk& desk = f.tab.desk();
  auto told = desk.job.take_told();
  if (!told.sentence.empty()) f.toast(told.mood, std::move(told.sentence));
  for (const auto& path : std::exchange(desk.dropped, {})) ask_or_open(f, path);
  if (const double due = desk.autosave_due_in(f.clock); due >= 0) f.ui.wake_in(due + 0.01);
}

void Program::shortcuts(Frame& f) {
  const Keyboard& keys = f.ui.keyboard;
  if (keys.pressed(Command::run) && why_not_run(f).empty()) run(f, false);
  if (keys.pressed(Command::simulate)) simulate(f);
  if (keys.pressed(Command::save)) save(f);
  if (keys.pressed(Command::open)) ask_open(f);
}

// ---- toolbar
// -----------------------------------------------------------------------------------------------

std::string_view Program::why_not_run(const Frame& f) const {
  const Desk& desk = f.tab.desk();
  if (!f.connected()) return "There is no link. Run comes back when the controller answers.";
  if (desk.job.busy()) return "A program is being transferred.";
  const ProgramState& p = f.now.program;
  if (under_way(p) && p.run == RunState::running)
    return "A program is running. Run comes back when it ends or is stopped.";
  if (f.now.any_axis_moving() && !under_way(p)) return "An axis moves. Run comes back when it stands.";
  if (desk.texts.text(desk.texts.chosen()).empty() && !under_way(p)) return "The program is empty.";
  return {};
}

void Program::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ProgramState& p = f.now.program;
  const bool busy = under_way(p), waits = busy && p.run != RunState::running;
  const bool keys = f.area.width >= 700;
  const std::string_view no_program = "No program runs.";
  const std::string_view no_link = f.connected() ? std::string_view() : "There is no link.";
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x + 16), at.y + ui.px(8)));
  const auto next = [&] { ImGui::SameLine(0, ui.px(8)); };

  if (button(ui, "program/run", waits ? "Go on" : "Run",
             {.icon = Icon::play,
              .keys = keys && !waits ? "ctrl \n" : "",
              .disabled = why_not_run(f),
              .height = 40,
              .moving = true})
          .clicked)
    run(f, false);
  next();
  if (button(ui, "program/hold", "Hold",
             {.icon = Icon::pause,
              .disabled = !no_link.empty()                     ? no_link
                          : p.run == RunState::running && busy ? ""
                                                               : no_program,
              .tip = "Stops before the next command.",
              .height = 40})
          .clicked)
    f.send(intent::Pause());
  next();
  if (f.catalog.can.single_step) {
    const std::string_view why = p.run == RunState::held && busy ? no_link : why_not_run(f);
    if (button(ui, "program/step", "Step",
               {.icon = Icon::step,
                .disabled = why,
                .tip = "One command at a time.",
                .height = 40,
                .moving = true})
            .clicked)
      run(f, true);
    next();
  }
  if (button(ui, "program/stop", "Stop",
             {.icon = Icon::stop, .disabled = busy || desk.job.busy() ? "" : no_program, .height = 40})
          .clicked) {
    desk.job.give_up();
    f.send(intent::HaltProgram());
  }
  next();
  const int slot = desk.texts.chosen();
  const std::string_view why_not_simulate = !desk.language()                  ? "This model has no rehearsal."
                                            : desk.texts.text(slot).empty()   ? "The program is empty."
                                            : desk.rehearsals.under_way(slot) ? "It is being worked out."
                                                                              : "";
  if (button(ui, "program/simulate", "Simulate",
             {.icon = Icon::play_outline,
              .keys = keys ? "F5" : "",
              .disabled = why_not_simulate,
              .tip = "Tries the text without moving anything.",
              .height = 40})
          .clicked)
    simulate(f);
  next();
  draw_memory(f, ImGui::GetCursorScreenPos().x);
  line_across(f, at.y + ui.px(toolbar_height) - ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(toolbar_height)));
}

// Follows the typing: what the text costs of what there is.
void Program::draw_memory(Frame& f, float left) {
  const int capacity = f.catalog.program.capacity;
  if (capacity <= 0) return;
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen(), cost = desk.texts.cost(slot);
  const bool over = cost > capacity;
  char number[16], rest[64], whole[96];
  const auto n = fmt::format_to_n(number, sizeof number, "{}", cost);
  const auto r =
      over ? fmt::format_to_n(rest, sizeof rest, " of {}: {} too many", capacity, cost - capacity)
           : fmt::format_to_n(rest, sizeof rest, " of {} {}", capacity, f.catalog.program.capacity_unit);
  const std::string_view number_text(number, std::min(n.size, sizeof number)),
      rest_text(rest, std::min(r.size, sizeof rest));
  const auto w = fmt::format_to_n(whole, sizeof whole, "{}{}", number_text, rest_text);
  const float right = ui.px(f.area.right() - 16), middle = ImGui::GetCursorScreenPos().y + ui.px(20);
  const float rest_width = std::ceil(text_width(ui, Face::body, rest_text));
  const float number_width = std::ceil(text_width(ui, Face::body_bold, number_text));
  const float words_left = right - rest_width - number_width;
  const Tone tone = over ? Tone::fault : Tone::ink2;
  draw_text_line(ui, words_left, right, middle, Face::body_bold, ui[over ? Tone::fault : Tone::ink],
                 number_text);
  draw_text_line(ui, words_left + number_width, right + 1, middle, Face::body, ui[tone], rest_text);
  float room = words_left - ui.px(8) - left;
  const float title = std::ceil(text_width(ui, Face::body, "Memory")) + ui.px(8);
  const float bar = std::min(ui.px(124), room - title > ui.px(80) ? room - title : room);
  if (bar >= ui.px(24)) {
    const float x = words_left - ui.px(8) - bar;
    if (room - bar >= title) draw_text_line(ui, x - title, x, middle, Face::body, ui[Tone::ink2], "Memory");
    ImGui::SetCursorScreenPos(ImVec2(x, middle - ui.px(4)));
    meter(ui, "program/memory", "Memory", static_cast<float>(cost) / static_cast<float>(capacity),
          {.over = over, .words = {whole, std::min(w.size, sizeof whole)}, .width = bar / ui.scale});
  } else {
    show(ui,
         {.id = "program/memory",
          .kind = Kind::meter,
          .label = "Memory",
          .value = {whole, std::min(w.size, sizeof whole)}},
         {ImVec2(words_left, middle - ui.px(10)), ImVec2(right, middle + ui.px(10))});
  }
}

// ---- slots and files
// ---------------------------------------------------------------------------------------

void Program::draw_slots(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(slots_height / 2);
  float x = ui.px(f.area.x + 16);
  const std::string_view word = f.catalog.program.slot_word;
  if (f.area.width >= 800) {
    draw_text_line(ui, x, ui.px(f.area.right()), middle, Face::body, ui[Tone::ink2], word);
    x += std::ceil(text_width(ui, Face::body, word)) + ui.px(8);
  }
  static constexpr std::array<std::string_view, 8> digits = {"0", "1", "2", "3", "4", "5", "6", "7"};
  const auto many = std::min<std::size_t>(static_cast<std::size_t>(desk.texts.count()), digits.size());
  ImGui::SetCursorScreenPos(ImVec2(x, at.y + ui.px(4)));
  const int picked =
      segment(ui, "program/slot", std::span(digits.data(), many), desk.texts.chosen(), {.cell_width = 32});
  if (picked >= 0) desk.texts.choose(picked);
  ImGui::SameLine(0, ui.px(16));
  x = ImGui::GetCursorScreenPos().x;

  const int slot = desk.texts.chosen();
  const float files_left = ui.px(f.area.right() - 8) - file_buttons_width(f);
  const std::string name = desk.texts.file_name(slot);
  const bool edited = desk.texts.edited(slot);
  const std::string_view shown = !name.empty() ? std::string_view(name) : edited ? "not in a file" : "";
  const Face face = name.empty() ? Face::body : Face::body_bold;
  const bool mark = edited && !name.empty();
  const float mark_width = mark ? std::ceil(text_width(ui, Face::body, "edited")) + ui.px(8) : 0;
  const float name_right = std::min(files_left - mark_width, x + std::ceil(text_width(ui, face, shown)));
  draw_text_line(ui, x, name_right + 1, middle, face, ui[name.empty() ? Tone::warn : Tone::ink], shown);
  if (mark)
    draw_text_line(ui, name_right + ui.px(8), files_left, middle, Face::body, ui[Tone::warn], "edited");
  show(ui, {.id = "program/file", .kind = Kind::text, .label = "File", .value = shown},
       {ImVec2(x, at.y), ImVec2(files_left, at.y + ui.px(slots_height))});
  ImGui::SetCursorScreenPos(ImVec2(files_left, at.y + ui.px(4)));
  draw_file_buttons(f);
  line_across(f, at.y + ui.px(slots_height) - ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(slots_height)));
}

namespace {
struct FileButton {
  const char *id, *label, *short_label, *keys;
};
constexpr FileButton file_buttons[] = {{"program/check", "Check", "Check", ""},
                                       {"program/open", "Open", "Open", ""},
                                       {"program/save", "Save", "Save", "ctrl S"},
                                       {"program/store", "Store in controller", "Store", ""}};
constexpr std::array<std::string_view, 4> more = {"Save as", "Load from controller", "Empty in controller",
                                                  "New text"};
}  // namespace

ButtonOptions Program::file_button_look(const Frame& f, const char* keys) {
  return {.style = ButtonStyle::quiet, .keys = f.area.width >= 800 ? keys : ""};
}

float Program::file_buttons_width(const Frame& f) {
  float width = f.ui.px(72);
  for (const FileButton& b : file_buttons)
    width += f.ui.px(
        button_width(f.ui, f.area.width >= 800 ? b.label : b.short_label, file_button_look(f, b.keys)));
  return width;
}

void Program::draw_file_buttons(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const bool roomy = f.area.width >= 800;
  const std::string_view no_link =
      f.connected() ? std::string_view() : "There is no link. The text stays here.";
  for (const FileButton& b : file_buttons) {
    ButtonOptions look = file_button_look(f, b.keys);
    const std::string_view id = b.id;
    if (id == "program/store")
      look.disabled = !no_link.empty() ? no_link : desk.job.busy() ? "A program is being transferred." : "";
    const bool clicked = button(ui, id, roomy ? b.label : b.short_label, look).clicked;
    ImGui::SameLine(0, 0);
    if (!clicked) continue;
    if (id == "program/check") check(f);
    if (id == "program/open") ask_open(f);
    if (id == "program/save") save(f);
    if (id == "program/store") start(f, ProgramJob::Goal::store);
  }
  switch (menu(ui, "program/more", "More", more)) {
    case 0: ask_save(f); break;
    case 1: start(f, ProgramJob::Goal::fetch); break;
    case 2: asking_clear_ = true; break;
    case 3: desk.texts.opened(desk.texts.chosen(), {}, TextFile()); break;
    default: break;
  }
}

void Program::ask_open(const Frame& f) {
  open_.ask_open("Open a program", open_.folder(), {f.catalog.program.file_suffix, ".txt"});
}

void Program::ask_save(const Frame& f) {
  const ProgramTexts& texts = f.tab.desk().texts;
  const auto& path = texts.file(texts.chosen());
  const auto suggested = fmt::format("program{}", f.catalog.program.file_suffix);
  save_.ask_save("Save the program", path.empty() ? save_.folder() / suggested : path,
                 {f.catalog.program.file_suffix});
}

// ---- work
// --------------------------------------------------------------------------------------------------

void Program::draw_work(Frame& f, float bottom) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = (bottom - at.y) / ui.scale;
  const int slot = f.tab.desk().texts.chosen();
  if (height < 24) return;
  const bool column = column_fits(f) || rehearsal_open_;
  const float side = column ? rehearsal_width : 0;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  editor_.draw(f, slot, f.area.width - side, height);
  if (!column) return;
  const float x = ui.px(f.area.right() - side);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, at.y), ImVec2(x + ui.hair(), bottom), ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.hair(), at.y));
  rehearsal_.draw_column(f, slot, side - 1, height);
}

// What stands under the editor, from the bottom up; returns where the editor ends.
float Program::draw_below(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int slot = desk.texts.chosen();
  float y = ui.px(f.area.bottom());
  if (desk.job.stage() == ProgramJob::Stage::asking) {
    y -= ui.px(ask_height);
    draw_ask(f, y);
  } else {
    const HeldProgram& held = desk.texts.held(slot);
    if (held.known) note_time_ = f.console.time_of_day(held.at);
    note_ = program_note(desk.texts, slot, f.now, f.catalog.program, note_time_);
    words_ = desk.job.words(f.catalog.program);
    const bool roomy = y - at.y > ui.px(160);
    if (roomy && (!words_.empty() || !note_.sentence.empty())) {
      y -= ui.px(note_height);
      draw_note(f, y, note_height);
    }
  }
  if (!column_fits(f)) {
    y -= ui.px(line_height);
    ImGui::SetCursorScreenPos(ImVec2(at.x, y));
    if (rehearsal_.draw_line(f, slot, rehearsal_open_)) rehearsal_open_ = !rehearsal_open_;
  }
  ImGui::SetCursorScreenPos(at);
  return y;
}

void Program::draw_note(Frame& f, float top, float height) {
  Ui& ui = f.ui;
  line_across(f, top);
  const float middle = top + ui.px(height / 2), left = ui.px(f.area.x + 16);
  const bool busy = !words_.empty();
  const Mood mood = busy ? Mood::motion : note_.mood;
  const Icon icon = mood == Mood::warn    ? Icon::warning
                    : mood == Mood::fault ? Icon::diamond_solid
                    : busy                ? Icon::clock
                                          : Icon::info;
  const Tone tone = mood == Mood::warn    ? Tone::warn
                    : mood == Mood::fault ? Tone::fault
                    : busy                ? Tone::motion
                                          : Tone::ink3;
  draw_icon(ImGui::GetWindowDrawList(), icon, ImVec2(left + ui.px(6), middle), ui.px(12), ui[tone]);
  const std::string_view said = busy ? std::string_view(words_) : std::string_view(note_.sentence);
  float right = ui.px(f.area.right() - 16);
  const ProgramReport& report = f.tab.desk().texts.report(f.tab.desk().texts.chosen());
  const float said_end = left + ui.px(20) + std::ceil(text_width(ui, Face::body, said));
  if (!report.problems.empty() && said_end + ui.px(110) < right)
    right = draw_problem_link(f, report, right, middle);
  draw_text_line(ui, left + ui.px(20), right, middle, Face::body, ui[Tone::ink2], said);
  show(ui, {.id = "program/note", .kind = Kind::text, .label = "State", .value = said},
       {ImVec2(left, top), ImVec2(right, top + ui.px(height))});
}

// "2 errors, next": goes from one problem to the next.
float Program::draw_problem_link(Frame& f, const ProgramReport& report, float right, float middle) {
  Ui& ui = f.ui;
  int errors = 0;
  for (const Problem& p : report.problems) errors += p.error;
  const int n = errors > 0 ? errors : static_cast<int>(report.problems.size());
  char label[48];
  const auto end = fmt::format_to_n(label, sizeof label, "{} {}{}, show", n, errors > 0 ? "error" : "warning",
                                    n == 1 ? "" : "s");
  const std::string_view said(label, std::min(end.size, sizeof label));
  const float left = right - std::ceil(text_width(ui, Face::small, said));
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.line(Face::small) / 2)));
  if (link(ui, "program/next_problem", said)) {
    next_problem_ = (next_problem_ + 1) % static_cast<int>(report.problems.size());
    const Problem& p = report.problems[static_cast<std::size_t>(next_problem_)];
    editor_.go_to(f.tab.desk().texts.chosen(), p.line, p.column);
  }
  return left - ui.px(12);
}

void Program::draw_ask(Frame& f, float top) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), top));
  tinted(ui, Mood::warn, ui.px(ask_height));
  const float left = ui.px(f.area.x + 16);
  draw_icon(ImGui::GetWindowDrawList(), Icon::warning, ImVec2(left + ui.px(6), top + ui.px(22)), ui.px(12),
            ui[Tone::warn]);
  ImGui::SetCursorScreenPos(ImVec2(left + ui.px(20), top + ui.px(12)));
  wrapped(ui, Face::body, Tone::ink, desk.job.question(), f.area.width - 52);
  ImGui::SetCursorScreenPos(ImVec2(left + ui.px(20), top + ui.px(ask_height - 40)));
  const auto send = [&](IntentBody body) { return f.send_and_watch(std::move(body)); };
  const auto choice = [&](const char* id, const char* label, ButtonStyle style, ProgramJob::Answer answer) {
    if (button(ui, id, label, {.style = style}).clicked) desk.job.answer(answer, desk.texts, send);
    ImGui::SameLine(0, ui.px(8));
  };
  choice("program/ask/overwrite", "Overwrite it", ButtonStyle::outlined, ProgramJob::Answer::overwrite);
  choice("program/ask/fetch", "Bring it here instead", ButtonStyle::outlined,
         ProgramJob::Answer::fetch_instead);
  choice("program/ask/leave", "Leave it", ButtonStyle::outlined, ProgramJob::Answer::leave);
}

// ---- what buttons do
// ---------------------------------------------------------------------------------------

void Program::start(Frame& f, ProgramJob::Goal goal) {
  Desk& desk = f.tab.desk();
  const auto send = [&](IntentBody body) { return f.send_and_watch(std::move(body)); };
  desk.job.begin(goal, desk.texts.chosen(), desk.texts, f.now, f.catalog, send);
}

void Program::run(Frame& f, bool stepping) {
  const ProgramState& p = f.now.program;
  if (under_way(p) && p.run != RunState::running) {
    if (stepping && p.run == RunState::held)
      f.send(intent::SingleStep());
    else
      f.send(intent::Resume());
    return;
  }
  start(f, stepping ? ProgramJob::Goal::run_stepping : ProgramJob::Goal::run);
}

void Program::simulate(Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  if (!desk.language() || desk.texts.text(slot).empty()) return;
  RehearseOptions options;
  options.slot = slot;
  options.axes = static_cast<int>(f.catalog.axes.size());
  desk.rehearsals.start(*desk.language(), desk.texts.text(slot), options, desk.worker());
}

void Program::check(Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  const ProgramReport& report = desk.texts.report(slot);
  int errors = 0;
  for (const Problem& p : report.problems) errors += p.error;
  if (errors == 0)
    return f.toast(Mood::ok, fmt::format("No error. {} of {} {}.", desk.texts.cost(slot),
                                         f.catalog.program.capacity, f.catalog.program.capacity_unit));
  for (const Problem& p : report.problems) {
    if (!p.error) continue;
    editor_.go_to(slot, p.line, p.column);
    return f.toast(Mood::fault, fmt::format("{} error{}. Line {}: {}", errors, errors == 1 ? "" : "s",
                                            p.line + 1, p.sentence));
  }
}

// ---- files
// -------------------------------------------------------------------------------------------------

void Program::save(Frame& f) {
  ProgramTexts& texts = f.tab.desk().texts;
  const auto& path = texts.file(texts.chosen());
  if (path.empty()) return ask_save(f);
  save_as(f, path);
}

void Program::save_as(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  TextFile file = desk.texts.to_save(slot);
  struct Saved {
    std::string text;
    Result<> result;
  };
  desk.worker().run(
      [path, file = std::move(file)]() mutable {
        auto result = save_text(path, file);
        return Saved{std::move(file.text), std::move(result)};
      },
      [&console = f.console, &texts = desk.texts, slot, path](Saved saved) {
        if (!saved.result) return console.toast(Mood::fault, saved.result.error().sentence());
        texts.saved(slot, path, saved.text);
        console.toast(Mood::ok, fmt::format("Saved as {}.", path.string()));
      },
      desk.alive());
}

void Program::ask_or_open(Frame& f, const std::filesystem::path& path) {
  const ProgramTexts& texts = f.tab.desk().texts;
  if (!texts.edited(texts.chosen())) return open(f, path);
  to_open_ = path;
  question_ = fmt::format("The text of {} {} has changes that are in no file. {} would take its place.",
                          f.catalog.program.slot_word, texts.chosen(), path.filename().string());
  asking_replace_ = true;
}

void Program::open(Frame& f, const std::filesystem::path& path) {
  Desk& desk = f.tab.desk();
  desk.worker().run(
      [path] { return load_text(path); },
      [&console = f.console, &texts = desk.texts, slot = desk.texts.chosen(), path](Result<TextFile> file) {
        if (!file) return console.toast(Mood::fault, file.error().sentence());
        if (file->was_latin1) console.toast(Mood::plain, "The file is not in UTF-8. It was read as Latin-1.");
        texts.opened(slot, path, std::move(*file));
      },
      desk.alive());
}

void Program::draw_dialogs(Frame& f) {
  if (asking_replace_) {
    const Dialog what{
        .title = "Replace the text?", .sentences = question_, .yes = "Replace", .no = "Keep the text"};
    if (dialog(f.ui, "program/replace", asking_replace_, what) == Answer::yes) open(f, to_open_);
  }
  if (asking_clear_) {
    const Dialog what{.title = "Empty the program in the controller?",
                      .sentences = "The controller forgets it. The text here stays.",
                      .yes = "Empty it",
                      .no = "Leave it"};
    if (dialog(f.ui, "program/clear", asking_clear_, what) == Answer::yes) start(f, ProgramJob::Goal::clear);
  }
  if (const auto path = open_.draw(f.ui)) ask_or_open(f, *path);
  if (const auto path = save_.draw(f.ui)) save_as(f, *path);
}

}  // namespace hw::panels
