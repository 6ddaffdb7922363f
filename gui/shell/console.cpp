#include "gui/shell/console.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include <fmt/core.h>

#include "core/session/assets.h"
#include "core/session/json_file.h"
#include "core/session/session_group.h"
#include "gui/model/gui_log.h"
#include "gui/model/list_run.h"
#include "gui/model/lower_case.h"
#include "gui/model/step_recorder.h"
#include "gui/shell/banner_subject.h"
#include "gui/shell/follow.h"
#include "gui/shell/messages.h"
#include "gui/shell/outside.h"
#include "gui/shell/top_bar.h"
#include "gui/shell/workspace.h"
#include "gui/surface/ui.h"
#include "gui/widgets/area.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"

namespace hw::gui {

Console::Console(PanelList list, Outside outside)
    : log(outside.wake),
      list_(list),
      outside_(std::make_unique<Outside>(std::move(outside))),
      recent_(outside_->folders),
      pages_(list.pages.size()) {
  report_failure(recent_.load());
  load_choices();
  report_last_ends();
  if (!list_.pages.empty()) show_page(list_.pages[0].id);
}

Console::~Console() = default;

Instant Console::clock() const { return outside_->scheduler.now(); }
PortFinder& Console::ports() { return outside_->ports ? *outside_->ports : no_search_.ports; }
DeviceFinder& Console::devices() { return outside_->devices ? *outside_->devices : no_search_.devices; }
const UserFolders& Console::folders() const { return outside_->folders; }

// ---- messages and views

void Console::show_page(std::string_view id) {
  if (active_) active_->jog.let_go();
  page_ = id;
  ports().watch(!list_.pages.empty() && page_ == list_.pages[0].id);
}

void Console::examine_link(const Tab& tab) {
  if (list_.pages.empty()) return;
  wanted_.examined = &tab;
  show_page(list_.pages[0].id);
}

Tab* Console::take_link_to_examine() {
  const Tab* wanted = std::exchange(wanted_.examined, nullptr);
  for (const auto& tab : tabs_)
    if (wanted && tab.get() == wanted) return tab.get();
  return nullptr;
}

Sheet& Console::help_object() {
  if (!help_.sheet) help_.sheet = list_.make_help();
  return *help_.sheet;
}

Page& Console::page_object(std::string_view id) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < list_.pages.size(); ++i)
    if (list_.pages[i].id == id) at = i;
  if (!pages_[at]) pages_[at] = list_.pages[at].make();
  return *pages_[at];
}

void Console::show_panel(std::string_view id, std::string_view widget) {
  if (!active_) return;
  show_page({});
  active_->panels.in_front = id;
  wanted_.widget = widget;
}

constexpr float sizes[] = {0.75f, 0.9f, 1.0f, 1.1f, 1.25f, 1.5f, 1.75f, 2.0f, 2.5f, 3.0f};

void Console::set_size(float size) { size_ = std::clamp(size, std::begin(sizes)[0], std::end(sizes)[-1]); }

void Console::step_size(int direction) {
  float next = direction == 0 ? 1.0f : size_;
  for (const float size : sizes) {
    if (direction > 0 && size > size_ + 0.01f) return set_size(size);
    if (direction < 0 && size < size_ - 0.01f) next = size;
  }
  set_size(next);
}

/// The panel that opens files with such a name; otherwise the program editor, which reports a file that is
/// not a text.
static const PanelEntry* opener_of(const PanelList& list, const std::string& path) {
  const std::string name = lower_case(path);
  const PanelEntry* editor = nullptr;
  for (const PanelEntry& entry : list.panels) {
    if (!entry.opens.empty() && name.ends_with(entry.opens)) return &entry;
    if (entry.id == "program") editor = &entry;
  }
  return editor;
}

static bool has(const Tab& tab, const PanelEntry* panel) {
  return panel && (!panel->wanted || panel->wanted(tab));
}

void Console::start_demo() {
  const std::filesystem::path drawing = find_asset("examples/plate.dxf");
  for (const DeviceType& type : device_types()) {
    std::string address = std::string(type.model) + "@emulator";
    const auto catalog = type.make_catalog({});
    if (catalog && catalog->addressed() && catalog->axes.size() == 1)
      address += ",id=01-04";  // a bus of four
    auto opened = open(address);
    if (!opened) {
      toast(Severity::fault, opened.error().sentence());
      continue;
    }
    ProgramTexts& texts = (*opened)->desk().programs.texts;
    if (texts.count() > 0 && texts.text(0).empty()) texts.set_text(0, catalog->program.example);
    const PanelEntry* panel = opener_of(list_, drawing.string());
    if (!drawing.empty() && has(**opened, panel))
      (*opened)->desk().dropped[std::string(panel->id)].push_back(drawing);
  }
  if (!tabs_.empty()) activate(*tabs_.front());
}

std::string Console::time_of_day(Instant when) const {
  char buffer[16];
  return std::string(format_time_of_day(outside_->day.of(when), false, buffer));
}

void Console::set_day(DayClock day) {
  outside_->day = day;
  for (const auto& tab : tabs_) tab->desk().records.traffic.set_clock(day);
}

// ---- input

void Console::stop_all(StoppedBy by) {
  gui_log().debug("all controllers are told to stop, by {}", by == StoppedBy::key ? "Esc" : "the button");
  for (const auto& tab : tabs_) {
    if (!tab->bus)
      tab->stop_all(by);
    else if (is_face(*tab))
      tab->bus->stop_all(by);
  }
}

void Console::let_go() {
  gui_log().debug("all held jogs are released: the window has lost the focus, or closes");
  for (const auto& tab : tabs_) tab->jog.let_go();
}

void Console::drop(const std::vector<std::string>& paths) {
  if (covered_)
    return toast(Severity::warn, "Answer the question first, then drop the file again. Nothing was opened.");
  if (!active()) return toast(Severity::plain, "Connect a controller first: files are opened in its editor.");
  std::map<const PanelEntry*, std::string> opened;
  for (const std::string& path : paths) {
    const std::string name = std::filesystem::path(path).filename().string();
    const PanelEntry* panel = opener_of(list_, path);
    if (!has(*active(), panel)) {
      toast(Severity::warn,
            fmt::format("{} was not opened: it needs the tab {}, which this controller does not have.", name,
                        panel ? panel->title : "Program"));
    } else if (const auto [first, alone] = opened.try_emplace(panel, name); !alone) {
      toast(Severity::warn, fmt::format("{} was not opened: {} takes one file at a time, and opens {}.", name,
                                        panel->title, first->second));
    } else {
      active()->desk().dropped[std::string(panel->id)].emplace_back(path);
      show_panel(panel->id);
    }
  }
}

// ---- frame

/// The age of the press or release that this frame shows, in seconds.
static std::optional<double> user_acted_s_ago(const Ui& ui) {
  if (ImGui::IsMouseReleased(0)) return std::max(0.0, ui.now_s - ui.input.released_at_s());
  if (ImGui::IsMouseClicked(0)) return std::max(0.0, ui.now_s - ui.input.pressed_at_s());
  if (const double at_s = ui.focus.key_acted_at_s(); at_s >= 0) return std::max(0.0, ui.now_s - at_s);
  return {};
}

void Console::refresh(Ui& ui) {
  log.follow();
  const auto ago_s = user_acted_s_ago(ui);
  for (const auto& tab : tabs_) {
    tab->refresh();
    tab->user_acted(ago_s);
    if (const auto turns = tab->desk().programs.text_turns();
        std::exchange(tab->view.text_turns, turns) != turns)
      toasts_.withdraw(&tab->desk().programs.texts);
    report_news(*tab);
    if (tab->desk().step_recorder->busy()) ui.wake_in(0.02);  // snapshots do not report its times
    if (const double due = tab->desk().autosave_due_in(tab->clock()); due >= 0) ui.wake_in(due);
  }
  for (std::string& sentence : take_closing_messages()) toast(Severity::warn, std::move(sentence));
  if (!ImGui::IsMouseDown(0)) save();  // not at each step of a dragged slider
}

// A toast always names a device of a bus, because the other devices are shown beside it.
void Console::toast(const Tab& of, Severity severity, std::string sentence, const void* about) {
  const bool adjacent = of.bus && of.bus->members.size() > 1;
  if (adjacent && !mentions(sentence, of.id())) sentence = fmt::format("{}: {}", of.id(), sentence);
  toasts_.add(severity, std::move(sentence), about, std::string(of.name()));
}

void Console::report_news(Tab& tab) {
  for (Notice& notice : tab.messages.take_notices()) {
    const bool asked = notice.kind == Notice::Kind::question && &tab == active() &&
                       dialogs.make_room(tab, std::move(notice.slots));
    if (asked) {
      asked_ = std::move(notice.text);
      continue;
    }
    toast(tab,
          notice.kind == Notice::Kind::error     ? Severity::fault
          : notice.kind == Notice::Kind::warning ? Severity::warn
                                                 : Severity::plain,
          std::move(notice.text));
  }
  for (Report& report : tab.desk().list_run->take_report())
    toast(tab, report.severity, std::move(report.sentence));
  for (Report& report : tab.desk().step_recorder->take_report())
    toast(tab, report.severity, std::move(report.sentence));
  for (std::string& complaint : tab.messages.complaints()) {
    // A refusal that repeats the question of the open dialog needs no toast. The outcome may be cut, because
    // it holds less text than a notice.
    const bool asked = !asked_.empty() && asked_.starts_with(complaint);
    if (!asked) toast(tab, Severity::fault, std::move(complaint), &tab);
    if (asked) asked_.clear();
  }
  tab.messages.complaints().clear();
  if (auto& question = tab.messages.followed.question(); question && !dialogs.open()) {
    dialogs.closing(tab, std::move(*question));
    question.reset();
  }
}

void Console::report_failure(const Result<>& outcome) {
  if (!outcome) toast(Severity::fault, outcome.error().sentence());
}

void Console::draw(Ui& ui) {
  covered_ = ui.registry.top_layer() > 0;
  refresh(ui);
  close_as_asked();
  follow_as_asked(*this);
  if (!wanted_.widget.empty()) {
    ui.registry.scroll_to(wanted_.widget);
    ui.focus.move_to(wanted_.widget);
    wanted_.widget.clear();
  }
  LayoutInput layout_input;
  layout_input.width = ui.size_px.x / ui.scale;
  layout_input.height = ui.size_px.y / ui.scale;
  layout_input.controllers = faces() + (page_.empty() ? 0 : 1);
  layout_input.splitters = splitters;
  layout_input.strip_height = active() ? strip_height(*active()) : 0;
  layout_input.right_open = right_open;
  const Layout layout = lay_out(layout_input);
  right_covers_ = layout.unfolded_covers;
  draw_top_bar(ui, *this, layout);  // STOP ALL is the first widget of the frame
  const BannerSubject in_banner = draw_workspace(ui, *this, layout);
  if (help_.open) draw_sheet(ui, *this, layout);
  draw_status_line(ui, *this, layout, in_banner);
  dialogs.draw(ui, *this);
  const std::string_view front = active() ? active()->name() : std::string_view();
  toasts_.look_at(faces() > 1 ? std::optional(front) : std::nullopt);
  draw_toasts(ui, toasts_, in_pixels(ui, layout.centre), in_pixels(ui, layout.status));
  tooltip(ui, ui.cut());
  confirm_held_key(ui);
  list_open_ = ui.takes_arrows();
  for (const auto& tab : tabs_) {
    tab->user_acted({});
    if (tab->jog.tick(ui.now_s))
      toast(Severity::warn, "Let go, and hold again: this computer was busy, so the held jog was ended.");
    ui.wake_in(tab->jog.due_in_s(ui.now_s));
  }
}

// ---- saved settings

void Console::load_choices() {
  if (!outside_->folders.enabled) return;
  const auto read = read_json(outside_->folders.state / "window.json", "the sizes of the window's parts");
  if (!read) return toast(Severity::warn, read.error().sentence());
  const auto number = [&](const char* key, float fallback) {
    const auto at = read->find(key);
    const double value = at != read->end() && at->is_number() ? at->get<double>() : fallback;
    return static_cast<float>(std::clamp(value, -1e5, 1e5));
  };
  splitters.left = number("left", splitters.left);
  splitters.right = number("right", splitters.right);
  splitters.below = number("below", splitters.below);
  splitters.below_medium = number("below_medium", splitters.below_medium);
  dark_ = number("dark", 1) != 0;
  set_size(number("size", 1));
  lower_right = static_cast<Fold>(std::clamp(static_cast<int>(number("lower_right", 0)), 0, 2));
  kept_ = choices();
}

void Console::save_choices() {
  const bool same = kept_ == choices();
  if (!outside_->folders.enabled || same) return;
  kept_ = choices();
  const nlohmann::json object = {{"left", splitters.left},
                                 {"right", splitters.right},
                                 {"below", splitters.below},
                                 {"below_medium", splitters.below_medium},
                                 {"dark", dark_ ? 1 : 0},
                                 {"size", size_},
                                 {"lower_right", static_cast<int>(lower_right)}};
  report_failure(write_json(outside_->folders.state / "window.json", object));
}

void Console::save() {
  save_choices();
  for (const auto& tab : tabs_)
    if (tab->settings.changed) {
      tab->settings.changed = false;
      report_failure(ProfileStore(outside_->folders).save(tab->settings.key, tab->settings.profile));
    }
}

}  // namespace hw::gui
