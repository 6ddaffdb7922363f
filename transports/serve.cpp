#include "transports/serve.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>
#include <unistd.h>

#include "core/session/user_files.h"
#include "transports/gone.h"
#include "transports/memory.h"

namespace hw {
namespace {
constexpr std::uintmax_t largest_file = 1 << 20;
}

struct EmulatorHost::Client final : Stream::Listener {
  EmulatorHost& host;
  std::unique_ptr<Stream> stream;
  bool by_cable;

  Client(EmulatorHost& h, std::unique_ptr<Stream> s, bool c) : host(h), stream(std::move(s)), by_cable(c) {
    stream->listen(this);
  }
  void bytes_arrived(std::string_view bytes) override {
    const auto keep = host.shared_from_this();
    keep->bytes_from(*this, bytes);
  }
  void stream_closed(const Fault&) override {
    const auto keep = host.shared_from_this();
    std::erase_if(keep->clients_, [this](const auto& client) { return client.get() == this; });
  }
};

/// Checks the folder of a file that will be written later.
static Result<> check_folder(const std::filesystem::path& path) {
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code error;
  if (std::filesystem::is_directory(folder, error)) return {};
  return fail(FaultKind::port,
              fmt::format("There is no folder {} to keep {} in.", folder.string(), path.filename().string()),
              "Nothing is served.", "Create the folder, or choose another place.");
}

// A controller on the wire, with its bench and its state file.
class EmulatorHost::Device final : public BenchAccess {
 public:
  Device(EmulatorHost& host, std::unique_ptr<Emulator> e) : host_(host), emulator_(std::move(e)) {}

  Result<> load(const std::string& path) {
    if (::access(path.c_str(), F_OK) != 0) return check_folder(path);
    const auto text = read_file(path, largest_file);
    const auto loaded = text ? emulator_->load_memory(*text) : fail(text.error());
    if (loaded) return {};
    Fault fault = loaded.error();
    fault.kind = FaultKind::port;  // the file is wrong, not the option
    if (!text) return fail(std::move(fault));

    fault.what = fmt::format("{} is not the saved memory of this controller: {}", path, fault.what);
    return fail(std::move(fault));
  }
  void keep_memory_in(std::unique_ptr<StateFile> file) {
    state_ = std::move(file);
    kept_version_ = emulator_->memory_version();
  }
  void keep_memory() {
    if (!state_ || emulator_->memory_version() == kept_version_) return;
    kept_version_ = emulator_->memory_version();
    state_->keep(emulator_->save_memory());
  }

  void take_byte(ByteLine::Byte byte) {
    const int rate = emulator_->rate();
    if (byte.sender_baud == 0 || rate == 0 || byte.sender_baud == rate)
      emulator_->receive(std::string_view(&byte.value, 1));
    else
      emulator_->receive(misread(static_cast<unsigned char>(byte.value), byte.sender_baud, rate));
  }
  [[nodiscard]] Emulator& own() { return *emulator_; }
  [[nodiscard]] const std::shared_ptr<EmulatorHost> host() const { return host_.shared_from_this(); }

  Result<> operate(const BenchCommand& command) override { return host_.operate(*this, command); }
  void look(BenchView& view) const override {
    host_.advance(host_.emulator_time());
    emulator_->look(view);
    view.present = true;
    view.unplugged = host_.faults_.unplugged;
  }
  void begin_like(const ControllerState& state, const Catalog& catalog) override {
    host_.advance(host_.emulator_time());
    emulator_->begin_like(state, catalog);
  }
  [[nodiscard]] const Emulator& emulator() const override {
    host_.advance(host_.emulator_time());
    return *emulator_;
  }
  void notify_changed() {
    if (!changed) return;
    BenchView view;
    look(view);
    if (view == seen_) return;
    seen_ = view;
    const auto notify = changed;  // the callback may replace itself
    notify();
  }

 private:
  EmulatorHost& host_;
  std::unique_ptr<Emulator> emulator_;
  std::unique_ptr<StateFile> state_;
  std::uint64_t kept_version_ = 0;
  BenchView seen_;
};

EmulatorHost::EmulatorHost(Scheduler& scheduler, HostOptions options)
    : scheduler_(scheduler),
      options_(std::move(options)),
      began_(scheduler.now()),
      timer_(scheduler, [this] { alarm(); }) {}

EmulatorHost::~EmulatorHost() = default;

BusTarget* EmulatorHost::board() const { return devices_.empty() ? nullptr : devices_.front()->own().bus(); }

Result<std::shared_ptr<EmulatorHost>> EmulatorHost::make(Scheduler& scheduler,
                                                         std::vector<HostedDevice> devices,
                                                         HostOptions options, Trouble trouble) {
  std::shared_ptr<EmulatorHost> host(new EmulatorHost(scheduler, std::move(options)));
  host->trouble_ = std::move(trouble);
  const std::string& file = host->options_.state_file;
  const bool several = devices.size() > 1;
  for (HostedDevice& device : devices) {
    const std::string state = file.empty() || !several ? file : fmt::format("{}.{}", file, device.id);
    if (auto added = host->add_device(std::move(device), state); !added) return fail(added.error());
  }
  host->run_until(host->emulator_time());
  return host;
}

Result<std::shared_ptr<EmulatorHost>> EmulatorHost::make(Scheduler& scheduler,
                                                         std::unique_ptr<Emulator> emulator,
                                                         HostOptions options, Trouble trouble) {
  std::vector<HostedDevice> alone(1);
  alone.front().emulator = std::move(emulator);
  return make(scheduler, std::move(alone), std::move(options), std::move(trouble));
}

Result<> EmulatorHost::add_device(HostedDevice device, const std::string& state_file) {
  auto added = std::make_unique<Device>(*this, std::move(device.emulator));
  if (!state_file.empty()) {
    if (auto loaded = added->load(state_file); !loaded) return loaded;
    added->keep_memory_in(std::make_unique<StateFile>(scheduler_, state_file, trouble_));
  }
  devices_.push_back(std::move(added));
  return {};
}

std::shared_ptr<BenchAccess> EmulatorHost::bench(std::size_t device) {
  return std::shared_ptr<BenchAccess>(shared_from_this(), devices_.at(device).get());
}

std::shared_ptr<EmulatorHost> EmulatorHost::of(const std::shared_ptr<BenchAccess>& bench) {
  const auto* device = dynamic_cast<const Device*>(bench.get());
  return device ? device->host() : nullptr;
}

// ---- time ----

Instant EmulatorHost::emulator_time() const {
  const Duration passed = scheduler_.now() - began_;
  if (options_.speed == 1) return Instant(passed);
  return Instant(Duration(std::llround(static_cast<double>(passed.count()) * options_.speed)));
}

Instant EmulatorHost::scheduler_time(Instant emulated) const {
  const Duration passed = emulated.time_since_epoch();
  if (options_.speed == 1) return began_ + passed;
  return began_ + Duration(static_cast<Duration::rep>(
                      std::ceil(static_cast<double>(passed.count()) / options_.speed)));
}

Instant EmulatorHost::next_due() const {
  const Instant planned = plan_.empty() ? Instant::max() : Instant(plan_.front().at);
  Instant first = std::min({planned, incoming_.due(), outgoing_.due()});
  for (const auto& device : devices_) first = std::min(first, device->own().next_event().value_or(first));
  return first;
}

int EmulatorHost::line_rate() const { return devices_.front()->own().rate(); }

void EmulatorHost::alarm() {
  const auto keep = shared_from_this();
  run_until(std::max(emulator_time(), armed_for_));  // scaling rounds, but the armed time is due in any case
}

void EmulatorHost::advance(Instant when) const {
  reached_ = std::max(reached_, when);
  for (const auto& device : devices_) device->own().advance_to(reached_);
}

// Runs all due events in order, each at its own time however late the alarm, then goes on to the present.
void EmulatorHost::catch_up(Instant now) {
  for (Instant next = next_due(); next <= now; next = next_due()) step_to(next);
  step_to(now);
}

void EmulatorHost::run_until(Instant now) {
  catch_up(now);
  finish_round();
}

void EmulatorHost::step_to(Instant when) {
  advance(when);
  while (!plan_.empty() && Instant(plan_.front().at) <= when) {
    const BenchCommand command = std::move(plan_.front().command);
    plan_.pop_front();
    for (const auto& device : devices_) (void)apply(*device, command);  // no caller waits for the result
  }
  while (incoming_.due() <= when) {
    reply_.late_by = reached_ - incoming_.due();  // delay of a late question
    land(incoming_.first());
    incoming_.pop(line_rate());
  }
  take_output();
  reply_.late_by = {};
  while (outgoing_.due() <= when) {
    const ByteLine::Byte byte = outgoing_.first();
    if (byte.sender_baud != sent_.baud) deliver();
    sent_.baud = byte.sender_baud;
    sent_.leaving += byte.value;
    reply_.left_at = outgoing_.due();
    outgoing_.pop(line_rate());
  }
}

void EmulatorHost::finish_round() {
  deliver();
  notify_interrupt();
  for (const auto& device : devices_) device->keep_memory();
  if (const Instant next = next_due(); next != Instant::max()) {
    armed_for_ = next;
    timer_.arm(scheduler_time(next));
  } else {
    timer_.disarm();
  }
  for (const auto& device : devices_) device->notify_changed();
}

// ---- bytes ----

void EmulatorHost::add_client(std::unique_ptr<Stream> stream, bool by_cable) {
  clients_.push_back(std::make_unique<Client>(*this, std::move(stream), by_cable));
}

void EmulatorHost::attach(std::unique_ptr<Stream> client) { add_client(std::move(client), false); }

void EmulatorHost::bytes_from(const Client& client, std::string_view bytes) {
  if (faults_.unplugged) return;
  const Instant now = emulator_time();
  catch_up(now);
  if (options_.byte_times) {
    incoming_.put(bytes, client.stream->rate(), now - time_off_the_wire(now), line_rate());
  } else if (devices_.size() == 1) {
    devices_.front()->own().receive(bytes);
  } else {
    for (const char c : bytes) {  // one byte at a time, so that simultaneous replies collide
      for (const auto& device : devices_) device->own().receive(std::string_view(&c, 1));
      take_output();
    }
  }
  run_until(now);
}

// A real timer fires late, so the client gets its reply late. The kernel takes time to wake the client and to
// return its next question. If the client asks at once, this delay does not count as time on the wire. A
// client that asks later was not delayed.
Duration EmulatorHost::time_off_the_wire(Instant now) {
  const std::optional<Duration> late = std::exchange(reply_.late, std::nullopt);
  if (!late) return {};
  const Duration since_delivery = now - (reply_.left_at + *late);
  return since_delivery <= at_once ? *late + std::min(since_delivery, hand_over) : Duration{};
}

void EmulatorHost::land(ByteLine::Byte byte) {
  for (const auto& device : devices_) device->take_byte(byte);
}

void EmulatorHost::take_output() {
  std::string reply;
  int rate = 0;
  for (const auto& device : devices_) {
    sent_.fresh.clear();
    device->own().take_output(sent_.fresh);
    if (sent_.fresh.empty() || faults_.unplugged) continue;
    if (reply.empty()) rate = device->own().rate();
    reply = reply.empty() ? sent_.fresh : collided(reply, sent_.fresh);
  }
  if (reply.empty()) return;
  if (options_.byte_times)
    outgoing_.put(reply, rate, reached_ - reply_.late_by, line_rate());
  else
    sent_.leaving += reply;
}

void EmulatorHost::deliver() {
  if (sent_.leaving.empty()) return;
  spoil(sent_.leaving);
  for (const auto& client : clients_) {
    const int theirs = options_.byte_times ? client->stream->rate() : 0;
    if (theirs == 0 || sent_.baud == 0 || theirs == sent_.baud) {
      client->stream->send(sent_.leaving);
      continue;
    }
    std::string wrong;
    for (const char c : sent_.leaving) wrong += misread(static_cast<unsigned char>(c), sent_.baud, theirs);
    client->stream->send(wrong);
  }
  sent_.leaving.clear();
  if (options_.byte_times) reply_.late = std::max(Duration{}, emulator_time() - reply_.left_at);
}

void EmulatorHost::spoil(std::string& bytes) {
  const auto dropped = std::min<std::size_t>(static_cast<std::size_t>(faults_.to_drop), bytes.size());
  bytes.erase(0, dropped);
  faults_.to_drop -= static_cast<int>(dropped);
  static constexpr unsigned char flips[] = {0xA5, 0x5A, 0xC3, 0x3C};
  for (char& c : bytes) {
    if (faults_.to_garble == 0) break;
    --faults_.to_garble;
    c = static_cast<char>(static_cast<unsigned char>(c) ^ flips[faults_.garbled++ % std::size(flips)]);
  }
}

// ---- bench ----

Result<std::unique_ptr<Stream>> EmulatorHost::plug_in(int baud) {
  if (faults_.unplugged) return fail(cable_is_out(options_.name));
  MemoryWire wire;
  wire.name = options_.name;
  wire.gone = cable_pulled(options_.name);
  if (options_.byte_times) wire.baud = baud != 0 ? baud : line_rate();
  auto [ours, theirs] = make_memory_pair(scheduler_, std::move(wire));
  add_client(std::move(ours), true);
  return std::move(theirs);
}

Result<> EmulatorHost::set_up(const BenchFile& bench) {
  for (const BenchCommand& command : bench.at_start)
    for (const auto& device : devices_)
      if (auto done = operate(*device, command); !done) return done;
  const Duration now = emulator_time().time_since_epoch();
  for (TimedBenchCommand planned : bench.later) {
    planned.at += now;
    plan_.push_back(std::move(planned));
  }
  finish_round();
  return {};
}

Result<> EmulatorHost::operate(Device& device, const BenchCommand& command) {
  const auto keep = shared_from_this();
  const Instant now = emulator_time();
  catch_up(now);
  auto done = apply(device, command);
  run_until(now);
  return done;
}

// Switches belong to a device, the wire to all devices.
Result<> EmulatorHost::apply(Device& device, const BenchCommand& command) {
  if (const auto* unplug = std::get_if<bench::Unplug>(&command)) {
    pull_cable(unplug->on);
  } else if (const auto* garble = std::get_if<bench::Garble>(&command)) {
    faults_.to_garble = std::max(0, garble->bytes);
  } else if (const auto* drop = std::get_if<bench::Drop>(&command)) {
    faults_.to_drop = std::max(0, drop->bytes);
  } else {
    return device.own().operate(command);
  }
  return {};
}

void EmulatorHost::pull_cable(bool pulled) {
  faults_.unplugged = pulled;
  incoming_.clear();
  outgoing_.clear();
  sent_.leaving.clear();
  if (pulled) pull_windows();
  if (pulled) std::erase_if(clients_, [](const auto& client) { return client->by_cable; });
}

}  // namespace hw
