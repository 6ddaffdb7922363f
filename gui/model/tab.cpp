#include "gui/model/tab.h"

#include <utility>
#include <variant>

#include <fmt/core.h>

#include "core/session/session.h"
#include "gui/model/list_run.h"
#include "gui/model/run_places.h"
#include "gui/model/sample_feed.h"
#include "gui/model/step_recorder.h"

namespace hw::gui {

static const Snapshot nothing_known;
static const BenchView no_bench;

static Tab::Backend backend_of(Session& session) {
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

Tab::Tab(std::shared_ptr<Session> session, std::string profile_key, bool on_bus)
    : session_(std::move(session)),
      address_(session_->address()),
      catalog_(catalog_on(session_->catalog(), on_bus)),
      id_(catalog_.id()),
      backend_(backend_of(*session_)),
      desk_(catalog_, session_->type().language ? &session_->type().language() : nullptr,
            session_->type().explain),
      settings(catalog_, std::move(profile_key), followed_sender()),
      jog(followed_sender()),
      messages(catalog_, settings, jog, desk_.records.events),
      bar_(catalog_),
      latest_{&nothing_known, &no_bench} {
  refresh();
}

Tab::Tab(Address address, Catalog catalog, Backend backend, const Language* language,
         TrafficLog::Explain explain)
    : address_(std::move(address)),
      catalog_(std::move(catalog)),
      id_(catalog_.id()),
      backend_(std::move(backend)),
      desk_(catalog_, language, explain),
      settings(catalog_, {}, followed_sender()),
      jog(followed_sender()),
      messages(catalog_, settings, jog, desk_.records.events),
      bar_(catalog_),
      latest_{&nothing_known, &no_bench} {}

std::function<IntentId(IntentBody)> Tab::followed_sender() {
  return [this](IntentBody body) { return send_followed(std::move(body)); };
}

void Tab::refresh() {
  if (!session_) return;
  latest_ = {&session_->snapshot(), &session_->bench_view(), session_->now()};
  session_->notices().drain([this](Notice& notice) { take(notice); });
  session_->endings().drain(
      [this](const Ending& ending) { desk_.records.add(ending, catalog_, settings.place_words()); });
  desk_.records.traffic.drain(session_->traffic());
  session_->samples().drain([this](const AxisSample& sample) { desk_.step_recorder->take(sample); });
  follow_snapshot();
}

void Tab::show(const Snapshot& snapshot, const BenchView& bench, Instant clock) {
  latest_ = {&snapshot, &bench, clock};
  follow_snapshot();
}

void Tab::follow_snapshot() {
  const Desk::Send send_it = [this](IntentBody body) { return send(std::move(body)); };
  settings.follow(now());
  messages.follow(now(), clock());
  watched.report(now(), send_it);
  bar_.refresh(now());
  view.follow(now());
  desk_.refresh(now(), bench(), clock(), send_it);
  desk_.list_run->follow(now(), send_it,
                         [this](const IntentOutcome& ended) { return messages.words_of(ended); });
  desk_.step_recorder->follow(steps_view(*this));
}

void Tab::take(Notice& notice) {
  if (notice.kind == Notice::Kind::program)
    return desk_.programs.texts.listed(notice.slot, notice.text, notice.at, notice.whole);
  messages.add(std::move(notice));
}

IntentId Tab::send(IntentBody body) {
  desk_.sent(body);
  if (auto* run = std::get_if<intent::RunProgram>(&body); run && run->places.empty()) {
    const bool first = catalog_.program.threads == 0 || run->slot == 0;  // threads share one text
    if (first) run->places = places_of_held(desk_, run->slot, catalog_, now());
  }
  if (const auto* text = std::get_if<intent::SendText>(&body))
    desk_.records.note(fmt::format("{} was sent{}", text->text, text->broadcast ? " to all devices" : ""),
                       clock());
  const bool stops =
      std::holds_alternative<intent::Stop>(body) || std::holds_alternative<intent::Abort>(body);
  std::optional<IntentBody> again;
  if (closing_of(body)) again = body;
  const IntentId id = backend_.send(std::move(body), user_acted_s_ago_);
  if (stops) messages.followed.stop_was_sent(id);
  if (again) messages.followed.may_ask(Intent(id, std::move(*again)));
  return id;
}

IntentId Tab::send_followed(IntentBody body) {
  const bool keep_alive = std::holds_alternative<intent::JogKeepAlive>(body);
  const IntentId id = send(std::move(body));
  if (!keep_alive) messages.followed.add(id);
  return id;
}

void Tab::stop_all(StoppedBy by) {
  jog.forget();
  desk_.records.note(
      by == StoppedBy::key ? "Stop was requested with Esc" : "Stop was requested with its button", clock());
  send_followed(intent::Stop(-1, by));
}

void Tab::stopped_with(IntentId stop) {
  jog.forget();
  desk_.records.note("Stop of all devices was requested", clock());
  desk_.stopped();
  messages.followed.add(stop);
  messages.followed.stop_was_sent(stop);
}

std::string_view Tab::name() const { return bus ? bus->name() : settings.name(); }

}  // namespace hw::gui
