#include "gui/model/tab.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "core/device/travel_check.h"
#include "core/session/session.h"
#include "gui/model/ending_words.h"
#include "gui/model/run_places.h"
#include "gui/model/status_sentence.h"

namespace hw::gui {

const Snapshot Tab::nothing_known;
const BenchView Tab::no_bench;

DisplayUnit display_unit(const Catalog& catalog, const Profile& profile, AxisId axis) {
  DisplayUnit steps;
  steps.name = catalog.step_word;
  if (profile.unit.empty() || profile.unit == catalog.step_word) return steps;
  const AxisProfile& wish = profile.axes[axis.index];
  if (const OwnUnit& own = wish.own_unit; wish.unit_choice == own_unit_choice && own.per_step != 0)
    return DisplayUnit{own.name, wish.reversed ? -own.per_step : own.per_step, decimals_of(own.per_step),
                       true};
  for (const UnitChoice& choice : catalog.units)
    if (choice.label == wish.unit_choice)
      return DisplayUnit{choice.unit, wish.reversed ? -choice.per_step : choice.per_step, choice.decimals,
                         true};
  return steps;
}

static Tab::Door door_of(Session& session) {
  return {[&session](IntentBody body, std::optional<double> ago_s) {
            const auto asked_at = ago_s ? std::optional(session.now() - from_seconds(*ago_s)) : std::nullopt;
            return session.send(std::move(body), asked_at);
          },
          [&session](BenchCommand command) { session.operate_bench(std::move(command)); }};
}

static std::array<std::string, max_axes> power_words(const Catalog& catalog) {
  std::array<std::string, max_axes> words;
  for (std::size_t i = 0; i < catalog.axes.size() && i < words.size(); ++i)
    words[i] = fmt::format("Motor power of {} is off. Switch it on first.", catalog.axes[i].name);
  return words;
}

static Catalog catalog_on(const Catalog& catalog, bool bus) {
  Catalog c = catalog;
  if (bus && c.axes.size() == 1 && c.addressed()) c.axes[0].name = c.id();
  return c;
}

Tab::Tab(std::shared_ptr<Session> session, std::string key, bool on_bus)
    : profile_key(std::move(key)),
      jog([this](IntentBody body) { return send_followed(std::move(body)); }),
      session_(std::move(session)),
      address_(session_->address()),
      catalog_(catalog_on(session_->catalog(), on_bus)),
      id_(catalog_.id()),
      door_(door_of(*session_)),
      desk_(catalog_, session_->type().language ? &session_->type().language() : nullptr,
            session_->type().explain),
      power_is_off_(power_words(catalog_)) {
  work_out_units();
  refresh();
}

Tab::Tab(Address address, Catalog catalog, Door door, const Language* language, TrafficLog::Explain explain)
    : jog([this](IntentBody body) { return send_followed(std::move(body)); }),
      address_(std::move(address)),
      catalog_(std::move(catalog)),
      id_(catalog_.id()),
      door_(std::move(door)),
      desk_(catalog_, language, explain),
      power_is_off_(power_words(catalog_)) {
  work_out_units();
}

const DeviceType* Tab::type() const { return session_ ? &session_->type() : nullptr; }

void Tab::refresh() {
  if (!session_) return;
  now_ = &session_->snapshot();
  bench_ = &session_->bench_view();
  clock_ = session_->now();
  session_->notices().drain([this](Notice& notice) { take(notice); });
  session_->endings().drain([this](const Ending& ending) { take(ending); });
  desk_.traffic.drain(session_->traffic());
  follow_counting();
  follow_fates();
  tell_what_is_watched();
  find_why_not_move();
  unset_read = unset_read || now_->any_axis_moving();
  banner_folded = banner_folded && now_->link.state == LinkState::lost;
  desk_.refresh(*now_, *bench_, clock_, [this](IntentBody body) { return send(std::move(body)); });
}

void Tab::show(const Snapshot& snapshot, const BenchView& bench, Instant clock) {
  now_ = &snapshot;
  bench_ = &bench;
  clock_ = clock;
  follow_counting();
  follow_fates();
  tell_what_is_watched();
  find_why_not_move();
  unset_read = unset_read || now_->any_axis_moving();
  banner_folded = banner_folded && now_->link.state == LinkState::lost;
  desk_.refresh(*now_, *bench_, clock_, [this](IntentBody body) { return send(std::move(body)); });
}

void Tab::take(Notice& notice) {
  if (notice.kind == Notice::Kind::program) return desk_.listed(notice);
  const bool bad = notice.kind == Notice::Kind::warning || notice.kind == Notice::Kind::error;
  desk_.events.add({Happening::Mark::message, bad, notice.at, {}, notice.text, -1});
  notices_.push_back(std::move(notice));
}

IntentId Tab::send(IntentBody body) {
  desk_.sent(body);
  if (auto* run = std::get_if<intent::RunProgram>(&body); run && run->places.empty()) {
    const bool first = catalog_.program.threads == 0 || run->slot == 0;  // threads share one text
    if (first) run->places = places_of_held(desk_, run->slot, catalog_, *now_);
  }
  if (const auto* text = std::get_if<intent::SendText>(&body))
    note(fmt::format("{} was sent{}", text->text, text->broadcast ? " to all devices" : ""));
  if (std::holds_alternative<intent::Stop>(body) || std::holds_alternative<intent::Abort>(body))
    return stop_ = door_.send(std::move(body), hand_acted_s_ago_);
  if (!closing_of(body)) return door_.send(std::move(body), hand_acted_s_ago_);
  IntentBody again = body;
  const IntentId id = door_.send(std::move(body), hand_acted_s_ago_);
  may_ask_.emplace_back(id, std::move(again));
  return id;
}

IntentId Tab::send_followed(IntentBody body) {
  const bool keep_alive = std::holds_alternative<intent::JogKeepAlive>(body);
  const IntentId id = send(std::move(body));
  if (!keep_alive) followed_.push_back(id);
  return id;
}

void Tab::stop_all(StoppedBy by) {
  jog.forget();
  note(by == StoppedBy::key ? "Stop was requested with Esc" : "Stop was requested with its button");
  send_followed(intent::Stop(-1, by));
}

void Tab::stopped_with(IntentId stop) {
  jog.forget();
  note("Stop of all devices was requested");
  desk_.stopped();
  followed_.push_back(stop);
  stop_ = stop;
}

void Tab::take(const Ending& ending) {
  const auto position = [this](AxisId axis, Steps place) {
    return std::string(format_with_unit(place, unit(axis)).view());
  };
  desk_.events.add(event_of(ending, catalog_, position));
  desk_.stop_times.add(ending, position, catalog_.can.tells_slowing);
}

/// Records a user action where it stays, even when a flood of traffic has pushed it out of the terminal.
void Tab::note(std::string words) {
  desk_.events.add({Happening::Mark::message, false, clock_, {}, std::move(words), -1});
}

std::vector<Notice> Tab::take_notices() { return std::exchange(notices_, {}); }

void Tab::follow_fates() {
  const auto settled = [this](IntentId id) {
    const IntentFate* fate = now_->fate_of(id);
    if (!fate) return now_->forgotten(id);  // else not received yet
    if (fate->fate == Fate::pending) return false;
    if (fate->fate == Fate::done) return true;
    if (id == jog.jog_intent()) jog.forget();  // there is no jog to stop
    if (fate->asks) return true;               // follow_questions() handles it
    complaints_.push_back(words_of(*fate));
    desk_.events.add({Happening::Mark::message, true, clock_, {}, complaints_.back(), -1});
    return true;
  };
  std::erase_if(followed_, settled);
  follow_questions();
  follow_stop();
}

// One that has failed while there is no link is still owed.
void Tab::follow_stop() {
  const IntentFate* fate = now_->fate_of(stop_);
  if (fate ? fate->fate == Fate::pending : !now_->forgotten(stop_)) return;
  if ((fate && fate->fate == Fate::done) || now_->link.connected()) stop_ = 0;
}

std::string Tab::words_of(const IntentFate& fate) const {
  if (!fate.past) return std::string(fate.sentence.view());
  return describe_past(catalog_, *fate.past, [this](AxisId axis, Steps place) {
    return std::string(format_with_unit(place, unit(axis)).view());
  });
}

void Tab::follow_questions() {
  const auto settled = [this](Intent& intent) {
    const IntentFate* fate = now_->fate_of(intent.id);
    if (!fate) return now_->forgotten(intent.id);
    if (fate->fate == Fate::pending) return false;
    if (fate->asks) question_ = Question{std::move(intent.body), std::string(fate->sentence.view())};
    return true;
  };
  std::erase_if(may_ask_, settled);
}

// Sends the groups drawn since the last call. After an absence the controller has forgotten nothing, but its
// driver may have.
void Tab::tell_what_is_watched() {
  const std::uint32_t groups = std::exchange(looked_at_, 0);
  const bool there = now_->link.state == LinkState::good || now_->link.state == LinkState::late;
  if (!there) {
    watched_ = 0;
    return;
  }
  if (groups == watched_) return;
  watched_ = groups;
  send(intent::Watch(groups));
}

std::string_view Tab::why_not_move(AxisId axis) const {
  if (!why_not_move_.empty() || !powerless(catalog_, *now_, axis)) return why_not_move_;
  return power_is_off_[axis.index];
}

void Tab::find_why_not_move() {
  if (told_ && told_link_ == now_->link.state && told_program_ == now_->program) return;
  told_ = true;
  told_link_ = now_->link.state;
  told_program_ = now_->program;
  const ProgramState& p = now_->program;
  const bool busy =
      p.owned && (p.run == RunState::running || p.run == RunState::waiting || p.run == RunState::held);
  if (told_link_ == LinkState::connecting)
    why_not_move_ =
        "The controller is being identified. Jog, Go and Home are available when it has answered.";
  else if (told_link_ == LinkState::lost || told_link_ == LinkState::closed)
    why_not_move_ = "There is no link. Jog, Go and Home are available again when the controller answers.";
  else if (busy)
    why_not_move_ = fmt::format("{} {} {}. Jog, Go and Home are available again when it ends or is stopped.",
                                catalog_.program.slot_word, p.slot,
                                p.run == RunState::running ? "is running"
                                : p.run == RunState::held  ? "is held"
                                                           : "waits");
  else
    why_not_move_.clear();
}

std::string_view Tab::name() const {
  if (bus) return bus->name();
  if (!profile.name.empty()) return profile.name;
  return default_name.empty() ? std::string_view(catalog_.short_name) : std::string_view(default_name);
}

std::string Tab::axis_title(AxisId axis) const {
  const std::string& own = catalog_.axes[axis.index].name;
  const std::string& users = profile.axes[axis.index].name;
  return users.empty() ? own : own + " " + users;
}

std::string Tab::unkept() const {
  std::string all;
  for (const auto& panel : panels)
    if (const std::string_view what = panel ? panel->unkept() : ""; !what.empty())
      all.append(all.empty() ? "" : " ").append(what);
  return all;
}

void Tab::profile_edited() {
  profile_changed = true;
  work_out_units();
  tell_travel();
}

void Tab::tell_travel() {
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Travel& travel = profile.axes[i].travel; travel != std::exchange(told_travel_[i], travel))
      send_followed(intent::SetTravel(AxisId{static_cast<std::uint8_t>(i)}, travel));
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Backlash& backlash = profile.axes[i].backlash;
        backlash != std::exchange(told_backlash_[i], backlash))
      send_followed(intent::SetBacklash(AxisId{static_cast<std::uint8_t>(i)}, backlash));
}

void Tab::choose_jog(Steps step, Pps speed) {
  const auto take = [&](Tab& tab) {
    if (tab.profile.jog_step == step && tab.profile.jog_speed == speed) return;
    tab.profile.jog_step = step;
    tab.profile.jog_speed = speed;
    tab.profile_edited();
  };
  if (!bus) return take(*this);
  for (Tab* member : bus->members) take(*member);
}

// An axis counts in other units with a closed loop than without.
void Tab::follow_counting() {
  for (std::size_t i = 0; i < catalog_.axes.size() && i < units_.size(); ++i) {
    if (units_[i].real || catalog_.loop_word.empty()) continue;
    const std::string& word = now_->axes[i].in_counts ? catalog_.loop_word : catalog_.step_word;
    if (units_[i].name != word) units_[i].name = word;
  }
}

void Tab::work_out_units() {
  for (std::size_t i = 0; i < catalog_.axes.size() && i < units_.size(); ++i)
    units_[i] = display_unit(catalog_, profile, AxisId{static_cast<std::uint8_t>(i)});
}

}  // namespace hw::gui
