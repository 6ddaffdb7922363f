// Serves an emulated board in a memory window. All windows onto it, in this process or over a bus port, run
// cycles on the same board, at the present time.
#include <algorithm>

#include <fmt/core.h>

#include "core/emulation/bus_target.h"
#include "transports/bus_port.h"
#include "transports/gone.h"
#include "transports/serve.h"

namespace hw {

/// The window in this process.
class EmulatorHost::HostWindow final : public Window {
 public:
  explicit HostWindow(std::shared_ptr<EmulatorHost> host) : host_(std::move(host)) {
    host_->windows_.push_back(this);
  }
  ~HostWindow() override {
    if (host_) std::erase(host_->windows_, this);
  }
  void listen(Listener* listener) override { link_->listener = listener; }
  [[nodiscard]] bool reports_interrupts() const override { return true; }
  [[nodiscard]] std::string describe() const override { return host_ ? host_->options_.name : "nothing"; }

  Task<Result<>> run(std::span<BusCycle> cycles) override {
    if (!host_) co_return fail(gone_);
    const auto keep = host_;
    keep->run_cycles(cycles);
    co_return Result<>();
  }

  void interrupt(std::uint8_t vector) {
    post([vector](Listener& listener) { listener.interrupted(vector); });
  }
  void pull() {
    gone_ = cable_pulled(host_->options_.name);
    post([why = gone_](Listener& listener) { listener.window_closed(why); });
    host_ = nullptr;
  }

 private:
  struct Link {
    Listener* listener = nullptr;
  };
  template <class Call>
  void post(Call call) {
    asio::post(host_->scheduler_.executor(), [link = link_, call] {
      if (link->listener) call(*link->listener);
    });
  }

  std::shared_ptr<EmulatorHost> host_;  ///< null: the cable is pulled
  std::shared_ptr<Link> link_ = std::make_shared<Link>();
  Fault gone_;
};

/// A connection of a bus port.
struct EmulatorHost::BusClient final : Stream::Listener {
  EmulatorHost& host;
  std::unique_ptr<Stream> stream;
  BusPortTalk talk;
  std::string answers;  // keeps its capacity

  BusClient(EmulatorHost& h, std::unique_ptr<Stream> s) : host(h), stream(std::move(s)) {
    stream->listen(this);
  }
  void bytes_arrived(std::string_view bytes) override {
    const auto keep = host.shared_from_this();
    answers.clear();
    const Instant now = keep->emulator_time();
    keep->catch_up(now);
    const auto taken = talk.take(
        bytes, [&](BusCycle& cycle) { keep->run_cycle(cycle); }, answers);
    if (!answers.empty()) stream->send(answers);
    keep->run_until(now);
    if (taken) return;
    if (keep->trouble_) keep->trouble_(taken.error());
    leave();
  }
  void stream_closed(const Fault&) override { leave(); }
  void leave() {
    const auto keep = host.shared_from_this();
    std::erase_if(keep->bus_clients_, [this](const auto& client) { return client.get() == this; });
  }
};

Result<std::unique_ptr<Window>> EmulatorHost::plug_in_window() {
  if (faults_.unplugged) return fail(cable_is_out(options_.name));
  return std::make_unique<HostWindow>(shared_from_this());
}

void EmulatorHost::attach_bus(std::unique_ptr<Stream> client) {
  bus_clients_.push_back(std::make_shared<BusClient>(*this, std::move(client)));
}

void EmulatorHost::run_cycles(std::span<BusCycle> cycles) {
  const Instant now = emulator_time();
  catch_up(now);
  for (BusCycle& cycle : cycles) run_cycle(cycle);
  run_until(now);
}

// While the cable is pulled or the board has no power there is no answer, and a read gives ones.
void EmulatorHost::run_cycle(BusCycle& cycle) {
  const std::uint32_t ones = 0xFFFFFFFFu >> (32 - 8 * cycle.width);
  const bool dropped = faults_.to_drop > 0;
  if (dropped) faults_.to_drop = std::max(0, faults_.to_drop - cycle.width);
  if (faults_.unplugged || dropped) {
    if (!cycle.write) cycle.value = ones;
    return;
  }
  const std::uint32_t read = bus_cycle(*board(), cycle.write, cycle.width, cycle.offset, cycle.value);
  if (cycle.write) return;
  cycle.value = read;
  if (faults_.to_garble == 0) return;
  std::string bytes;
  for (int i = cycle.width; i-- > 0;) bytes += static_cast<char>(read >> (8 * i) & 0xFF);
  spoil(bytes);
  cycle.value = 0;
  for (const char c : bytes) cycle.value = cycle.value << 8 | static_cast<unsigned char>(c);
}

// All hosts on the bus get the interrupt; one of them acknowledges it for all.
void EmulatorHost::notify_interrupt() {
  BusTarget* target = board();
  if (!target || windows_.empty()) return;
  const auto vector = target->interrupt();
  if (!vector) return;
  target->acknowledge();
  for (HostWindow* window : windows_) window->interrupt(*vector);
}

void EmulatorHost::pull_windows() {
  for (HostWindow* window : std::exchange(windows_, {})) window->pull();
}

}  // namespace hw
