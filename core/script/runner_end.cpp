// The end of a run, and stopping and closing the controllers it leaves.
#include <algorithm>

#include <fmt/core.h>

#include "core/script/module.h"
#include "core/script/runner.h"

namespace hw::script {

constexpr Duration for_the_end = std::chrono::seconds(10);

struct Runner::Left {
  std::shared_ptr<Session> session;
  IntentId stop = 0;    ///< 0: none, or its outcome is known
  std::string trouble;  ///< why it may still be running
  bool closed = false;
};

struct Runner::Leaving {
  std::vector<Left> all;
  bool begun = false;
  // A controller that the user has closed was left on purpose.
  void add(const std::shared_ptr<Session>& session, IntentId stop) {
    if (session->known().link.state == LinkState::closed) return;
    all.push_back(Left{session, stop, {}, false});
  }
  [[nodiscard]] bool has(const Session& session) const {
    return std::any_of(all.begin(), all.end(),
                       [&](const Left& one) { return one.session.get() == &session; });
  }
  // Stops all: an interrupt came while they were being closed.
  void stop() {
    for (Left& one : all)
      if (one.closed)
        one.trouble =
            "The controller was already closed: motions and programs that the script left running continue.";
      else if (!one.session->pump().stops_all())
        one.stop = one.session->post(intent::Stop(-1, StoppedBy::script));
  }
  [[nodiscard]] bool over() const {
    return begun && std::all_of(all.begin(), all.end(), [](const Left& one) { return one.closed; });
  }
};

void Runner::interrupt() {
  interrupt_asked_ = true;                                         // for a computing script ...
  asio::post(scheduler_.executor(), [this] { interrupt_now(); });  // ... and for a waiting one
}

void Runner::give_up(std::string why) {
  asio::post(scheduler_.executor(), [this, why = std::move(why)] { interrupt_now(why); });
}

void Runner::interrupt_now(std::string why) {
  if (!failure_.empty()) return;
  failure_ = std::move(why);
  from_outside_ = ending_ = main_over_ = true;
  if (leaving_) leaving_->stop();
}

// After a failure all motion is stopped. After a regular end it continues on purpose, except jogs, which are
// no longer held.
void Runner::finish() {
  main_over_ = true;
  ended_.notify();
  happened_.notify();
  const auto leaving = std::make_shared<Leaving>();
  asio::post(scheduler_.executor(), [this, leaving] {  // after earlier commands
    leave_all(leaving);
    leaving_ = leaving;
  });
  if (options_.stage) options_.stage->script_over();
  scheduler_.run_until(scheduler_.now() + for_the_end, [&leaving] { return leaving->over(); });
  log_notices();
  if (!failure_.empty()) report_stops(*leaving);
}

// After a failure stop every controller, moving or not: a snapshot may be older than the script's last
// command. Send all stops before waiting for any: a ramp may take longer than the end of the run.
void Runner::leave_all(const std::shared_ptr<Leaving>& leaving) {
  leaving->begun = true;
  for (const auto& group : groups_) {
    const auto ids = failure_.empty() ? std::vector<IntentId>() : group->post_stop(false);
    for (std::size_t i = 0; i < group->members().size(); ++i)
      leaving->add(group->members()[i], ids.empty() ? 0 : ids[i]);
  }
  if (options_.stage)
    for (const auto& session : options_.stage->controllers())
      if (!leaving->has(*session))
        leaving->add(session, failure_.empty() ? 0 : session->post(intent::Stop(-1, StoppedBy::script)));
  for (std::size_t i = 0; i < leaving->all.size(); ++i)
    asio::co_spawn(scheduler_.executor(), leave(leaving, i), asio::detached);
}

Task<> Runner::leave(std::shared_ptr<Leaving> leaving, std::size_t which) {
  Left& one = leaving->all[which];
  co_await see_stopped(one);
  co_await one.session->close();
  co_await see_stopped(one);  // of an interrupt during close()
  one.closed = true;
}

Task<> Runner::see_stopped(Left& one) {
  if (one.stop == 0) co_return;
  const auto stopped = co_await one.session->outcome(one.stop);
  if (!stopped) one.trouble = stopped.error().sentence();
  one.stop = 0;
}

void Runner::report_stops(const Leaving& leaving) {
  std::string troubles;
  for (const Left& one : leaving.all) {
    std::string_view trouble = one.trouble;
    if (one.stop != 0) trouble = "Watch the controller: stop was sent, and it has not come to rest yet.";
    if (!trouble.empty()) troubles += fmt::format("\n{}: {}", one.session->address().text(), trouble);
  }
  if (!troubles.empty())
    failure_ += "\nThese controllers may not have stopped:" + troubles;
  else if (from_outside_ && !leaving.all.empty())
    failure_ += " The controllers were told to stop.";
}

}  // namespace hw::script
