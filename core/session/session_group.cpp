#include "core/session/session_group.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/piece_sync.h"
#include "core/device/pieces_together.h"

namespace hw {

// Checks all devices before any is opened.
static Result<> check(const Address& address) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) return fail(unknown_model(address.model));
  for (const Address& device : address.devices())
    if (const auto catalog = type->make_catalog(device.options); !catalog) return fail(catalog.error());
  return {};
}

Result<std::shared_ptr<SessionGroup>> SessionGroup::open(Scheduler& scheduler, const Address& address,
                                                         WireOpener opener, std::function<void()> wake) {
  if (auto possible = check(address); !possible) return fail(possible.error());
  std::shared_ptr<SessionGroup> group(new SessionGroup(scheduler, address));
  const auto wire = std::make_shared<SharedWire>(scheduler, address, std::move(opener));
  for (const Address& device : address.devices()) {
    auto session = Session::open_on(scheduler, device, wire, group->members_.size(), wake);
    if (!session) return fail(session.error());
    group->members_.push_back(std::move(*session));
  }
  return group;
}

int SessionGroup::find(std::string_view id) const {
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (members_[i]->catalog().id() == id) return static_cast<int>(i);
  return -1;
}

static std::string beginning_with(const Session& member) { return member.catalog().id() + ": "; }

tl::unexpected<Fault> SessionGroup::fault_of(std::size_t member, Fault fault) const {
  if (is_bus()) fault.what = beginning_with(*members_[member]) + fault.what;
  return fail(std::move(fault));
}

std::shared_ptr<Session> SessionGroup::origin_of(const Fault& fault) const {
  if (!is_bus()) return members_.front();
  for (const auto& member : members_)
    if (fault.what.starts_with(beginning_with(*member))) return member;
  return nullptr;
}

static IntentBody stop_intent(bool at_once, StoppedBy by) {
  if (at_once) return intent::Abort(-1, by);
  return intent::Stop(-1, by);
}

void SessionGroup::stop_wire(bool at_once) const {
  if (!is_bus()) return;
  for (const auto& member : members_)
    if (member->pump().stop_wire(at_once)) return;
}

std::vector<IntentId> SessionGroup::stop(bool at_once, StoppedBy by) {
  asio::post(scheduler_.executor(), [self = shared_from_this(), at_once] { self->stop_wire(at_once); });
  std::vector<IntentId> ids;
  for (const auto& member : members_) ids.push_back(member->send(stop_intent(at_once, by)));
  return ids;
}

std::vector<IntentId> SessionGroup::post_stop(bool at_once) {
  stop_wire(at_once);
  std::vector<IntentId> ids;
  for (const auto& member : members_) ids.push_back(member->post(stop_intent(at_once, StoppedBy::script)));
  return ids;
}

Task<Result<>> SessionGroup::outcomes(std::vector<Asked> all) {
  Result<> first;
  for (const Asked& asked : all) {
    auto one = co_await members_[asked.member]->outcome(asked.id);
    if (first && !one) first = fault_of(asked.member, std::move(one.error()));
  }
  co_return first;
}

Task<Result<>> SessionGroup::perform_stop(bool at_once) {
  const auto self = shared_from_this();
  std::vector<Asked> all;
  for (const IntentId id : post_stop(at_once)) all.push_back({all.size(), id});
  co_return co_await outcomes(std::move(all));
}

Task<Result<>> SessionGroup::run_together(sequence::Sequence sequence, int from_step) {
  const auto self = shared_from_this();
  std::vector<const Catalog*> catalogs;
  for (const auto& member : members_) catalogs.push_back(&member->catalog());
  const auto bus = catalog_together(catalogs);
  if (!bus)
    co_return fail(FaultKind::refused, "These controllers cannot do a sequence together.",
                   "Nothing was sent.");
  auto parts = pieces_together(sequence, *bus, from_step);
  if (!parts) co_return fail(parts.error());
  auto seats = PieceSync::seats(parts->size());
  std::vector<Asked> begun;
  for (std::size_t i = 0; i < parts->size(); ++i) {
    const std::size_t member = ix(find(sequence.axes[i].name));
    intent::RunInPieces part(std::make_shared<const Pieces>(std::move((*parts)[i])), std::move(seats[i]));
    begun.push_back({member, members_[member]->post(std::move(part))});
  }
  co_return co_await outcomes(std::move(begun));
}

Task<Result<>> SessionGroup::post_together(IntentBody request) {
  const auto self = shared_from_this();
  std::vector<Asked> all;
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (members_[i]->known().pieces.running) all.push_back({i, members_[i]->post(request)});
  if (all.empty())
    co_return fail(FaultKind::refused, "These controllers run nothing together now.", "Nothing was sent.");
  co_return co_await outcomes(std::move(all));
}

namespace {

struct Together {
  Together(Scheduler& scheduler, std::size_t parts) : left(parts), ended(scheduler) {}
  std::size_t left;
  Event ended;
};

Task<> take_part(Task<> work, std::shared_ptr<Together> together) {
  co_await std::move(work);
  --together->left;
  together->ended.notify();
}

// Runs all tasks concurrently.
Task<> all_together(Scheduler& scheduler, std::vector<Task<>> works) {
  const auto together = std::make_shared<Together>(scheduler, works.size());
  for (Task<>& work : works)
    asio::co_spawn(scheduler.executor(), take_part(std::move(work), together), asio::detached);
  while (together->left > 0) co_await together->ended.wait();
}

using Results = std::vector<Result<>>;

Task<> wait_for_one(std::shared_ptr<Session> member, Duration patience, std::shared_ptr<Results> results,
                    std::size_t place) {
  (*results)[place] = co_await member->wait_until_idle(patience);
}

}  // namespace

// Concurrent, as each needs a status round of its own, which takes long for thirty on a slow wire.
Task<Result<>> SessionGroup::wait_until_idle(Duration patience) {
  const auto self = shared_from_this();
  const auto results = std::make_shared<Results>(members_.size());
  std::vector<Task<>> waits;
  for (std::size_t i = 0; i < members_.size(); ++i)
    waits.push_back(wait_for_one(members_[i], patience, results, i));
  co_await all_together(scheduler_, std::move(waits));
  for (std::size_t i = 0; i < results->size(); ++i)
    if (Result<>& result = (*results)[i]; !result) co_return fault_of(i, std::move(result.error()));
  co_return Result<>();
}

Task<Result<>> SessionGroup::wait_until_connected() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    auto connected = co_await members_[i]->wait_until_connected();
    if (!connected) co_return fault_of(i, std::move(connected.error()));
  }
  co_return Result<>();
}

Task<> SessionGroup::close() {
  const auto self = shared_from_this();
  std::vector<Task<>> closings;
  for (const auto& member : members_) closings.push_back(member->close());
  co_await all_together(scheduler_, std::move(closings));
}

}  // namespace hw
