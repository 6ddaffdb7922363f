#include "panels/connect/rate_raise.h"

#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "core/session/session_group.h"
#include "core/session/transport_list.h"
#include "gui/shell/console.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr std::string_view closed_meanwhile = "The controller was closed meanwhile.";

int rate_in(std::string_view label) {
  int rate = 0;
  const auto read = std::from_chars(label.data(), label.data() + label.size(), rate);
  return read.ec == std::errc() && std::string_view(read.ptr).starts_with(" baud") ? rate : 0;
}

std::vector<Tab*> all_on_wire(Tab& tab) { return tab.bus ? tab.bus->members : std::vector<Tab*>{&tab}; }

bool all_connected(Tab& tab) {
  const std::vector<Tab*> all = all_on_wire(tab);
  return std::all_of(all.begin(), all.end(), [](const Tab* t) { return t->now().link.connected(); });
}

std::string with_rate(Address address, int rate) {
  address.options["baud"] = std::to_string(rate);
  return address.text();
}

}  // namespace

int find_rate_param(const Catalog& catalog) {
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const auto& choices = catalog.params[i].choices;
    if (!choices.empty() && std::all_of(choices.begin(), choices.end(),
                                        [](const ParamChoice& c) { return rate_in(c.label) > 0; }))
      return static_cast<int>(i);
  }
  return -1;
}

std::int64_t rate_choice(const ParamInfo& param, int rate) {
  for (const ParamChoice& choice : param.choices)
    if (rate_in(choice.label) == rate) return choice.value;
  return -1;
}

const Address& address_of_all(const Tab& tab) {
  return tab.bus && tab.bus->group ? tab.bus->group->address() : tab.address();
}

int rate_of(const Tab& tab) {
  const Address& address = tab.address();
  const TransportInfo* way = find_transport(address.transport);
  const auto wire = address.options.find("wire");
  const bool spends_byte_times =
      address.emulated() && wire != address.options.end() && wire->second == "real";
  if (!spends_byte_times && (!way || !way->has_rate)) return 0;
  return address.number("baud", tab.catalog().can.usual_baud).value_or(0);
}

Result<Tab*> open_elsewhere(Console& console, Tab& tab, const std::string& address) {
  const auto there = Address::parse(address);
  if (!there) return hw::fail(there.error());
  const Tab* other = there->where.empty() ? nullptr : console.open_at(there->where);
  const bool own = other && (other == &tab || (tab.bus && other->bus == tab.bus));
  if (other && !own)
    return hw::fail(FaultKind::port, fmt::format("{} is open already, as {}.", there->where, other->name()),
                    "Nothing was changed.", "Use its tab, or close it first.");
  const std::string before = address_of_all(tab).text(), name(tab.settings.profile.name);
  console.close(tab);
  auto opened = console.open(address);
  if (!opened) (void)console.open(before);
  if (opened && (*opened)->settings.profile.name.empty() && !name.empty()) console.rename(**opened, name);
  console.show_page(console.list().pages[0].id);
  return opened;
}

// ---- steps

void RateRaise::start(Console& console, Tab& tab, int rate) {
  const int index = find_rate_param(tab.catalog());
  if (index < 0 || under_way()) return;
  const ParamInfo& param = tab.catalog().params[static_cast<std::size_t>(index)];
  words_.clear();
  stored_ = false;
  mnemonic_ = param.mnemonic;
  old_rate_ = rate_of(tab);
  new_rate_ = rate;
  old_value_ = rate_choice(param, old_rate_);
  new_value_ = rate_choice(param, new_rate_);
  address_ = address_of_all(tab).text();
  old_address_ = with_rate(address_of_all(tab), old_rate_);
  new_address_ = with_rate(address_of_all(tab), new_rate_);
  if (old_value_ < 0 || new_value_ < 0) return fail("The controller does not support one of the two rates.");
  enter(console, Step::set);
}

void RateRaise::enter(Console& console, Step step) {
  step_ = step;
  since_ = console.clock();
  if (step == Step::ask) return reopen(console, new_address_);
  if (step == Step::back) return reopen(console, old_address_);
  Tab* there = tab(console);
  if (!there) return fail(std::string(closed_meanwhile));
  if (step == Step::set) send_to_all(*there, intent::SetParam(mnemonic_, new_value_, true));
  if (step == Step::set_back) send_to_all(*there, intent::SetParam(mnemonic_, old_value_, true));
  if (step == Step::store || step == Step::store_back) send_to_all(*there, intent::Store());
}

void RateRaise::send_to_all(Tab& tab, const IntentBody& body) {
  asked_.clear();
  for (Tab* member : all_on_wire(tab)) asked_.push_back(member->send(body));
}

Tab* RateRaise::tab(Console& console) const {
  for (const auto& tab : console.tabs())
    if (Console::is_face(*tab) && address_of_all(*tab).text() == address_) return tab.get();
  return nullptr;
}

void RateRaise::reopen(Console& console, const std::string& address) {
  Tab* there = tab(console);
  if (!there) return fail(std::string(closed_meanwhile));
  const auto opened = open_elsewhere(console, *there, address);
  if (!opened) return fail(opened.error().sentence());
  address_ = address_of_all(**opened).text();
}

void RateRaise::fail(std::string words) {
  words_ = std::move(words);
  step_ = Step::failed;
}

RateRaise::Outcome RateRaise::outcome(Console& console) {
  Tab* there = tab(console);
  if (!there) return fail(std::string(closed_meanwhile)), Outcome::failed;
  const std::vector<Tab*> all = all_on_wire(*there);
  Outcome all_of_them = Outcome::done;
  for (std::size_t i = 0; i < all.size() && i < asked_.size(); ++i) {
    const IntentOutcome* reported = all[i]->now().outcome_of(asked_[i]);
    if (reported && (reported->state == IntentState::refused || reported->state == IntentState::failed)) {
      words_ = all[i]->messages.words_of(*reported);
      return Outcome::failed;
    }
    const bool is_done = reported ? reported->state == IntentState::done : all[i]->now().forgotten(asked_[i]);
    if (!is_done) all_of_them = Outcome::pending;
  }
  return all_of_them;
}

void RateRaise::tick(Console& console) {
  if (step_ == Step::ask) return tick_ask(console);
  if (step_ == Step::back) return tick_back(console);
  if (!under_way()) return;
  const Outcome now = outcome(console);
  if (now == Outcome::pending || step_ == Step::failed) return;
  if (now == Outcome::done) {
    if (step_ == Step::set) return enter(console, Step::store);
    if (step_ == Step::store) stored_ = true;
    if (step_ == Step::store) return enter(console, Step::ask);
    if (step_ == Step::set_back && stored_) return enter(console, Step::store_back);
    return fail(words_);  // everything is as before
  }
  // A setting that is not stored yet is set back. In later steps the console can undo nothing more.
  if (step_ == Step::set || step_ == Step::store) return enter(console, Step::set_back);
  fail(words_);
}

bool RateRaise::waits_for_power(const Console& console) const {
  return step_ == Step::ask && console.clock() - since_ > before_power;
}

void RateRaise::go_back(Console& console) {
  if (step_ != Step::ask) return;
  words_ = fmt::format("It did not answer at {} baud, so it was set back to {} baud.", new_rate_, old_rate_);
  enter(console, Step::back);
}

void RateRaise::tick_ask(Console& console) {
  Tab* there = tab(console);
  if (!there) return fail(std::string(closed_meanwhile));
  if (all_connected(*there)) {
    words_ = fmt::format("It answers at {} baud, and keeps that rate.", new_rate_);
    step_ = Step::done;
    (void)console.recent().remove(old_address_);
  } else if (console.clock() - since_ > longest_wait) {
    go_back(console);
  }
}

void RateRaise::tick_back(Console& console) {
  Tab* there = tab(console);
  if (!there) return fail(std::string(closed_meanwhile));
  if (all_connected(*there)) return enter(console, Step::set_back);
  if (console.clock() - since_ > longest_way_back)
    fail(
        fmt::format("Switch it off and on: it answers neither at {} nor at {} baud. It then uses the rate "
                    "stored last. Search finds it at any rate.",
                    new_rate_, old_rate_));
}

}  // namespace hw::panels
