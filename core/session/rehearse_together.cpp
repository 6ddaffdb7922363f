#include "core/session/rehearse_together.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/index.h"
#include "core/device/registry.h"
#include "core/session/session_group.h"
#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

/// Beside the wire a real controller has the pace of its line; an emulator has the one of its address.
Address emulated_like(const Address& bus) {
  Address emulated = bus;
  emulated.transport = "emulator";
  emulated.where.clear();
  if (!bus.emulated()) emulated.options["wire"] = "real";
  for (const char* key : {"state", "speed", "bench"}) emulated.options.erase(key);
  return emulated;
}

constexpr Duration everything_is_read = std::chrono::seconds(5);  // its wire has little else to carry then

/// What those on the wire are asked to do; done when they have begun, or one has refused.
using Begin = std::function<Task<Result<>>(SessionGroup&)>;

class Stage {
 public:
  Stage(Begin begin, const Address& like, const std::vector<ControllerState>& states,
        const WireOpener& opener)
      : begin_(std::move(begin)), address_(emulated_like(like)), states_(states), opener_(opener) {}

  /// Nothing: it came to its end.
  Result<> run(Duration at_most);
  [[nodiscard]] RehearsedTogether& together() { return seen_; }
  [[nodiscard]] RehearsedPieces& pieces() { return alone_; }

 private:
  Task<> perform(Duration at_most);
  Task<Result<Wire>> open_wire(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again);
  Task<Result<>> draw(Duration at_most);
  void look();
  void look_at_steps(const PiecesState& pieces);
  void hear_what_is_told();
  [[nodiscard]] Fault why_not();

  const Begin begin_;
  const Address address_;
  const std::vector<ControllerState>& states_;
  const WireOpener& opener_;
  IoContext io_;
  VirtualScheduler time_{io_};
  std::shared_ptr<SessionGroup> group_;
  std::optional<Instant> began_;  ///< to draw
  Instant piece_began_{};
  std::optional<Result<>> drawn_;
  bool closed_ = false;
  RehearsedTogether seen_;
  RehearsedPieces alone_;
};

Task<> Stage::perform(Duration at_most) {
  auto drawn = co_await draw(at_most);
  look();
  drawn_ = std::move(drawn);
  if (group_) co_await group_->close();
  closed_ = true;
}

Task<Result<Wire>> Stage::open_wire(Scheduler& scheduler, Address address,
                                    std::shared_ptr<BenchAccess> again) {
  const std::vector<Address> devices = address.devices();
  auto wire = co_await opener_(scheduler, std::move(address), std::move(again));
  if (!wire) co_return wire;
  for (std::size_t i = 0; i < std::min({states_.size(), devices.size(), wire->benches.size()}); ++i) {
    const auto catalog = find_device_type(devices[i].model)->make_catalog(devices[i].options);
    if (catalog) wire->benches[i]->begin_like(states_[i], *catalog);
  }
  co_return wire;
}

Task<Result<>> Stage::draw(Duration at_most) {
  WireOpener like_them = [this](Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
    return open_wire(scheduler, std::move(address), std::move(again));
  };
  auto opened = SessionGroup::open(time_, address_, std::move(like_them), [] {});
  if (!opened) co_return fail(opened.error());
  group_ = std::move(*opened);
  auto connected = co_await group_->wait_until_connected();
  if (!connected) co_return connected;
  co_await time_.sleep_for(everything_is_read);
  auto begun = co_await begin_(*group_);
  if (!begun) co_return begun;
  began_ = piece_began_ = time_.now();
  co_return co_await group_->wait_until_idle(at_most);
}

/// A piece has ended when all who take part have done it.
void Stage::look() {
  if (!began_) return;
  bool runs = false;
  std::int32_t done = std::numeric_limits<std::int32_t>::max();
  for (const auto& member : group_->members()) {
    const PiecesState& pieces = member->known().pieces;
    runs = runs || pieces.running;
    if (pieces.total > 0) done = std::min(done, pieces.done);
  }
  look_at_steps(group_->members().front()->known().pieces);
  const bool more = seen_.piece_seconds.size() < ix(done);
  for (; seen_.piece_seconds.size() < ix(done); piece_began_ = time_.now())
    seen_.piece_seconds.push_back(seconds(time_.now() - piece_began_));
  if (runs || more) seen_.duration_s = seconds(time_.now() - *began_);
}

void Stage::look_at_steps(const PiecesState& pieces) {
  const int came_to = alone_.came_to.empty() ? -1 : alone_.came_to.back().step;
  if (pieces.total > 0 && pieces.step > came_to)
    alone_.came_to.push_back({pieces.step, seconds(time_.now() - *began_)});
}

void Stage::hear_what_is_told() {
  if (!group_) return;
  group_->members().front()->notices().drain([this](const Notice& notice) {
    if (notice.kind != Notice::Kind::info) return;
    alone_.told += (alone_.told.empty() ? "" : " ") + notice.text;
  });
}

/// What they have said of it, if they have.
Fault Stage::why_not() {
  Fault why = drawn_->error();
  if (!group_) return why;
  bool said = false;
  for (const auto& member : group_->members())
    member->notices().drain([&](const Notice& notice) {
      if (said || notice.kind != Notice::Kind::error) return;
      said = true;
      why.what = notice.text;
    });
  return why;
}

Result<> Stage::run(Duration at_most) {
  constexpr Duration longest_opening_and_close = std::chrono::minutes(2);
  asio::co_spawn(time_.executor(), perform(at_most), asio::detached);
  time_.run_until(time_.now() + at_most + longest_opening_and_close, [this] {
    if (!drawn_) look();
    return closed_;
  });
  if (!drawn_) return fail(FaultKind::no_answer, "It could not be rehearsed: its emulators do not answer.");
  if (!*drawn_) return fail(why_not());
  hear_what_is_told();
  return {};
}

/// Whatever the user will have switched on and off by then.
Task<Result<>> begin_alone(Session& session, std::shared_ptr<const Pieces> pieces) {
  for (const OpenLoop& loop : pieces->open_loops)
    if (auto opened = co_await session.perform(intent::SetParam(loop.parameter, 0)); !opened)
      co_return opened;
  for (int axis = 0; axis < session.known().axis_count; ++axis)
    if (session.catalog().axes[ix(axis)].switchable && !session.known().axes[ix(axis)].enabled)
      (void)co_await session.perform(intent::SetPower(axis, true));  // else the run says what is wrong
  co_return co_await session.perform(intent::RunInPieces(std::move(pieces)));
}

}  // namespace

double RehearsedPieces::when(int step) const {
  Arrival before, after;
  for (const Arrival& arrival : came_to) {
    before = std::exchange(after, arrival);
    if (arrival.step >= step) break;
  }
  if (step >= after.step) return after.t;
  return before.t + (after.t - before.t) * (step - before.step) / (after.step - before.step);
}

Result<RehearsedTogether> rehearse_together(const sequence::Sequence& sequence, const Address& bus,
                                            const std::vector<ControllerState>& states,
                                            const WireOpener& opener, Duration at_most) {
  Stage stage([&](SessionGroup& group) { return group.run_together(sequence, 0); }, bus, states, opener);
  if (auto done = stage.run(at_most); !done) return fail(done.error());
  return std::move(stage.together());
}

Result<RehearsedPieces> rehearse_pieces(std::shared_ptr<const Pieces> pieces, const Address& controller,
                                        const ControllerState& state, const WireOpener& opener,
                                        Duration at_most) {
  const std::vector<ControllerState> states(1, state);
  Stage stage([&](SessionGroup& group) { return begin_alone(*group.members().front(), pieces); }, controller,
              states, opener);
  const auto done = stage.run(at_most);
  RehearsedPieces& seen = stage.pieces();
  const bool was_at_it = !done && done.error().kind == FaultKind::no_answer && !seen.came_to.empty();
  if (!done && !was_at_it) return fail(done.error());
  seen.finished = done.has_value(), seen.duration_s = stage.together().duration_s;
  return std::move(seen);
}

}  // namespace hw
