#include "panels/setup/setup.h"

#include <array>
#include <utility>

#include <fmt/core.h>

#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float facts_width = 272;

void column_line(Ui& ui, float x, float top, float bottom) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, top), ImVec2(x + ui.hair(), bottom), ui[Tone::line]);
}

/// The words of Store. Loading a compiled program has already stored it.
Path store_words(const Frame& f) {
  const Catalog& c = f.catalog;
  if (c.program.compiled && c.variables.count > 0)
    return Path("Keeps the set-up, and variables from {}{} on, at power-off. Programs are kept anyway.",
                c.variables.prefix, c.variables.stored_from);
  if (c.can.store_life == 0) return Path("Keeps set-up and programs at power-off.");
  if (f.now.store_count < 0)
    return Path("Keeps set-up and programs at power-off. The memory is rated for {} writes.",
                c.can.store_life);
  return Path("Keeps set-up and programs at power-off. {} of {} writes used.", f.now.store_count,
              c.can.store_life);
}

void row_line(Ui& ui, const Frame& f, float y) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(ui.px(f.area.x), y),
                                            ImVec2(ui.px(f.area.right()), y + ui.hair()), ui[Tone::line]);
}

}  // namespace

void Setup::draw(Frame& f) {
  rows_.resize(f.catalog.params.size());
  follow(f);
  draw_toolbar(f);
  draw_filter(f);
  draw_problems(f);
  const bool facts = f.area.width >= 760;
  const float top = ImGui::GetCursorScreenPos().y;
  const float list_width = facts ? f.area.width - facts_width : f.area.width;
  draw_list(f, list_width);
  if (facts) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + list_width), top));
    column_line(f.ui, f.ui.px(f.area.x + list_width), top, f.ui.px(f.area.bottom()));
    draw_facts(f, f.ui.px(f.area.x + list_width));
  }
  draw_question(f);
  draw_files(f);
}

// The commands under way, and the first reading.
void Setup::follow(Frame& f) {
  if (f.tab.desk().setup.changes(f.now) == 0) from_file_.clear();  // the values were written or undone
  if (f.connected() && !asked_to_read_) {
    asked_to_read_ = true;
    for (std::size_t i = 0; i < f.catalog.params.size(); ++i)
      if (f.catalog.params[i].readable && !f.now.params[i].known) {
        f.send(intent::ReadParams());
        break;
      }
  }
  const auto report = f.tab.desk().setup_write.take_report();
  if (!report.sentence.empty()) f.toast(report.good ? Severity::ok : Severity::fault, report.sentence);
  if (f.now.forgotten(storing_)) storing_ = 0;
  const IntentOutcome* stored = f.now.outcome_of(storing_);
  if (stored && stored->state != IntentState::pending) {
    storing_ = 0;
    if (stored->state != IntentState::done)
      return f.toast(Severity::fault, std::string(stored->sentence.view()), &storing_);
    std::string words = "Stored in the controller.";
    if (f.now.store_count >= 0 && f.catalog.can.store_life > 0)
      words += fmt::format(" {} of {} writes used.", f.now.store_count, f.catalog.can.store_life);
    f.toast(Severity::ok, std::move(words));
  }
}

std::string Setup::summary(const Frame& f) const {
  const SetupEdits& edits = f.tab.desk().setup;
  const int changes = edits.changes(f.now);
  int unknown = 0;
  for (std::size_t i = 0; i < f.catalog.params.size(); ++i)
    unknown += f.catalog.params[i].readable && !f.now.params[i].known;
  std::string words;
  if (changes > 0 && !from_file_.empty())
    words = fmt::format("{} from {}, not written yet.", changes, from_file_);
  else if (changes > 0)
    words = fmt::format("{} edited, not written yet.", changes);
  else if (unknown > 0)
    words = fmt::format("{} not read yet.", unknown);
  else if (!f.now.unsaved_setup)
    words = "All values are those of the controller.";
  if (f.now.unsaved_setup) words += words.empty() ? "In force, but not stored." : " Not stored.";
  return words;
}

// ---- toolbar
// -----------------------------------------------------------------------------------------------

void Setup::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x + 16), at.y + ui.px(8)));
  draw_write(f);
  ImGui::SameLine(0, ui.px(8));
  if (button(ui, "setup/read", "Read all",
             {.disabled = f.no_link(),
              .tip = "Reads every value from the controller. Your edits stay.",
              .height = 40})
          .clicked)
    f.send(intent::ReadParams());
  if (f.catalog.can.store) {
    ImGui::SameLine(0, ui.px(8));
    draw_store(f);
  }
  draw_file_buttons(f, at.y + ui.px(8));
  row_line(ui, f, at.y + ui.px(56));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(56)));
}

void Setup::draw_write(Frame& f) {
  const Desk& desk = f.tab.desk();
  const SetupWrite& writing = desk.setup_write;
  const int changes = desk.setup.changes(f.now);
  char label[48];
  const auto end =
      writing.busy()
          ? fmt::format_to_n(label, sizeof label, "Writing {} of {}", writing.written() + 1, writing.all())
      : changes == 0
          ? fmt::format_to_n(label, sizeof label, "Write changes")
          : fmt::format_to_n(label, sizeof label, "Write {} change{}", changes, changes == 1 ? "" : "s");
  ButtonOptions o{.style = changes > 0 ? ButtonStyle::primary : ButtonStyle::normal, .height = 40};
  o.disabled = !f.connected()   ? f.no_link()
               : writing.busy() ? "The values are being written."
               : changes == 0   ? "No value here differs from the controller."
                                : "";
  if (button(f.ui, "setup/write", {label, std::min(end.size, sizeof label)}, o).clicked) ask_or_write(f);
}

void Setup::draw_store(Frame& f) {
  const std::string_view why = f.connected() && storing_ ? "The set-up is being stored." : f.no_link();
  const std::string_view label = f.area.width < 560 ? "Store" : "Store in controller";
  const Path tip = store_words(f);
  if (!button(f.ui, "setup/store", label, {.disabled = why, .tip = tip, .height = 40}).clicked) return;
  f.withdraw(&storing_);  // the message why values were not stored
  storing_ = f.send_and_watch(intent::Store());
}

void Setup::draw_file_buttons(Frame& f, float top) {
  Ui& ui = f.ui;
  const ButtonOptions quiet{.style = ButtonStyle::quiet, .height = 40};
  const float width = button_width(ui, "Open", quiet) + button_width(ui, "Save", quiet);
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.right() - 4 - width), top));
  if (button(ui, "setup/open", "Open", quiet).clicked)
    open_.ask_open("Open a set-up", open_.folder(), {".toml"});
  ImGui::SameLine(0, 0);
  if (button(ui, "setup/save", "Save", quiet).clicked)
    save_.ask_save("Save the set-up", save_.folder() / fmt::format("{}-setup.toml", f.catalog.model),
                   {".toml"});
}

void Setup::draw_filter(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float height = 48;
  const float field = f.area.width >= 640 ? 200 : 140;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x + 16), at.y + ui.px(8)));
  list_changed_ |=
      text_field(ui, "setup/filter", "Search", filter_, {.placeholder = "Search", .width = field}).edited;
  ImGui::SameLine(0, ui.px(12));
  static constexpr std::array<std::string_view, 3> names = {"All", "Changed", "Not factory"};
  const int picked = segment(ui, "setup/show", names, static_cast<int>(show_), {.cell_width = 40});
  if (picked >= 0) show_ = static_cast<Show>(picked), list_changed_ = true;
  ImGui::SameLine(0, ui.px(16));
  const float left = ImGui::GetCursorScreenPos().x;
  const std::string words = summary(f);
  const Tone tone = f.tab.desk().setup.changes(f.now) > 0 || f.now.unsaved_setup ? Tone::warn : Tone::ink2;
  draw_text_in_two_lines(ui, left, ui.px(f.area.right() - 16), at.y + ui.px(height / 2), Face::body, ui[tone],
                         words);
  show(ui, {.id = "setup/state", .kind = Kind::text, .label = "State", .value = words},
       {ImVec2(left, at.y), ImVec2(ui.px(f.area.right() - 16), at.y + ui.px(height))});
  row_line(ui, f, at.y + ui.px(height));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height) + ui.hair()));
}

void Setup::draw_problems(Frame& f) {
  if (problems_.empty()) return;
  Ui& ui = f.ui;
  constexpr std::size_t most = 4;
  const std::size_t lines = std::min(problems_.size(), most) + (problems_.size() > most ? 1 : 0);
  const float height = ui.px(20 * static_cast<float>(lines) + 56);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  tinted(ui, Severity::warn, height);
  const float left = ui.px(f.area.x + 16), right = ui.px(f.area.right() - 16);
  for (std::size_t i = 0; i < lines; ++i) {
    const float middle = at.y + ui.px(18 + 20 * static_cast<float>(i));
    if (i < most) {
      draw_text_line(ui, left, right, middle, Face::body, ui[Tone::ink], problems_[i]);
      continue;
    }
    char more[32];
    const auto end = fmt::format_to_n(more, sizeof more, "{} more", problems_.size() - most);
    draw_text_line(ui, left, right, middle, Face::body, ui[Tone::ink2],
                   {more, std::min(end.size, sizeof more)});
  }
  ImGui::SetCursorScreenPos(ImVec2(left, at.y + height - ui.px(40)));
  if (button(ui, "setup/problems/close", "Close", {.style = ButtonStyle::outlined}).clicked)
    problems_.clear();
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
}

// ---- list
// --------------------------------------------------------------------------------------------------

bool Setup::listed(const Frame& f, std::size_t i) const {
  const SetupEdits& edits = f.tab.desk().setup;
  if (show_ == Show::changed && !edits.changed(i, f.now)) return false;
  if (show_ == Show::off_factory && !edits.off_factory(i, f.now)) return false;
  return edits.matches(i, filter_);
}

void Setup::draw_list(Frame& f, float width) {
  Ui& ui = f.ui;
  SetupEdits& edits = f.tab.desk().setup;
  const float top = ImGui::GetCursorScreenPos().y;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), top));
  begin_part(ui, "setup/list", ui.px(width) - ui.hair(), ui.px(f.area.bottom()) - top, Tone::panel, 16);
  if (std::exchange(list_changed_, false)) ImGui::SetScrollY(0);  // search results begin at the top
  const float left = ImGui::GetCursorScreenPos().x;
  const float right = left + ImGui::GetContentRegionAvail().x;
  const bool beside = f.area.width >= 760;
  const float field = order_.field_width(ui, f.catalog, (right - left) / ui.scale);
  bool any = false;
  for (const SetupList::Section& section : order_.sections(f.catalog)) {
    bool begun = false;
    for (const std::size_t i : section.params) {
      if (!listed(f, i)) continue;
      if (!std::exchange(begun, true)) section_title(ui, section.title);
      any = true;
      if (SetupRow(f, edits, i, rows_[i], {left, right, field}).draw(beside)) chosen_ = i;
      if (!beside && chosen_ == i) draw_explanation(f, f.catalog.params[i], left, right);
    }
  }
  if (!any) {
    gap(ui, 16);
    wrapped(ui, Face::body, Tone::ink2,
            show_ == Show::changed && filter_.empty() ? "No value here differs from the controller."
            : filter_.empty()                         ? "Every value is the factory value."
                              : "No parameter name or explanation contains these words.");
  }
  gap(ui, 24);
  end_part();
}

void Setup::draw_explanation(Frame& f, const ParamInfo& p, float left, float right) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ImVec2(left + ui.px(56), ImGui::GetCursorScreenPos().y - ui.px(2)));
  wrapped(ui, Face::small, Tone::ink2, p.explanation, (right - left) / ui.scale - 56);
  ImGui::SetCursorScreenPos(ImVec2(left, ImGui::GetCursorScreenPos().y + ui.px(8)));
}

void Setup::draw_facts(Frame& f, float left) {
  if (chosen_ >= f.catalog.params.size()) return;
  Ui& ui = f.ui;
  const ParamInfo& p = f.catalog.params[chosen_];
  const ParamState& has = f.now.params[chosen_];
  ImGui::SetCursorScreenPos(ImVec2(left + ui.hair(), ImGui::GetCursorScreenPos().y));
  begin_part(ui, "setup/facts", 0, ui.px(f.area.bottom()) - ImGui::GetCursorScreenPos().y, Tone::panel, 16);
  section_title(ui, p.mnemonic, p.manual);
  wrapped(ui, Face::body_medium, Tone::ink, p.label);
  gap(ui, 8);
  wrapped(ui, Face::body, Tone::ink2, p.explanation);
  gap(ui, 12);
  if (const auto shown = f.tab.desk().setup.shown(chosen_, f.now); shown && !p.choices.empty()) {
    wrapped(ui, Face::body, Tone::ink, value_in_words(p, *shown));
    gap(ui, 12);
  }
  const auto fact = [&](const char* id, const char* key, const std::string& value, Tone tone = Tone::ink) {
    key_value(ui, id, key, value, tone);
  };
  const ShownUnit unit = shown_unit(f, p);
  if (p.choices.empty() && p.bits.empty())
    fact("setup/facts/range", "Range",
         range_in(unit, p) + (unit.name.empty() || unit.name.starts_with('/') ? "" : " ") + unit.name);
  fact("setup/facts/factory", "Factory value", text_in(unit, p, p.fallback));
  fact("setup/facts/controller", "Controller has",
       has.known    ? text_in(unit, p, has.value)
       : p.readable ? "not read"
                    : "cannot be read");
  if (const auto edited = f.tab.desk().setup.edited(chosen_))
    fact("setup/facts/here", "Here", text_in(unit, p, *edited), Tone::warn);
  if (unit.per != 1 && has.known)
    fact("setup/facts/own", "On the wire", fmt::format("{} {}", has.value, p.unit));
  fact("setup/facts/kept", "After power-off",
       !p.stored    ? "lost"
       : !has.known ? "as last stored"
       : has.stored ? "kept"
                    : "not stored yet",
       p.stored && has.known && !has.stored ? Tone::warn : Tone::ink);
  if (!p.warning.empty()) {
    gap(ui, 8);
    wrapped(ui, Face::small, Tone::warn, p.warning);
  }
  gap(ui, 16);
  end_part();
}

// ---- writing
// -----------------------------------------------------------------------------------------------

void Setup::ask_or_write(Frame& f) {
  question_.clear();
  int warnings = 0;
  for (const std::size_t i : f.tab.desk().setup.to_send(f.now)) {
    const ParamInfo& p = f.catalog.params[i];
    if (p.warning.empty()) continue;
    const auto value = *f.tab.desk().setup.edited(i);
    question_title_ = ++warnings == 1 ? fmt::format("Set \"{}\"?", p.label)
                                      : fmt::format("Set {} values with a warning?", warnings);
    question_ += fmt::format("{}{} = {}. {}", question_.empty() ? "" : "\n", p.mnemonic,
                             value_in_words(p, value), p.warning);
  }
  asking_ = warnings > 0;
  if (!asking_) write(f, false);
}

void Setup::write(Frame& f, bool confirmed) {
  const auto send = [&](IntentBody body) { return f.send_and_watch(std::move(body)); };
  f.tab.desk().setup_write.begin(f.tab.desk().setup, f.now, f.catalog, confirmed, send);
}

void Setup::draw_question(Frame& f) {
  if (!asking_) return;
  const Dialog what{
      .title = question_title_, .sentences = question_, .yes = "Write", .no = "Leave it unchanged"};
  if (dialog(f.ui, "setup/confirm", asking_, what) == Answer::yes) write(f, true);
}

// ---- files
// -------------------------------------------------------------------------------------------------

void Setup::draw_files(Frame& f) {
  Desk& desk = f.tab.desk();
  Console& console = f.console;
  if (const auto path = open_.draw(f.ui)) taken_from_file(f, load_backup(*path), path->filename().string());
  const auto path = save_.draw(f.ui);
  if (!path) return;
  const void* attempt = &save_;
  f.withdraw(attempt);  // the message why the file was not saved
  Backup file = desk.setup.to_file(f.now);
  file.name = f.tab.name();
  desk.work.worker().run(
      [path = *path, text = write_backup(file, f.catalog)] { return write_file(path, text); },
      [&console, attempt, path = *path](Result<> saved) {
        if (saved)
          console.toast(Severity::ok, fmt::format("The set-up was saved as {}.", path.string()));
        else
          console.toast(Severity::fault, saved.error().sentence(), attempt);
      },
      desk.work.alive());
}

void Setup::taken_from_file(Frame& f, const Result<Backup>& file, const std::string& name) {
  f.withdraw(&open_);
  if (!file) return f.toast(Severity::fault, file.error().sentence(), &open_);
  const auto checked = check_backup(*file, f.catalog, name);
  if (!checked) return f.toast(Severity::fault, checked.error().sentence(), &open_);
  int differing = 0;
  problems_ = f.tab.desk().setup.take(*checked, f.now, &differing);
  from_file_ = name;
  for (SetupRowState& row : rows_) row.number.reset();
  if (differing == 0)
    return f.toast(Severity::plain,
                   fmt::format("{} holds the values that the controller already has.", name));
  f.toast(Severity::plain,
          differing == 1 ? fmt::format("One value of {} differs from the controller. Write sends it.", name)
                         : fmt::format("{} values of {} differ from the controller. Write sends them.",
                                       differing, name));
}

}  // namespace hw::panels
