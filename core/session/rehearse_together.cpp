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

class Stage {
 public:
  Stage(const sequence::Sequence& sequence, const Address& bus, const std::vector<ControllerState>& states,
        const WireOpener& opener)
      : sequence_(sequence), bus_(emulated_like(bus)), states_(states), opener_(opener) {}

  Result<RehearsedTogether> run(Duration at_most);

 private:
  Task<> perform(Duration at_most);
  Task<Result<Wire>> open_wire(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again);
  Task<Result<>> draw(Duration at_most);
  void look();
  [[nodiscard]] Fault why_not();

  const sequence::Sequence& sequence_;
  const Address bus_;
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
  auto opened = SessionGroup::open(time_, bus_, std::move(like_them), [] {});
  if (!opened) co_return fail(opened.error());
  group_ = std::move(*opened);
  auto connected = co_await group_->wait_until_connected();
  if (!connected) co_return connected;
  co_await time_.sleep_for(everything_is_read);
  auto begun = co_await group_->run_together(sequence_, 0);
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
  const bool more = seen_.piece_seconds.size() < ix(done);
  for (; seen_.piece_seconds.size() < ix(done); piece_began_ = time_.now())
    seen_.piece_seconds.push_back(seconds(time_.now() - piece_began_));
  if (runs || more) seen_.duration_s = seconds(time_.now() - *began_);
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

Result<RehearsedTogether> Stage::run(Duration at_most) {
  constexpr Duration longest_opening_and_close = std::chrono::minutes(2);
  asio::co_spawn(time_.executor(), perform(at_most), asio::detached);
  time_.run_until(time_.now() + at_most + longest_opening_and_close, [this] {
    if (!drawn_) look();
    return closed_;
  });
  if (!drawn_) return fail(FaultKind::no_answer, "It could not be rehearsed: its emulators do not answer.");
  if (!*drawn_) return fail(why_not());
  return std::move(seen_);
}

}  // namespace

Result<RehearsedTogether> rehearse_together(const sequence::Sequence& sequence, const Address& bus,
                                            const std::vector<ControllerState>& states,
                                            const WireOpener& opener, Duration at_most) {
  return Stage(sequence, bus, states, opener).run(at_most);
}

}  // namespace hw
