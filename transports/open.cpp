#include "transports/open.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/base/file.h"
#include "transports/tcp.h"

namespace hw {
namespace {

std::string take(DeviceOptions& keys, const char* key, std::string fallback = {}) {
  const auto found = keys.find(key);
  if (found == keys.end()) return fallback;
  std::string value = std::move(found->second);
  keys.erase(found);
  return value;
}

tl::unexpected<Fault> bad(std::string what, std::string advice) {
  return fail(FaultKind::text, std::move(what), "Nothing was opened.", std::move(advice));
}

Result<int> read_baud(const std::string& text) {
  int baud = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), baud);
  if (error == std::errc{} && end == text.data() + text.size() && baud > 0) return baud;
  return bad(fmt::format("baud={} is no rate.", text), "Give a whole number, for example baud=9600.");
}

Result<HostOptions> take_host_options(std::string_view model, DeviceOptions& keys) {
  HostOptions host;
  host.name = fmt::format("emulated {}", model);
  host.state_file = take(keys, "state");
  const std::string wire = take(keys, "wire", "off");
  if (wire != "real" && wire != "off")
    return bad(fmt::format("wire={} is unknown.", wire), "Use wire=real or wire=off.");
  host.byte_times = wire == "real";
  const std::string speed = take(keys, "speed", "1");
  char* end = nullptr;
  host.speed = std::strtod(speed.c_str(), &end);
  if (*end != '\0' || !std::isfinite(host.speed) || host.speed <= 0)
    return bad(fmt::format("speed={} is no speed.", speed), "Use a number above 0; speed=1 is real time.");
  return host;
}

Result<Wire> plug_in(std::shared_ptr<EmulatorHost> host, int baud) {
  auto stream = host->plug_in(baud);
  if (!stream) return fail(stream.error());
  Wire wire;
  wire.stream = std::move(*stream);
  wire.bench = std::move(host);
  return wire;
}

Task<Result<Wire>> open_emulator(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess> again, const OpenOptions& options) {
  int baud = 0;
  if (const std::string text = take(address.options, "baud"); !text.empty()) {
    const auto read = read_baud(text);
    if (!read) co_return fail(read.error());
    baud = *read;
  }
  auto host = std::dynamic_pointer_cast<EmulatorHost>(again);
  if (!host) {
    auto made = make_emulator_host(scheduler, type, std::move(address.options), options);
    if (!made) co_return fail(made.error());
    host = std::move(*made);
  }
  co_return plug_in(std::move(host), baud);
}

Result<> no_keys_left(const DeviceType& type, const DeviceOptions& keys) {
  if (const auto catalog = type.make_catalog(keys); !catalog) return fail(catalog.error());
  return {};
}

Wire real_wire(std::unique_ptr<Stream> stream) {
  Wire wire;
  wire.stream = std::move(stream);
  return wire;
}

Task<Result<Wire>> open_tcp_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess>, const OpenOptions&) {
  if (auto understood = no_keys_left(type, address.options); !understood) co_return fail(understood.error());
  auto stream = co_await open_tcp(scheduler, std::move(address.where));
  if (!stream) co_return fail(stream.error());
  co_return real_wire(std::move(*stream));
}

using Open = Task<Result<Wire>> (*)(Scheduler&, const DeviceType&, Address, std::shared_ptr<BenchAccess>,
                                    const OpenOptions&);
struct Transport {
  std::string_view scheme;
  Open open;
};
constexpr Transport transports[] = {
    {"emulator", open_emulator},
    {"tcp", open_tcp_wire},
};

Task<Result<Wire>> open_wire(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again,
                             std::shared_ptr<const OpenOptions> options) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) co_return bad(fmt::format("There is no controller model \"{}\".", address.model), {});
  for (const Transport& transport : transports) {
    if (transport.scheme != address.transport) continue;
    co_return co_await transport.open(scheduler, *type, std::move(address), std::move(again), *options);
  }
  co_return bad(fmt::format("The {} cannot be reached by \"{}\".", type->model, address.transport),
                "Use serial, tcp, rfc2217 or emulator.");
}

}  // namespace

WireOpener make_wire_opener(OpenOptions options) {
  auto shared = std::make_shared<const OpenOptions>(std::move(options));
  return [shared](Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
    return open_wire(scheduler, std::move(address), std::move(again), shared);
  };
}

Result<std::shared_ptr<EmulatorHost>> make_emulator_host(Scheduler& scheduler, const DeviceType& type,
                                                         DeviceOptions keys, const OpenOptions& options) {
  auto host_options = take_host_options(type.model, keys);
  if (!host_options) return fail(host_options.error());
  const std::string bench_file = take(keys, "bench");
  auto emulator = type.make_emulator(keys);
  if (!emulator) return fail(emulator.error());
  if (!bench_file.empty()) {
    if (!options.apply_bench) return bad(fmt::format("bench={}: no bench files here.", bench_file), {});
    const auto text = read_text_file(bench_file);
    if (!text) return fail(text.error());
    const auto catalog = type.make_catalog(keys);
    if (!catalog) return fail(catalog.error());
    if (auto applied = options.apply_bench(*catalog, *text, **emulator); !applied)
      return fail(applied.error());
  }
  return EmulatorHost::make(scheduler, std::move(*emulator), std::move(*host_options), options.trouble);
}

}  // namespace hw
