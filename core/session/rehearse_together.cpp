#include "core/session/rehearse_together.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/index.h"
#include "core/device/registry.h"
#include "core/session/session_group.h"
#include "core/session/track_together.h"
#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

/// Real controllers are rehearsed at the pace of their wire, emulators at that of their address.
Address emulated_like(const Address& bus) {
  Address emulated = bus;
  emulated.transport = "emulator";
  emulated.where.clear();
  if (!bus.emulated()) emulated.options["wire"] = "real";
  for (const char* key : {"state", "speed", "bench"}) emulated.options.erase(key);
  return emulated;
}

constexpr Duration everything_is_read = std::chrono::seconds(5);  // the wire is nearly idle afterwards

/// Starts the work on the wire's controllers; ends when all have begun or one has refused.
using Begin = std::function<Task<Result<>>(SessionGroup&)>;

class Stage {
 public:
  Stage(Begin begin, const Address& like, const std::vector<ControllerState>& states,
        const WireOpener& opener)
      : begin_(std::move(begin)), address_(emulated_like(like)), states_(states), opener_(opener) {}

  /// For a common sequence: records the track. `id_with_tool`: the controller with the tool.
  void keep_track(std::string_view id_with_tool) { id_with_tool_ = id_with_tool; }
  /// No fault: finished, or still running at the end of the time; see finished().
  Result<> run(Duration at_most);
  [[nodiscard]] bool finished() const { return drawn_ && drawn_->has_value(); }
  [[nodiscard]] RehearsedTogether& together() { return seen_; }
  [[nodiscard]] RehearsedPieces& pieces() { return alone_; }

 private:
  Task<> perform(Duration at_most);
  Task<Result<Wire>> open_wire(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again);
  Task<Result<>> draw(Duration at_most);
  void look();
  void look_at_steps();
  void begin_track();
  void end_track();
  void read_events();
  [[nodiscard]] Fault why_not();

  const Begin begin_;
  const Address address_;
  const std::vector<ControllerState>& states_;
  const WireOpener& opener_;
  IoContext io_;
  VirtualScheduler time_{io_};
  std::shared_ptr<SessionGroup> group_;
  std::optional<std::string_view> id_with_tool_;  ///< none: no track is kept
  std::optional<TrackTogether> track_;
  Instant ready_at_{};            ///< when all are connected and their state is known
  std::optional<Instant> began_;  ///< start of the work
  Instant piece_began_{};
  std::optional<Result<>> drawn_;
  bool closed_ = false;
  RehearsedTogether seen_;
  RehearsedPieces alone_;
};

Task<> Stage::perform(Duration at_most) {
  auto drawn = co_await draw(at_most);
  look();
  end_track();
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
  ready_at_ = time_.now();
  auto begun = co_await begin_(*group_);
  if (!begun) co_return begun;
  began_ = piece_began_ = time_.now();  // and nothing moves yet
  begin_track();
  co_return co_await group_->wait_until_idle(at_most);
}

void Stage::begin_track() {
  if (!id_with_tool_) return;
  TrackTogether::Benches benches;
  for (const auto& member : group_->members()) benches.push_back(member->bench());
  track_.emplace(time_, std::move(benches), ix(std::max(group_->find(*id_with_tool_), 0)));
}

void Stage::end_track() {
  if (!track_) return;
  track_->look();
  seen_.track = track_->take();
  track_.reset();
  for (std::size_t a = 0; a < std::min(group_->members().size(), ix(max_axes)); ++a) {
    RehearsedAxis& axis = seen_.axes.emplace_back();
    axis.name = group_->members()[a]->catalog().id();
    axis.begin = seen_.track.front().position[a], axis.position = seen_.track.back().position[a];
  }
  for (const RehearsedPieces::Arrival& came : alone_.came_to)
    seen_.events.push_back({came.t, {}, 0, came.step});
}

/// A piece has ended when all that take part have finished it.
void Stage::look() {
  if (track_) track_->look();
  if (!began_) return;
  bool runs = false;
  std::int32_t done = std::numeric_limits<std::int32_t>::max();
  for (const auto& member : group_->members()) {
    const PiecesState& pieces = member->known().pieces;
    runs = runs || pieces.running;
    if (pieces.total > 0) done = std::min(done, pieces.done);
  }
  look_at_steps();
  const bool more = seen_.piece_seconds.size() < ix(done);
  for (; seen_.piece_seconds.size() < ix(done); piece_began_ = time_.now())
    seen_.piece_seconds.push_back(seconds(time_.now() - piece_began_));
  if (runs || more) seen_.duration_s = seconds(time_.now() - *began_);
}

/// The step of the controller that has come furthest. A status round reports a step after its motion has
/// begun. If it reports several at once, the motion is that of the first.
void Stage::look_at_steps() {
  RehearsedPieces::Arrival last;
  if (alone_.came_to.empty())
    last.step = -1;
  else
    last = alone_.came_to.back();
  int step = last.step;
  for (const auto& member : group_->members())
    if (member->known().pieces.total > 0) step = std::max(step, member->known().pieces.step);
  if (step == last.step) return;
  const double moves_since = track_ ? track_->moves_since() : 0, now = seconds(time_.now() - *began_);
  const bool began_before = moves_since > last.t;
  if (began_before && step > last.step + 1) alone_.came_to.push_back({last.step + 1, moves_since});
  const bool of_this = began_before && step == last.step + 1;
  alone_.came_to.push_back({step, of_this ? moves_since : now});
}

void Stage::read_events() {
  if (!group_) return;
  group_->members().front()->notices().drain([this](const Notice& notice) {
    const bool of_opening = notice.at < ready_at_;  // of an emulator that the user has not opened
    if (notice.kind != Notice::Kind::info || of_opening) return;
    alone_.messages += (alone_.messages.empty() ? "" : " ") + notice.text;
  });
}

/// The controllers' own error message, if there is one.
Fault Stage::why_not() {
  Fault why = drawn_->error();
  if (!group_) return why;
  bool reported = false;
  for (const auto& member : group_->members())
    member->notices().drain([&](const Notice& notice) {
      if (reported || notice.kind != Notice::Kind::error) return;
      reported = true;
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
  const bool at_it_still =
      !*drawn_ && drawn_->error().kind == FaultKind::no_answer && !alone_.came_to.empty();
  if (!*drawn_ && !at_it_still) return fail(why_not());
  read_events();
  return {};
}

/// Prepares the controller as the user will have done before the run.
Task<Result<>> begin_alone(Session& session, std::shared_ptr<const Pieces> pieces) {
  for (const OpenLoop& loop : pieces->open_loops)
    if (auto opened = co_await session.perform(intent::SetParam(loop.parameter, 0)); !opened)
      co_return opened;
  for (int axis = 0; axis < session.known().axis_count; ++axis)
    if (session.catalog().axes[ix(axis)].switchable && !session.known().axes[ix(axis)].enabled)
      (void)co_await session.perform(intent::SetPower(axis, true));  // on failure the run gives the reason
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
  stage.keep_track(sequence.axes.empty() ? std::string_view() : sequence.axes.front().name);
  if (auto done = stage.run(at_most); !done) return fail(done.error());
  stage.together().finished = stage.finished();
  return std::move(stage.together());
}

Result<RehearsedPieces> rehearse_pieces(std::shared_ptr<const Pieces> pieces, const Address& controller,
                                        const ControllerState& state, const WireOpener& opener,
                                        Duration at_most) {
  const std::vector<ControllerState> states(1, state);
  Stage stage([&](SessionGroup& group) { return begin_alone(*group.members().front(), pieces); }, controller,
              states, opener);
  if (auto done = stage.run(at_most); !done) return fail(done.error());
  RehearsedPieces& seen = stage.pieces();
  seen.finished = stage.finished(), seen.duration_s = stage.together().duration_s;
  return std::move(seen);
}

}  // namespace hw
