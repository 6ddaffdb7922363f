#include "transports/memory.h"

#include <array>

#include <fmt/core.h>

namespace hw {
namespace {

struct Side {
  Stream::Listener* listener = nullptr;
  bool exists = true;
  bool end_reported = false;
  bool posted = false;
  std::string inbox, batch;  // both keep their capacity
};

struct Shared : std::enable_shared_from_this<Shared> {
  Scheduler& scheduler;
  MemoryWire wire;
  std::array<Side, 2> sides;

  Shared(Scheduler& s, MemoryWire w) : scheduler(s), wire(std::move(w)) {}

  void post_delivery(int to) {
    if (std::exchange(sides[to].posted, true)) return;
    asio::post(scheduler.executor(), [self = shared_from_this(), to] { self->deliver(to); });
  }
  void deliver(int to) {
    Side& side = sides[to];
    side.posted = false;
    side.batch.clear();
    side.batch.swap(side.inbox);
    if (side.listener && !side.batch.empty()) side.listener->bytes_arrived(side.batch);
    const bool alone = !sides[1 - to].exists;
    if (side.listener && alone && !std::exchange(side.end_reported, true)) {
      const Fault why = wire.gone;
      side.listener->stream_closed(why);
    }
  }
};

class MemoryEnd final : public Stream {
 public:
  MemoryEnd(std::shared_ptr<Shared> shared, int place) : shared_(std::move(shared)), place_(place) {}
  ~MemoryEnd() override {
    mine().exists = false;
    mine().listener = nullptr;
    if (other().exists) shared_->post_delivery(1 - place_);
  }

  void listen(Listener* listener) override {
    mine().listener = listener;
    if (listener && !other().exists) shared_->post_delivery(place_);
  }
  void discard_unsent() override {}
  void send(std::string_view bytes) override {
    if (!other().exists || bytes.empty()) return;
    other().inbox += bytes;
    shared_->post_delivery(1 - place_);
  }
  Result<> set_rate(int baud) override {
    if (shared_->wire.baud != 0) shared_->wire.baud = baud;
    return {};
  }
  [[nodiscard]] int rate() const override { return shared_->wire.baud; }
  [[nodiscard]] std::string describe() const override {
    return rate() == 0 ? shared_->wire.name : fmt::format("{}, {} baud", shared_->wire.name, rate());
  }

 private:
  [[nodiscard]] Side& mine() const { return shared_->sides[place_]; }
  [[nodiscard]] Side& other() const { return shared_->sides[1 - place_]; }

  std::shared_ptr<Shared> shared_;
  int place_;
};

}  // namespace

std::pair<std::unique_ptr<Stream>, std::unique_ptr<Stream>> make_memory_pair(Scheduler& scheduler,
                                                                             MemoryWire wire) {
  auto shared = std::make_shared<Shared>(scheduler, std::move(wire));
  return {std::make_unique<MemoryEnd>(shared, 0), std::make_unique<MemoryEnd>(shared, 1)};
}

}  // namespace hw
