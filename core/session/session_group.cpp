#include "core/session/session_group.h"

#include <fmt/core.h>

namespace hw {

// All before any begins.
static Result<> check(const Address& address) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) return fail(FaultKind::text, fmt::format("There is no controller model \"{}\".", address.model));
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

static IntentBody stop_intent(bool at_once) {
  if (at_once) return intent::Abort();
  return intent::Stop();
}

void SessionGroup::stop_wire(bool at_once) const {
  if (!is_bus()) return;
  for (const auto& member : members_)
    if (member->pump().stop_wire(at_once)) return;
}

std::vector<IntentId> SessionGroup::stop(bool at_once) {
  asio::post(scheduler_.executor(), [self = shared_from_this(), at_once] { self->stop_wire(at_once); });
  std::vector<IntentId> ids;
  for (const auto& member : members_) ids.push_back(member->send(stop_intent(at_once)));
  return ids;
}

Task<Result<>> SessionGroup::perform_stop(bool at_once) {
  const auto self = shared_from_this();
  stop_wire(at_once);
  std::vector<IntentId> ids;
  for (const auto& member : members_) ids.push_back(member->post(stop_intent(at_once)));
  Result<> all;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    auto stopped = co_await members_[i]->outcome(ids[i]);
    if (all && !stopped) all = std::move(stopped);
  }
  co_return all;
}

Task<Result<>> SessionGroup::wait_until_idle(Duration patience) {
  const auto self = shared_from_this();
  const Instant deadline = scheduler_.now() + patience;
  for (const auto& member : members_) {
    auto idle = co_await member->wait_until_idle(deadline - scheduler_.now());
    if (!idle) co_return idle;
  }
  co_return Result<>();
}

Task<Result<>> SessionGroup::wait_until_connected() {
  for (const auto& member : members_) {
    auto connected = co_await member->wait_until_connected();
    if (!connected) co_return connected;
  }
  co_return Result<>();
}

Task<> SessionGroup::close() {
  for (const auto& member : members_) co_await member->close();
}

}  // namespace hw
