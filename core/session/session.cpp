#include "core/session/session.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

#include "core/session/snapshot_look.h"

namespace hw {

Result<std::shared_ptr<Session>> Session::open(Scheduler& scheduler, const Address& address,
                                               WireOpener opener, std::function<void()> wake) {
  if (address.ids().size() > 1)
    return fail(FaultKind::text, fmt::format("{} names several controllers.", address.text()),
                "Nothing was opened.",
                fmt::format("Name one of them, for example id={}.", address.ids().front()));
  auto wire = std::make_shared<SharedWire>(scheduler, address, std::move(opener));
  return open_on(scheduler, address, std::move(wire), 0, std::move(wake));
}

Result<std::shared_ptr<Session>> Session::open_on(Scheduler& scheduler, const Address& address,
                                                  std::shared_ptr<SharedWire> wire, std::size_t place,
                                                  std::function<void()> wake) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) return fail(unknown_model(address.model));
  return open_as(*type, scheduler, address, std::move(wire), place, std::move(wake));
}

Result<std::shared_ptr<Session>> Session::open_as(const DeviceType& type, Scheduler& scheduler,
                                                  const Address& address, std::shared_ptr<SharedWire> wire,
                                                  std::size_t place, std::function<void()> wake) {
  auto catalog = type.make_catalog(address.options);
  if (!catalog) return fail(catalog.error());
  std::shared_ptr<Session> session(
      new Session(scheduler, address, type, std::move(*catalog), std::move(wire), place, std::move(wake)));
  session->pump_.start();
  return session;
}

Session::Session(Scheduler& scheduler, Address address, const DeviceType& type, Catalog catalog,
                 std::shared_ptr<SharedWire> wire, std::size_t place, std::function<void()> wake)
    : scheduler_(scheduler),
      address_(std::move(address)),
      type_(type),
      catalog_(std::move(catalog)),
      wire_(std::move(wire)),
      place_(place),
      reader_(std::move(wake)),
      pump_(scheduler, type, catalog_,
            Pump::Callbacks{[this] { return open_wire(); }, [this](const Snapshot& s) { show(s); },
                            [this](Notice n) { report(std::move(n)); }, &reader_.traffic,
                            [this](const AxisSample& sample) { reader_.samples.push(sample); }, wire_->line(),
                            [this] {
                              if (reader_.wake) reader_.wake();
                            },
                            [this](const Ending& ending) {
                              reader_.endings.push(ending);
                              if (reader_.wake) reader_.wake();
                            }}) {}

Session::~Session() {
  if (bench_) bench_->changed = nullptr;
}

IntentId Session::send(IntentBody body, std::optional<Instant> asked_at) {
  const IntentId id = ++last_intent_;
  asio::post(
      scheduler_.executor(),
      [self = shared_from_this(), intent = Intent(id, std::move(body), asked_at.value_or(now()))]() mutable {
        self->posted_ = intent.id;
        self->take(std::move(intent));
      });
  return id;
}

void Session::operate_bench(BenchCommand command) {
  asio::post(scheduler_.executor(), [self = shared_from_this(), command = std::move(command)] {
    if (!self->bench_) return;
    const auto done = self->bench_->operate(command);
    if (!done) self->report(Notice(Notice::Kind::error, self->now(), done.error().sentence()));
    self->show_bench();
  });
}

Task<Result<std::shared_ptr<Link>>> Session::open_wire() {
  auto link = co_await wire_->link();
  why_no_wire_ = link ? FaultKind::lost : link.error().kind;
  if (auto bench = wire_->bench(place_); link && bench) {
    bench_ = std::move(bench);
    bench_->changed = [this] { show_bench(); };
    show_bench();
  }
  co_return link;
}

IntentId Session::send_text(std::string text, bool to_all) {
  const IntentId id = send(intent::SendText(std::move(text), to_all));
  scripts_texts_.sent.push_back(id);
  return id;
}

void Session::follow_texts(const Snapshot& snapshot) {
  std::erase_if(scripts_texts_.sent, [&](IntentId id) {
    const IntentOutcome* reported = snapshot.outcome_of(id);
    const bool posted = id <= posted_;
    if (!posted || (reported && reported->state == IntentState::pending)) return false;
    if (reported && reported->state != IntentState::done && scripts_texts_.refused.empty())
      scripts_texts_.refused = reported->sentence.view();
    return true;
  });
}

IntentId Session::post(IntentBody body) {
  const IntentId id = ++last_intent_;
  take(Intent(id, std::move(body)));
  return id;
}

void Session::take(Intent intent) {
  begun_here_.posted(intent.body);
  pump_.post(std::move(intent));
}

Task<Result<>> Session::perform(IntentBody body) {
  const IntentId id = post(std::move(body));
  co_return co_await outcome(id);
}

Task<Result<>> Session::outcome(IntentId id) {
  const auto self = shared_from_this();
  for (;;) {
    const IntentOutcome* reported = known().outcome_of(id);
    if (!reported)
      co_return fail(FaultKind::internal, "Too many commands at once: the outcome of this one is not known.");
    if (reported->state == IntentState::done) co_return Result<>();
    if (reported->state == IntentState::refused || reported->state == IntentState::failed)
      co_return fail(reported->fault());
    co_await pump_.published().wait();
  }
}

Task<Result<>> Session::wait_until_connected() {
  const auto self = shared_from_this();
  for (;;) {
    const LinkHealth& link = known().link;
    if (link.state == LinkState::good || link.state == LinkState::late) co_return Result<>();
    if (link.state != LinkState::connecting) co_return fail(why_no_wire_, std::string(link.sentence.view()));
    co_await pump_.published().wait();
  }
}

Task<Result<std::string>> Session::listing(int slot) {
  const auto self = shared_from_this();
  const auto uploaded = co_await perform(intent::UploadProgram(slot));
  if (!uploaded) co_return fail(uploaded.error());
  co_return listings_[slot];
}

static std::string why_all_ended(const Snapshot& s) {
  if (s.link.state == LinkState::lost || s.link.state == LinkState::closed)
    return fmt::format("The link is lost. {}", s.link.sentence.view());
  if (s.program.run == RunState::error)
    return s.notice.empty() ? "A program stopped with an error." : std::string(s.notice.view());
  const bool axis_reports = std::any_of(s.axes.begin(), s.axes.begin() + s.axis_count,
                                        [](const AxisState& a) { return a.ended_by == EndedBy::limit; });
  if (s.program.ended_by == EndedBy::limit && !axis_reports)
    return "A limit switch was hit while the program ran.";
  if (s.program.ended_by == EndedBy::elsewhere)
    return "The program was ended by the controller's Stop button or input.";
  return {};
}

// An end requested by the console itself (stop, abort) is not a reason.
static std::string why_axis_ended(const AxisState& axis, const std::string& name, const Catalog& catalog) {
  const auto because = [&](const char* what) { return fmt::format("Axis {} {}.", name, what); };
  switch (axis.ended_by) {
    case EndedBy::limit: return because("was ended by its limit switch");
    case EndedBy::elsewhere:
      if (axis.slipped)
        return because(
            "was stopped, because it has slipped: its encoder and its position differ by more than is "
            "allowed");
      return because("was stopped by the controller's Stop button or input, or by another program");
    case EndedBy::error: return because("was ended by an error of the controller");
    case EndedBy::lost: return because("was moving when the console lost track of it");
    case EndedBy::not_in_place:
      return fmt::format("Axis {} did not reach its target: its encoder stands at {}, {} {} from there.",
                         name, axis.position.value, std::abs(axis.following_error().value),
                         catalog.step_word);
    case EndedBy::nothing:
    case EndedBy::target:
    case EndedBy::stop:
    case EndedBy::abort: break;
  }
  return {};
}

int axis_not_finished(const Snapshot& s, const Catalog& catalog) {
  if (!why_all_ended(s).empty()) return -1;
  for (int i = 0; i < s.axis_count; ++i)
    if (!why_axis_ended(s.axes[i], catalog.axes[i].name, catalog).empty()) return i;
  return -1;
}

std::string why_not_finished(const Snapshot& s, const Catalog& catalog) {
  if (std::string why = why_all_ended(s); !why.empty()) return why;
  if (const int i = axis_not_finished(s, catalog); i >= 0)
    return why_axis_ended(s.axes[i], catalog.axes[i].name, catalog);
  if (s.program.ended_by == EndedBy::lost)
    return "The program was running when the console lost track of it.";
  return {};
}

Task<Result<>> Session::wait_until_idle(Duration patience) {
  const auto self = shared_from_this();
  const Instant deadline = scheduler_.now() + patience;
  co_await asio::post(scheduler_.executor(), use_task);  // after all intents that send() has posted
  std::optional<std::uint64_t> round;                    // status round begun with nothing queued
  bool in_time = true, at_work = false, cut_off = false, in_pieces = false;
  std::uint32_t restarts = known().restarts;
  while (in_time) {
    const Snapshot& s = known();
    const bool gone = s.link.state == LinkState::lost || s.link.state == LinkState::closed;
    if (pump_.busy())
      round.reset();
    else if (!round)
      round = pump_.want_round();
    const bool fresh = round && pump_.has_seen(*round);
    const bool running =
        (s.program.run != RunState::idle && s.program.run != RunState::error) || s.pieces.running;
    in_pieces = in_pieces || s.pieces.running;
    cut_off = cut_off || (std::exchange(restarts, s.restarts) != s.restarts && at_work);
    at_work = at_work || running || s.any_axis_moving() || pump_.busy();  // since the wait began
    if (gone || s.program.run == RunState::error ||
        (fresh && !running && !s.working && !s.any_axis_moving())) {
      std::string reason = why_not_finished(s, catalog_);
      if (reason.empty()) reason = std::exchange(scripts_texts_.refused, {});
      if (reason.empty() && in_pieces && s.pieces.done < s.pieces.total)
        reason = fmt::format("The run ended in piece {} of {}. {}", s.pieces.done + 1, s.pieces.total,
                             s.pieces.ended_because.view());
      if (reason.empty() && cut_off)
        reason =
            "The controller was switched off and on, or reset, while a motion, a program or a command was "
            "under way.";
      if (reason.empty()) co_return Result<>();
      co_return fail(gone ? FaultKind::lost : FaultKind::controller, std::move(reason));
    }
    in_time = co_await pump_.published().wait_until(deadline);
  }
  co_return fail(FaultKind::no_answer,
                 fmt::format("Timeout: still not idle after {:.1f} s.", seconds(patience)));
}

Task<> Session::close() {
  const auto self = shared_from_this();
  co_await pump_.shut_down();
  if (bench_) bench_->changed = nullptr;
}

void Session::show(const Snapshot& snapshot) {
  if (!scripts_texts_.sent.empty()) follow_texts(snapshot);
  if (begun_here_.any()) begun_here_.seen(snapshot, pump_.busy(), pump_.rounds_ended());
  state_log_.look(snapshot);
  const bool news = !looks_same(snapshot, shown_);
  reader_.snapshot.publish(snapshot);
  if (!news) return;
  shown_ = snapshot;
  if (reader_.wake) reader_.wake();
}

void Session::show_bench() {
  if (!bench_) return;
  BenchView view;
  view.present = true;
  bench_->look(view);
  if (view.stores >= 0) pump_.know_store_count(static_cast<std::int32_t>(view.stores));
  if (view == bench_view_) return;
  bench_view_ = view;
  reader_.bench.publish(view);
  if (reader_.wake) reader_.wake();
}

void Session::report(Notice notice) {
  if (notice.kind == Notice::Kind::program)
    listings_[notice.slot] = notice.text;
  else
    driver_log(catalog_).debug("{}: told: {}", LogName{catalog_}, notice.text);
  reader_.notices.push(std::move(notice));
  if (reader_.wake) reader_.wake();
}

}  // namespace hw
