// Opens, names and closes the console's controllers, joins them on a bus, and chooses the controller in
// front.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/session/last_end.h"
#include "core/session/rehearse_together.h"
#include "core/session/session_group.h"
#include "gui/model/jog_choice.h"
#include "gui/shell/console.h"
#include "gui/shell/emulator_server.h"
#include "gui/shell/outside.h"

namespace hw::gui {

/// The user's name for the controller, or for its bus; empty: none.
static std::string users_name(const Tab& tab) {
  return tab.bus ? tab.bus->members.front()->settings.profile.bus_name : tab.settings.profile.name;
}

Result<Tab*> Console::open(std::string_view text) {
  auto address = Address::parse(text);
  if (!address) return fail(address.error());
  if (const Tab* other = address->where.empty() ? nullptr : open_at(address->where))
    return fail(FaultKind::port, fmt::format("{} is open already, as {}.", address->where, other->name()),
                "Nothing was opened.", "Use its tab, or close it first.");
  auto group = SessionGroup::open(outside_->scheduler, *address, outside_->open_wire, outside_->wake);
  if (!group) return fail(group.error());
  Tab& tab = adopt(std::move(*group));
  report_failure(recent_.opened(address->text(), users_name(tab)));
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
  bus->default_name = std::move(name);
  bus->members = std::move(members);
  for (Tab* member : bus->members) member->bus = bus;
  Tab& first = *bus->members.front();
  choose_jog(first, first.settings.profile.jog_step, first.settings.profile.jog_speed);
  activate(first);
}

Console::Together Console::rehearsal_of(const Bus& bus) const {
  if (!bus.group) return nullptr;
  std::vector<ControllerState> states;
  for (Tab* member : bus.members) states.push_back(known_state(member->desk().programs.texts, member->now()));
  return [states = std::move(states), address = bus.group->address(),
          opener = outside_->open_wire](const sequence::Sequence& sequence) {
    constexpr Duration at_most = std::chrono::hours(1);  // limits the work to some seconds
    return rehearse_together(sequence, address, states, opener, at_most);
  };
}

Console::InPieces Console::rehearsal_of(Tab& tab) const {
  if (!tab.session()) return nullptr;
  return [state = known_state(tab.desk().programs.texts, tab.now()), address = tab.address(),
          opener = outside_->open_wire](std::shared_ptr<const Pieces> pieces) {
    constexpr Duration at_most = std::chrono::hours(1);  // limits the work to some seconds
    return rehearse_pieces(std::move(pieces), address, state, opener, at_most);
  };
}

bool Console::is_face(const Tab& tab) { return !tab.bus || &tab.bus->front() == &tab; }

int Console::faces() const {
  return static_cast<int>(
      std::count_if(tabs_.begin(), tabs_.end(), [](const auto& tab) { return is_face(*tab); }));
}

Tab& Console::make_tab(std::shared_ptr<Session> session, bool on_bus) {
  const Address& address = session->address();
  // Two tabs with the same address (two emulators) keep separate texts and profiles.
  std::string key =
      free_key(profile_key(address, outside_->usb_serial ? outside_->usb_serial(address) : std::string()));
  auto tab = std::make_unique<Tab>(std::move(session), std::move(key), on_bus);
  auto profile = ProfileStore(outside_->folders).load(tab->settings.key);
  if (profile) {
    tab->settings.profile = std::move(*profile);
    tab->settings.edited();
    tab->settings.changed = false;
  } else {
    toast(Severity::warn, profile.error().sentence());
  }
  tab->settings.default_name = free_name(tab->catalog().short_name);
  if (outside_->folders.enabled)
    report_failure(tab->desk().kept.begin(Autosave(outside_->folders), tab->settings.key));
  if (outside_->folders.enabled && !tab->emulated())  // an emulator is a new controller each time
    report_failure(
        tab->desk().places.keep_under(KeptPositions(outside_->folders), tab->settings.key, clock()));
  tab->desk().work.use(outside_->worker);
  return add(std::move(tab));
}

template <class Taken>
static std::string numbered(const std::string& wanted, Taken taken) {
  std::string name = wanted;
  for (int n = 2; taken(name); ++n) name = fmt::format("{} {}", wanted, n);
  return name;
}

/// The short name, with a number if another controller has it already.
std::string Console::free_name(const std::string& wanted) const {
  return numbered(wanted, [this](const std::string& name) {
    return std::any_of(tabs_.begin(), tabs_.end(), [&](const auto& tab) { return tab->name() == name; });
  });
}

std::string Console::free_key(const std::string& wanted) const {
  return numbered(wanted, [this](const std::string& key) {
    return std::any_of(tabs_.begin(), tabs_.end(), [&](const auto& tab) { return tab->settings.key == key; });
  });
}

Tab& Console::add(std::unique_ptr<Tab> tab) {
  tab->panels.all.resize(list_.panels.size());
  tab->desk().records.traffic.set_clock(outside_->day);
  tabs_.push_back(std::move(tab));
  activate(*tabs_.back());
  return *tabs_.back();
}

static std::string opened_as(const Tab& tab) {
  return (tab.bus && tab.bus->group ? tab.bus->group->address() : tab.address()).text();
}

/// The user closes the controller, so the next start does not reopen it.
void Console::close(Tab& tab) {
  report_failure(recent_.closed(opened_as(tab)));
  close_with_bus(tab);
}

void Console::close_with_bus(Tab& tab) {
  if (!tab.bus) return close_one(tab);
  const std::shared_ptr<Bus> bus = tab.bus;
  for (Tab* member : bus->members) member->bus.reset();
  for (Tab* member : bus->members) close_one(*member);
}

/// Called for Ctrl W. Closes the controller in front, or the controller that the open question is about.
void Console::close_as_asked() {
  if (!std::exchange(close_asked_, false)) return;
  Tab* tab = dialogs.open() ? dialogs.closing() : active();
  if (tab) dialogs.close_controller(*this, *tab);
}

void Console::close_one(Tab& tab) {
  tab.jog.let_go();
  tab.desk().keep_now(tab.clock());
  save();
  if (std::shared_ptr<Session> session = tab.session()) {
    ++*closing_.left;
    Task<> closed = session->close();
    // The session lives until its last coroutine has ended; at a count of 0 the scheduler may stop.
    asio::co_spawn(outside_->scheduler.executor(), std::move(closed),
                   [session, counter = closing_.left, words = closing_.closing_messages,
                    wake = outside_->wake, name = std::string(tab.name())](std::exception_ptr) {
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
  // Serving ends, because the switch for it disappears with the row on the connection page.
  if (EmulatorServer* server = ports().server(); server && server->find(tab.settings.key))
    server->end(tab.settings.key);
  toasts_.withdraw(&tab);  // an earlier refusal no longer matters
  toasts_.withdraw(&tab.desk().programs.texts);
  tabs_.erase(at);
  if (!was_active) return;
  active_ = nullptr;
  if (tabs_.empty())
    show_page(list_.pages.empty() ? std::string_view() : list_.pages[0].id);
  else
    activate(*tabs_[std::min<std::size_t>(static_cast<std::size_t>(index), tabs_.size() - 1)]);
}

std::vector<std::string> Console::take_closing_messages() {
  std::vector<std::string> words;
  closing_.closing_messages->drain([&](Notice& notice) {
    if (notice.kind == Notice::Kind::warning || notice.kind == Notice::Kind::error)
      words.push_back(std::move(notice.text));
  });
  return words;
}

void Console::close_all() {
  report_failure(recent_.ended({date_of_today(), time_of_day(clock()).substr(0, 5)}));
  while (!tabs_.empty()) close_with_bus(*tabs_.back());
}

void Console::rename(Tab& tab, std::string name) {
  if (tab.bus) {
    tab.bus->rename(std::move(name));
  } else {
    tab.settings.profile.name = std::move(name);
    tab.settings.edited();
  }
  report_failure(recent_.renamed(opened_as(tab), users_name(tab)));
}

void Console::reconnect(Tab& tab) { tab.send_followed(intent::Reconnect()); }

Tab* Console::active() { return page_.empty() ? active_ : nullptr; }

void Console::activate(Tab& tab) {
  if (active_ && active_ != &tab) active_->jog.let_go();
  if (tab.bus) {
    auto& members = tab.bus->members;
    tab.bus->chosen =
        static_cast<std::size_t>(std::find(members.begin(), members.end(), &tab) - members.begin());
    if (active_ && active_->bus == tab.bus) tab.panels.in_front = active_->panels.in_front;
  }
  active_ = &tab;
  if (!page_.empty()) show_page({});
  if (right_covers_) right_open = false;
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

}  // namespace hw::gui
