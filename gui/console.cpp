#include "gui/console.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include <fmt/core.h>

#include "core/session/json_file.h"
#include "core/session/session_group.h"
#include "gui/area.h"
#include "gui/messages.h"
#include "gui/outside.h"
#include "gui/top_bar.h"
#include "gui/ui.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "gui/workspace.h"

namespace hw::gui {

Console::Console(PanelList list, Outside outside)
    : list_(list),
      outside_(std::make_unique<Outside>(std::move(outside))),
      recent_(outside_->folders),
      pages_(list.pages.size()) {
  tell(recent_.load());
  load_choices();
  if (!list_.pages.empty()) show_page(list_.pages[0].id);
}

Console::~Console() = default;

Instant Console::clock() const { return outside_->scheduler.now(); }
PortFinder& Console::ports() { return outside_->ports ? *outside_->ports : no_ports_; }
DeviceFinder& Console::devices() { return outside_->devices ? *outside_->devices : no_devices_; }
const UserFolders& Console::folders() const { return outside_->folders; }

// ---- controllers

Result<Tab*> Console::open(std::string_view text) {
  auto address = Address::parse(text);
  if (!address) return fail(address.error());
  if (const Tab* other = address->where.empty() ? nullptr : open_at(address->where))
    return fail(FaultKind::port, fmt::format("{} is open already, as {}.", address->where, other->name()),
                "Nothing was opened.", "Use its tab, or close it first.");
  auto group = SessionGroup::open(outside_->scheduler, *address, outside_->open_wire, outside_->wake);
  if (!group) return fail(group.error());
  Tab& tab = adopt(std::move(*group));
  tell(recent_.opened(address->text(), std::string(tab.profile.name)));
  return &tab;
}

Tab& Console::adopt(std::shared_ptr<Session> session) { return make_tab(std::move(session), false); }

Tab& Console::adopt(std::shared_ptr<SessionGroup> group) {
  const auto& sessions = group->members();
  if (!group->is_bus()) return make_tab(sessions.front(), false);
  std::vector<Tab*> members;
  for (const auto& session : sessions) members.push_back(&make_tab(session, true));
  std::string name = fmt::format("{} {}\u2013{}", sessions.front()->catalog().short_name,
                                 members.front()->id(), members.back()->id());
  Tab& first = *members.front();
  join(std::move(members), std::move(name), std::move(group));
  return first;
}

void Console::join(std::vector<Tab*> members, std::string name, std::shared_ptr<SessionGroup> group) {
  auto bus = std::make_shared<Bus>();
  bus->group = std::move(group);
  bus->name = std::move(name);
  bus->members = std::move(members);
  for (Tab* member : bus->members) member->bus = bus;
  activate(*bus->members.front());
}

bool Console::is_face(const Tab& tab) { return !tab.bus || &tab.bus->front() == &tab; }

int Console::faces() const {
  return static_cast<int>(
      std::count_if(tabs_.begin(), tabs_.end(), [](const auto& tab) { return is_face(*tab); }));
}

Tab& Console::make_tab(std::shared_ptr<Session> session, bool on_bus) {
  const Address& address = session->address();
  // Two tabs of one address (two emulators) keep their texts and profiles apart.
  std::string key =
      free_key(profile_key(address, outside_->usb_serial ? outside_->usb_serial(address) : std::string()));
  auto tab = std::make_unique<Tab>(std::move(session), std::move(key), on_bus);
  auto profile = ProfileStore(outside_->folders).load(tab->profile_key);
  if (profile) {
    tab->profile = std::move(*profile);
    tab->profile_edited();
    tab->profile_changed = false;
  } else {
    toast(Mood::warn, profile.error().sentence());
  }
  tab->default_name = free_name(tab->catalog().short_name);
  if (outside_->folders.enabled) tell(tab->desk().keep_texts(Autosave(outside_->folders), tab->profile_key));
  tab->desk().use(outside_->worker);
  return add(std::move(tab));
}

template <class Taken>
static std::string numbered(const std::string& wanted, Taken taken) {
  std::string name = wanted;
  for (int n = 2; taken(name); ++n) name = fmt::format("{} {}", wanted, n);
  return name;
}

/// The short name, with a number for a second one that has no name of its own either.
std::string Console::free_name(const std::string& wanted) const {
  return numbered(wanted, [this](const std::string& name) {
    return std::any_of(tabs_.begin(), tabs_.end(), [&](const auto& tab) { return tab->name() == name; });
  });
}

std::string Console::free_key(const std::string& wanted) const {
  return numbered(wanted, [this](const std::string& key) {
    return std::any_of(tabs_.begin(), tabs_.end(), [&](const auto& tab) { return tab->profile_key == key; });
  });
}

Tab& Console::add(std::unique_ptr<Tab> tab) {
  tab->panels.resize(list_.panels.size());
  tab->desk().traffic.set_clock(outside_->day);
  tabs_.push_back(std::move(tab));
  activate(*tabs_.back());
  return *tabs_.back();
}

void Console::close(Tab& tab) {
  if (!tab.bus) return close_one(tab);
  const std::shared_ptr<Bus> bus = tab.bus;
  for (Tab* member : bus->members) member->bus.reset();
  for (Tab* member : bus->members) close_one(*member);
}

void Console::close_one(Tab& tab) {
  tab.jog.let_go();
  save();
  if (std::shared_ptr<Session> session = tab.session()) {
    ++*closing_;
    Task<> closed = session->close();
    // The session lives until its last coroutine has ended; the count tells when the scheduler may stop.
    asio::co_spawn(outside_->scheduler.executor(), std::move(closed),
                   [session, counter = closing_, words = last_words_, wake = outside_->wake,
                    name = std::string(tab.name())](std::exception_ptr) {
                     session->notices().drain([&](Notice& notice) {
                       notice.text = fmt::format("{}: {}", name, notice.text);
                       words->push(std::move(notice));
                     });
                     if (wake) wake();
                     --*counter;
                   });
  }
  const auto at = std::find_if(tabs_.begin(), tabs_.end(), [&](const auto& t) { return t.get() == &tab; });
  const auto index = at - tabs_.begin();
  const bool was_active = active_ == &tab;
  dialogs.close();
  tabs_.erase(at);
  if (!was_active) return;
  active_ = nullptr;
  if (tabs_.empty())
    show_page(list_.pages.empty() ? std::string_view() : list_.pages[0].id);
  else
    activate(*tabs_[std::min<std::size_t>(static_cast<std::size_t>(index), tabs_.size() - 1)]);
}

void Console::close_all() {
  while (!tabs_.empty()) close(*tabs_.back());
}

void Console::rename(Tab& tab, std::string name) {
  tab.profile.name = std::move(name);
  tab.profile_edited();
  tell(recent_.renamed(tab.address().text(), tab.profile.name));
}

void Console::reconnect(Tab& tab) { tab.send_followed(intent::Reconnect()); }

Tab* Console::active() { return page_.empty() ? active_ : nullptr; }

void Console::activate(Tab& tab) {
  if (active_ && active_ != &tab) active_->jog.let_go();
  if (tab.bus) {
    auto& members = tab.bus->members;
    tab.bus->chosen =
        static_cast<std::size_t>(std::find(members.begin(), members.end(), &tab) - members.begin());
    if (active_ && active_->bus == tab.bus) tab.centre_panel = active_->centre_panel;
  }
  active_ = &tab;
  if (!page_.empty()) show_page({});
  right_open = false;
}

void Console::activate_next(int direction) {
  if (tabs_.empty()) return;
  std::vector<Tab*> faces;
  for (const auto& tab : tabs_)
    if (is_face(*tab)) faces.push_back(tab.get());
  const int n = static_cast<int>(faces.size());
  int at = 0;
  for (int i = 0; i < n; ++i)
    if (faces[static_cast<std::size_t>(i)] == active_) at = i;
  activate(*faces[static_cast<std::size_t>(((page_.empty() ? at + direction : at) % n + n) % n)]);
}

const Tab* Console::open_at(std::string_view where) const {
  for (const auto& tab : tabs_)
    if (tab->address().where == where) return tab.get();
  return nullptr;
}

// ---- what is shown

void Console::show_page(std::string_view id) {
  if (active_) active_->jog.let_go();
  page_ = id;
  ports().watch(!list_.pages.empty() && page_ == list_.pages[0].id);
}

void Console::toggle_map() {
  if (page_ != "help") return show_page("help");
  show_page(tabs_.empty() ? list_.pages[0].id : std::string_view());
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
  active_->centre_panel = id;
  wanted_widget_ = widget;
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

void Console::start_demo() {
  for (const DeviceType& type : device_types()) {
    std::string address = std::string(type.model) + "@emulator";
    const auto catalog = type.make_catalog({});
    if (catalog && catalog->addressed() && catalog->axes.size() == 1)
      address += ",id=01-04";  // a bus of them
    auto opened = open(address);
    if (!opened) {
      toast(Mood::fault, opened.error().sentence());
      continue;
    }
    ProgramTexts& texts = (*opened)->desk().texts;
    if (texts.count() > 0 && texts.text(0).empty()) texts.set_text(0, catalog->program.example);
  }
  if (!tabs_.empty()) activate(*tabs_.front());
}

std::string Console::time_of_day(Instant when) const {
  char buffer[16];
  return std::string(format_time_of_day(outside_->day.of(when), false, buffer));
}

void Console::set_day(DayClock day) {
  outside_->day = day;
  for (const auto& tab : tabs_) tab->desk().traffic.set_clock(day);
}

// ---- hands

void Console::stop_all() {
  for (const auto& tab : tabs_) {
    if (!tab->bus)
      tab->stop_all();
    else if (is_face(*tab))
      tab->bus->stop_all();
  }
}

void Console::let_go() {
  for (const auto& tab : tabs_) tab->jog.let_go();
}

// ---- frame

void Console::refresh(Ui& ui) {
  for (const auto& tab : tabs_) {
    tab->refresh();
    if (const auto turns = tab->desk().text_turns(); std::exchange(tab->text_turns, turns) != turns)
      toasts_.withdraw(&tab->desk().texts);
    tell_news(*tab);
    if (const double due = tab->desk().autosave_due_in(tab->clock()); due >= 0) ui.wake_in(due);
  }
  last_words_->drain([this](Notice& notice) {
    if (notice.kind == Notice::Kind::warning || notice.kind == Notice::Kind::error)
      toast(Mood::warn, std::move(notice.text));
  });
  if (!ImGui::IsMouseDown(0)) save();  // not at each step of a slider that is being dragged
}

// A device of a bus is named in any case: its neighbours stand beside it.
void Console::toast(const Tab& of, Mood mood, std::string sentence, const void* about) {
  const bool neighbours = of.bus && of.bus->members.size() > 1;
  if (neighbours && !speaks_of(sentence, of.id())) sentence = fmt::format("{}: {}", of.id(), sentence);
  toasts_.add(mood, std::move(sentence), about, std::string(of.name()));
}

void Console::tell_news(Tab& tab) {
  for (Notice& notice : tab.take_notices()) {
    const bool asked = notice.kind == Notice::Kind::question && &tab == active() &&
                       dialogs.make_room(tab, std::move(notice.slots));
    if (asked) {
      asked_ = std::move(notice.text);
      continue;
    }
    toast(tab,
          notice.kind == Notice::Kind::error     ? Mood::fault
          : notice.kind == Notice::Kind::warning ? Mood::warn
                                                 : Mood::plain,
          std::move(notice.text));
  }
  for (std::string& complaint : tab.complaints()) {
    // The refusal says in a toast what a dialog asks already. A fate has less room than a notice.
    const bool asked = !asked_.empty() && asked_.starts_with(complaint);
    if (!asked) toast(tab, Mood::fault, std::move(complaint));
    if (asked) asked_.clear();
  }
  tab.complaints().clear();
}

void Console::tell(const Result<>& outcome) {
  if (!outcome) toast(Mood::fault, outcome.error().sentence());
}

void Console::draw(Ui& ui) {
  refresh(ui);
  if (!wanted_widget_.empty()) {
    ui.registry.scroll_to(wanted_widget_);
    ui.focus.move_to(wanted_widget_);
    wanted_widget_.clear();
  }
  LayoutWishes wishes;
  wishes.width = ui.size_px.x / ui.scale;
  wishes.height = ui.size_px.y / ui.scale;
  wishes.controllers = faces() + (page_.empty() ? 0 : 1);
  wishes.splitters = splitters;
  wishes.strip_height = active() ? strip_height(*active()) : 0;
  const Layout layout = lay_out(wishes);
  draw_top_bar(ui, *this, layout);  // STOP ALL is the first widget of the frame
  draw_workspace(ui, *this, layout);
  draw_status_line(ui, *this, layout);
  dialogs.draw(ui, *this);
  const std::string_view front = active() ? active()->name() : std::string_view();
  toasts_.look_at(faces() > 1 ? std::optional(front) : std::nullopt);
  draw_toasts(ui, toasts_, in_pixels(ui, layout.centre), in_pixels(ui, layout.status));
  tooltip(ui, ui.cut());
  confirm_held_key(ui);
  for (const auto& tab : tabs_) {
    tab->jog.tick(ui.now_s);
    ui.wake_in(tab->jog.due_in_s(ui.now_s));
  }
}

// ---- what is kept

void Console::load_choices() {
  if (!outside_->folders.enabled) return;
  const auto read = read_json(outside_->folders.state / "window.json", "the sizes of the window's parts");
  if (!read) return toast(Mood::warn, read.error().sentence());
  const auto number = [&](const char* key, float fallback) {
    const auto at = read->find(key);
    return at != read->end() && at->is_number() ? at->get<float>() : fallback;
  };
  splitters.left = number("left", splitters.left);
  splitters.right = number("right", splitters.right);
  splitters.below = number("below", splitters.below);
  splitters.below_medium = number("below_medium", splitters.below_medium);
  dark_ = number("dark", 1) != 0;
  set_size(number("size", 1));
  kept_ = splitters, kept_dark_ = dark_, kept_size_ = size_;
}

void Console::save_choices() {
  if (!outside_->folders.enabled || (kept_ == splitters && kept_dark_ == dark_ && kept_size_ == size_))
    return;
  kept_ = splitters, kept_dark_ = dark_, kept_size_ = size_;
  const nlohmann::json object = {{"left", splitters.left},   {"right", splitters.right},
                                 {"below", splitters.below}, {"below_medium", splitters.below_medium},
                                 {"dark", dark_ ? 1 : 0},    {"size", size_}};
  tell(write_json(outside_->folders.state / "window.json", object));
}

void Console::save() {
  save_choices();
  for (const auto& tab : tabs_)
    if (tab->profile_changed) {
      tab->profile_changed = false;
      tell(ProfileStore(outside_->folders).save(tab->profile_key, tab->profile));
    }
}

}  // namespace hw::gui
