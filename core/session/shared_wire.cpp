#include "core/session/shared_wire.h"

#include "core/link/link_log.h"

namespace hw {

SharedWire::SharedWire(Scheduler& scheduler, Address address, WireOpener opener)
    : scheduler_(scheduler), address_(std::move(address)), opener_(std::move(opener)), opened_(scheduler) {}

std::shared_ptr<BenchAccess> SharedWire::bench(std::size_t place) const {
  return place < benches_.size() ? benches_[place] : nullptr;
}

Task<Result<Wire>> SharedWire::open() {
  struct Opening {
    SharedWire& wire;
    explicit Opening(SharedWire& w) : wire(w) { wire.opening_ = true; }
    ~Opening() {
      wire.opening_ = false;
      wire.opened_.notify();
    }
  } opening(*this);
  Address address = address_now();
  co_return co_await opener_(scheduler_, std::move(address), bench(0));
}

// A controller keeps a new rate until power-off, or longer if stored: both rates are tried in turn.
Address SharedWire::address_now() {
  Address address = address_;
  if (std::exchange(rate_set_is_next_, !rate_set_is_next_) && rate_set_ > 0) {
    link_log().debug("{} is tried at {} baud, the rate that was set last", address_.text(), rate_set_);
    address.options["baud"] = std::to_string(rate_set_);
  }
  return address;
}

Task<Result<std::shared_ptr<Link>>> SharedWire::link() {
  const auto self = shared_from_this();
  while (opening_) co_await opened_.wait();
  std::shared_ptr<Link> link = link_.lock();
  if (link && link->is_open()) co_return link;
  if (failure_ && scheduler_.now() - failed_at_ < same_attempt) co_return fail(*failure_);
  failure_.reset();
  auto wire = co_await open();
  if (wire) {
    link_log().debug("{} is open", address_.text());
    benches_ = std::move(wire->benches);
    link = wire->window ? std::make_shared<Link>(scheduler_, std::move(wire->window))
                        : std::make_shared<Link>(scheduler_, std::move(wire->stream));
    link->entrust_to(std::move(wire->keeper), !benches_.empty());
    link->rate_set = [self = weak_from_this()](int baud) {
      const auto wire = self.lock();
      if (!wire) return;
      wire->rate_set_ = baud;
      wire->rate_set_is_next_ = true;
    };
    link_ = link;
  } else {
    failure_ = wire.error();
    link_log().debug("{} cannot be opened: {}", address_.text(), failure_->sentence());
    failed_at_ = scheduler_.now();
  }
  if (failure_) co_return fail(*failure_);
  co_return link;
}

}  // namespace hw
