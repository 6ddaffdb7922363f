#include "gui/model/tab.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "core/device/travel_check.h"
#include "core/session/session.h"
#include "gui/model/list_run.h"
#include "gui/model/run_places.h"
#include "gui/model/sample_feed.h"
#include "gui/model/status_sentence.h"

namespace hw::gui {

const Snapshot Tab::nothing_known;
const BenchView Tab::no_bench;

static Tab::Backend door_of(Session& session) {
  return {[&session](IntentBody body, std::optional<double> ago_s) {
            const auto asked_at = ago_s ? std::optional(session.now() - from_seconds(*ago_s)) : std::nullopt;
            return session.send(std::move(body), asked_at);
          },
          [&session](BenchCommand command) { session.operate_bench(std::move(command)); }};
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
      backend_(door_of(*session_)),
      desk_(catalog_, session_->type().language ? &session_->type().language() : nullptr,
            session_->type().explain),
      bar_(catalog_) {
  units_.work_out(catalog_, profile);
  refresh();
}

Tab::Tab(Address address, Catalog catalog, Backend backend, const Language* language,
         TrafficLog::Explain explain)
    : jog([this](IntentBody body) { return send_followed(std::move(body)); }),
      address_(std::move(address)),
      catalog_(std::move(catalog)),
      id_(catalog_.id()),
      backend_(std::move(backend)),
      desk_(catalog_, language, explain),
      bar_(catalog_) {
  units_.work_out(catalog_, profile);
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
  session_->samples().drain([this](const AxisSample& sample) { desk_.step_recorder->take(sample); });
  look_at_snapshot();
}

void Tab::show(const Snapshot& snapshot, const BenchView& bench, Instant clock) {
  now_ = &snapshot;
  bench_ = &bench;
  clock_ = clock;
  look_at_snapshot();
}

void Tab::look_at_snapshot() {
  units_.follow_counting(catalog_, *now_);
  followed_.refresh(*now_, [this](const IntentOutcome& outcome) { complain(outcome); });
  pad_looked_at_ = false;
  report_watched();
  bar_.refresh(*now_);
  unset_read = unset_read || now_->any_axis_moving();
  banner_folded = banner_folded && now_->link.state == LinkState::lost;
  const Desk::Send send_it = [this](IntentBody body) { return send(std::move(body)); };
  desk_.refresh(*now_, *bench_, clock_, send_it);
  desk_.list_run->follow(*now_, send_it, [this](const IntentOutcome& ended) { return words_of(ended); });
  desk_.step_recorder->follow(steps_view(*this));
}

void Tab::take(Notice& notice) {
  if (notice.kind == Notice::Kind::program) return desk_.listed(notice);
  if (notice.past) notice.text = describe_warned(catalog_, *notice.past, place_words());
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
  const bool stops =
      std::holds_alternative<intent::Stop>(body) || std::holds_alternative<intent::Abort>(body);
  std::optional<IntentBody> again;
  if (closing_of(body)) again = body;
  const IntentId id = backend_.send(std::move(body), user_acted_s_ago_);
  if (stops) followed_.stop_was_sent(id);
  if (again) followed_.may_ask(Intent(id, std::move(*again)));
  return id;
}

IntentId Tab::send_followed(IntentBody body) {
  const bool keep_alive = std::holds_alternative<intent::JogKeepAlive>(body);
  const IntentId id = send(std::move(body));
  if (!keep_alive) followed_.add(id);
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
  followed_.add(stop);
  followed_.stop_was_sent(stop);
}

void Tab::take(const Ending& ending) {
  const auto position = [this](AxisId axis, Steps place) {
    return std::string(format_with_unit(place, unit(axis)).view());
  };
  desk_.events.add(ending, catalog_, position);
  desk_.stop_times.add(ending, position);
}

/// Records a user action where it stays, even when a flood of traffic has pushed it out of the terminal.
void Tab::note(std::string words) {
  desk_.events.add({Happening::Mark::message, false, clock_, {}, std::move(words), -1});
}

std::vector<Notice> Tab::take_notices() { return std::exchange(notices_, {}); }

void Tab::complain(const IntentOutcome& outcome) {
  if (outcome.id == jog.jog_intent()) jog.forget();  // there is no jog to stop
  std::string words = words_of(outcome);
  desk_.events.add({Happening::Mark::message, true, clock_, {}, words, -1});
  if (pad_looked_at_ && outcome.past && outcome.id == jog.tap_intent())
    tap_past_limit = {*outcome.past, std::move(words)};
  else
    complaints_.push_back(std::move(words));
}

std::string Tab::words_of(const IntentOutcome& outcome) const {
  return outcome.past ? describe_past(catalog_, *outcome.past, place_words())
                      : std::string(outcome.sentence.view());
}

PlaceWords Tab::place_words() const {
  return [this](AxisId axis, Steps place) { return std::string(format_with_unit(place, unit(axis)).view()); };
}

// Sends the groups drawn since the last call. After an absence the controller has forgotten nothing, but its
// driver may have.
void Tab::report_watched() {
  const std::uint32_t groups = std::exchange(looked_at_, 0);
  const bool there = now_->link.state == LinkState::good || now_->link.state == LinkState::late;
  if (!there) {
    sent_.watched = 0;
    return;
  }
  if (groups == sent_.watched) return;
  sent_.watched = groups;
  send(intent::Watch(groups));
}

std::string_view Tab::name() const {
  if (bus) return bus->name();
  if (!profile.name.empty()) return profile.name;
  return default_name.empty() ? std::string_view(catalog_.short_name) : std::string_view(default_name);
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
  units_.work_out(catalog_, profile);
  units_.follow_counting(catalog_, *now_);
  report_travel();
}

void Tab::report_travel() {
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Travel& travel = profile.axes[i].travel; travel != std::exchange(sent_.travel[i], travel))
      send_followed(intent::SetTravel(AxisId{static_cast<std::uint8_t>(i)}, travel));
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Backlash& backlash = profile.axes[i].backlash;
        backlash != std::exchange(sent_.backlash[i], backlash))
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

void Tab::choose_jog_speed(Pps of_all) {
  const auto share = [](Tab& tab) {
    for (AxisProfile& axis : tab.profile.axes)
      if (std::exchange(axis.jog_speed, Pps()).value > 0) tab.profile_changed = true;
  };
  if (bus)
    for (Tab* member : bus->members) share(*member);
  else
    share(*this);
  choose_jog(profile.jog_step, of_all);
}

void Tab::choose_jog_speed(AxisId axis, Pps speed) {
  if (std::exchange(profile.axes[axis.index].jog_speed, speed) != speed) profile_edited();
}

Pps Tab::jog_speed(AxisId axis) const {
  const Pps own = profile.axes[axis.index].jog_speed;
  return own.value > 0 ? own : profile.jog_speed;
}

}  // namespace hw::gui
