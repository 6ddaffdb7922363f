#include "gui/widgets/file_dialog.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <imgui_internal.h>

#include "gui/model/lower_case.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/row.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 5000;

std::string size_in_words(std::uintmax_t bytes) {
  char words[32];
  if (bytes < 1000)
    std::snprintf(words, sizeof words, "%d bytes", static_cast<int>(bytes));
  else if (bytes < 1'000'000)
    std::snprintf(words, sizeof words, "%.1f kB", static_cast<double>(bytes) / 1e3);
  else
    std::snprintf(words, sizeof words, "%.1f MB", static_cast<double>(bytes) / 1e6);
  return words;
}

fs::path expanded(std::string_view text) {
  if (text == "~" || text.starts_with("~/"))
    if (const char* home = std::getenv("HOME"))
      return fs::path(home) / fs::path(text.substr(std::min<std::size_t>(2, text.size())));
  return fs::path(text);
}

bool is_folder(const fs::path& p) {
  std::error_code error;
  return fs::is_directory(p, error);
}
bool is_there(const fs::path& p) {
  std::error_code error;
  return fs::exists(p, error);
}

}  // namespace

void FileDialog::ask_open(std::string title, const fs::path& at, std::vector<std::string> suffixes) {
  start(std::move(title), at, std::move(suffixes), false);
}

void FileDialog::ask_save(std::string title, const fs::path& at, std::vector<std::string> suffixes) {
  start(std::move(title), at, std::move(suffixes), true);
}

void FileDialog::start(std::string title, const fs::path& at, std::vector<std::string> suffixes,
                       bool saving) {
  title_ = std::move(title);
  suffixes_ = std::move(suffixes);
  saving_ = saving;
  open_ = true;
  appeared_ = all_ = false;
  replaced_.clear();
  std::error_code error;
  fs::path folder = at.empty() || is_folder(at) ? at : at.parent_path();
  if (folder.empty()) folder = folder_.empty() ? fs::current_path(error) : folder_;
  look_into(fs::absolute(folder, error));
  if (saving && !at.empty() && !is_folder(at)) show_name(at.filename().string());
  help_.complete = [this](std::string& text, std::size_t& cursor) { return complete(text, cursor); };
  help_.history = [this](std::string& text, int direction) { return walk(text, direction); };
}

void FileDialog::look_into(const fs::path& folder) {
  folder_ = folder.lexically_normal();
  if (folder_.filename().empty() && folder_.has_parent_path() && folder_ != folder_.root_path())
    folder_ = folder_.parent_path();
  chosen_ = -1;
  sentence_.clear();
  read_folder();
  show_name({});
}

void FileDialog::show_name(std::string_view name) {
  path_text_ = (folder_ / "").string() + std::string(name);
  replaced_.clear();
}

bool FileDialog::shown(std::string_view name, bool folder) const {
  if (name.starts_with('.')) return false;
  if (folder || all_ || suffixes_.empty()) return true;
  const std::string low = lower_case(name);
  return std::any_of(suffixes_.begin(), suffixes_.end(),
                     [&](const std::string& s) { return low.ends_with(lower_case(s)); });
}

void FileDialog::read_folder() {
  entries_.clear();
  std::error_code error;
  fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, error);
  if (error) {
    sentence_ = "The folder " + folder_.string() + " cannot be read: " + error.message() + ".";
    return;
  }
  for (const fs::directory_iterator end; at != end && entries_.size() < most_entries; at.increment(error)) {
    if (error) break;
    std::error_code ignored;
    Entry entry;
    entry.name = at->path().filename().string();
    entry.folder = at->is_directory(ignored);
    if (!shown(entry.name, entry.folder)) continue;
    if (!entry.folder) entry.about = size_in_words(at->file_size(ignored));
    entries_.push_back(std::move(entry));
  }
  if (entries_.size() == most_entries)
    sentence_ = "Only the first 5000 names are shown. The path can be typed.";
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower_case(a.name) < lower_case(b.name);
  });
}

fs::path FileDialog::typed() const {
  const fs::path p = expanded(path_text_);
  return (p.is_absolute() ? p : folder_ / p).lexically_normal();
}

/// Called for Enter and the button. Opens a folder; returns any other path if it is valid.
std::optional<fs::path> FileDialog::accept() {
  fs::path path = typed();
  if (is_folder(path)) {
    look_into(path);
    return {};
  }
  if (!saving_) {
    if (is_there(path)) return path;
    sentence_ = "There is no file " + path.string() + ".";
    return {};
  }
  if (path.filename().empty()) {
    sentence_ = "A name is missing.";
    return {};
  }
  if (!path.has_extension() && !suffixes_.empty()) path += suffixes_.front();
  if (!is_folder(path.parent_path())) {
    sentence_ = "There is no folder " + path.parent_path().string() + ". Nothing was saved.";
    return {};
  }
  if (is_there(path) && replaced_ != path) {
    replaced_ = path;
    path_text_ = path.string();
    sentence_ = path.filename().string() + " exists already. Press Replace to overwrite it.";
    return {};
  }
  return path;
}

/// Called for Tab. Completes the longest common beginning of all matching names.
bool FileDialog::complete(std::string& text, std::size_t& cursor) {
  const fs::path whole = expanded(text);
  const fs::path folder = (whole.is_absolute() ? whole : folder_ / whole).parent_path();
  const std::string begun = whole.filename().string();
  std::error_code error;
  std::string common;
  int hits = 0;
  bool is_dir = false;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(begun) || (begun.empty() && name.starts_with('.'))) continue;
    std::error_code ignored;
    is_dir = at->is_directory(ignored);
    if (hits++ == 0)
      common = name;
    else
      common.resize(static_cast<std::size_t>(
          std::mismatch(common.begin(), common.end(), name.begin(), name.end()).first - common.begin()));
  }
  if (hits == 0) return false;
  std::string next = (folder / common).string();
  if (hits == 1 && is_dir) next += '/';
  if (next == text) return false;
  text = next;
  cursor = text.size();
  return true;
}

/// Called for Up and Down. Takes the next name of the list.
bool FileDialog::walk(std::string& text, int direction) {
  if (entries_.empty()) return false;
  chosen_ = std::clamp(chosen_ + direction, 0, static_cast<int>(entries_.size()) - 1);
  reveal_ = true;
  show_name(entries_[static_cast<std::size_t>(chosen_)].name);
  text = path_text_;
  return true;
}

std::optional<fs::path> FileDialog::draw(Ui& ui) {
  if (!open_ || !begin_modal(ui, "file", open_, 640, 520)) return {};
  if (!appeared_) ui.focus.move_to("file/path");
  appeared_ = true;
  const bool cancelled = ui.cancelled();
  std::optional<fs::path> path = draw_head(ui);
  const float foot = ui.px(56) + (sentence_.empty() ? 0 : ui.px(24));
  if (auto clicked = draw_list(ui, std::max(ui.px(64), ImGui::GetContentRegionAvail().y - foot)))
    path = clicked;
  if (auto pressed = draw_foot(ui)) path = pressed;
  if (cancelled) open_ = false;
  if (path) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  end_modal();
  return path;
}

std::optional<fs::path> FileDialog::draw_head(Ui& ui) {
  text(ui, Face::title_bold, Tone::ink, title_);
  gap(ui, 8);
  if (button(ui, "file/up", "", {.icon = Icon::up, .tip = "The folder above"}).clicked)
    look_into(folder_.parent_path());
  ImGui::SameLine();
  FieldOptions options;
  options.face = Face::code_field;
  options.help = &help_;
  options.keep_focus = true;
  const Field field = text_field(ui, "file/path", "path", path_text_, options);
  if (field.edited) {
    sentence_.clear();
    replaced_.clear();
  }
  gap(ui, 8);
  return field.entered ? accept() : std::nullopt;
}

std::optional<fs::path> FileDialog::draw_list(Ui& ui, float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui[Tone::well]);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("entries", ImVec2(0, height), false, ImGuiWindowFlags_NoNav);
  const float row_height = ui.px(32);
  if (reveal_ && chosen_ >= 0)
    ImGui::SetScrollY(std::max(0.0f, static_cast<float>(chosen_) * row_height - height * 0.5f));
  reveal_ = false;
  if (entries_.empty()) text(ui, Face::body, Tone::ink3, "   This folder has no matching files.");
  int entered = -1;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()), row_height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Entry& e = entries_[static_cast<std::size_t>(i)];
      const std::string id = "file/" + e.name;
      const Touch t = row(ui, id, e.name, {.chosen = i == chosen_, .hairline = false, .value = e.about});
      const float middle = t.rect.centre().y, right = t.rect.max.x - ui.px(12);
      draw_icon(ImGui::GetWindowDrawList(), e.folder ? Icon::folder : Icon::file,
                ImVec2(t.rect.min.x + ui.px(18), std::floor(middle)), ui.px(12), ui[Tone::ink2]);
      const float about = std::ceil(text_width(ui, Face::small, e.about));
      draw_text_line(ui, t.rect.min.x + ui.px(36), right - about - ui.px(8), middle, Face::body,
                     ui[Tone::ink], e.name);
      draw_text_line(ui, right - about, right + 1, middle, Face::small, ui[Tone::ink2], e.about);
      if (t.clicked) {
        chosen_ = i;
        sentence_.clear();
        show_name(e.name);
      }
      if (t.double_clicked) entered = i;
    }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (entered < 0) return {};
  show_name(entries_[static_cast<std::size_t>(entered)].name);
  return accept();
}

std::optional<fs::path> FileDialog::draw_foot(Ui& ui) {
  if (!sentence_.empty()) {
    gap(ui, 4);
    named_text(ui, "file/sentence", Face::body, Tone::fault, sentence_);
  }
  gap(ui, 8);
  if (!suffixes_.empty() &&
      button(ui, "file/all", "All files", {.style = ButtonStyle::segment, .on = all_}).clicked) {
    all_ = !all_;
    read_folder();
    chosen_ = -1;
  }
  if (!suffixes_.empty()) ImGui::SameLine();
  const std::string_view verb = !saving_ ? "Open" : replaced_.empty() ? "Save" : "Replace";
  const ButtonOptions no{.style = ButtonStyle::outlined}, yes{.style = ButtonStyle::primary};
  const float both = ui.px(button_width(ui, "Cancel", no)) + ui.px(button_width(ui, verb, yes)) + ui.px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + std::max(0.0f, ImGui::GetContentRegionAvail().x - both), at.y));
  if (button(ui, "file/cancel", "Cancel", no).clicked) open_ = false;
  ImGui::SameLine();
  if (button(ui, saving_ ? "file/save" : "file/open", verb, yes).clicked) return accept();
  return {};
}

}  // namespace hw::gui
