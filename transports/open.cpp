#include "transports/open.h"

#include <cmath>

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/emulation/bench_file.h"
#include "core/session/transport_list.h"
#include "core/session/user_files.h"
#include "transports/bus_port.h"
#include "transports/performax_usb.h"
#include "transports/port_holder.h"
#include "transports/rfc2217.h"
#include "transports/serial.h"
#include "transports/tcp.h"
#include "transports/vme_device.h"

namespace hw {
namespace {

constexpr std::uintmax_t largest_bench_file = 1 << 20;

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
  if (const int baud = whole_number<int>(text).value_or(0); baud > 0) return baud;
  return bad(fmt::format("baud={} is not a rate.", text), "Give a whole number, for example baud=9600.");
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
    return bad(fmt::format("speed={} is not a speed.", speed), "Use a number above 0; speed=1 is real time.");
  return host;
}

Result<BenchFile> read_bench(const std::string& file, const DeviceType& type, const DeviceOptions& keys) {
  if (file.empty()) return BenchFile();
  const auto catalog = type.make_catalog(keys);
  if (!catalog) return fail(catalog.error());
  auto bench = read_file(file, largest_bench_file).and_then([&](const std::string& text) {
    return parse_bench_file(text, *catalog, file);
  });
  if (!bench) bench.error().kind = FaultKind::port;  // the file is wrong, not the address
  return bench;
}

// The keys of a device, repeated for each id.
std::vector<DeviceOptions> keys_of_each(DeviceOptions keys, const std::vector<std::string>& ids) {
  std::vector<DeviceOptions> sets;
  for (const std::string& id : ids) {
    keys["id"] = id;
    sets.push_back(keys);
  }
  if (sets.empty()) sets.push_back(std::move(keys));
  return sets;
}

Result<Wire> plug_in(const std::shared_ptr<EmulatorHost>& host, int baud) {
  Wire wire;
  if (host->is_board()) {
    auto window = host->plug_in_window();
    if (!window) return fail(window.error());
    wire.window = std::move(*window);
  } else {
    auto stream = host->plug_in(baud);
    if (!stream) return fail(stream.error());
    wire.stream = std::move(*stream);
  }
  for (std::size_t i = 0; i < host->device_count(); ++i) wire.benches.push_back(host->bench(i));
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
  auto host = EmulatorHost::of(again);
  if (!host) {
    auto made = make_emulator_host(scheduler, type, address.options, address.ids(), options);
    if (!made) co_return fail(made.error());
    host = std::move(*made);
  }
  co_return plug_in(host, baud);
}

// Checks the keys of a device type by making its emulator, so that a misspelt key is noticed.
Result<> check_device_keys(const DeviceType& type, const Address& address) {
  if (address.options.empty() || !type.make_emulator) return {};
  for (const Address& device : address.devices())
    if (const auto emulator = type.make_emulator(device.options); !emulator) return fail(emulator.error());
  return {};
}

/// "Use vme, bus or emulator."
std::string use_one_for(const Catalog& catalog) {
  std::string words = "Use ";
  for (const TransportInfo* way : ways_to(catalog)) words.append(way->name).append(", ");
  return words.erase(words.size() - 2) + " or emulator.";
}

Wire real_wire(std::unique_ptr<Stream> stream) {
  Wire wire;
  wire.stream = std::move(stream);
  return wire;
}

// Takes baud=, or the model's usual rate.
Result<int> take_baud(const DeviceType& type, DeviceOptions& keys) {
  if (const std::string text = take(keys, "baud"); !text.empty()) return read_baud(text);
  const auto catalog = type.make_catalog(keys);
  if (!catalog) return fail(catalog.error());
  return catalog->can.usual_baud;
}

/// A controller that closes releases its port only when its last commands have ended. Opening waits for that,
/// but not for long, because another open tab may hold the port.
Task<Result<std::unique_ptr<Stream>>> open_once_released(Scheduler& scheduler, std::string path, int baud) {
  constexpr Duration longest = Millis(500), between = Millis(20);
  const Instant given_up = scheduler.now() + longest;
  for (;;) {
    PortRefusal refusal = PortRefusal::none;
    auto stream = open_serial(scheduler, path, baud, &refusal);
    const bool ours = refusal == PortRefusal::busy && port_holder(path) == this_program;
    if (stream || !ours || scheduler.now() >= given_up) co_return stream;
    co_await scheduler.sleep_for(between);
  }
}

Task<Result<Wire>> open_serial_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                    std::shared_ptr<BenchAccess>, const OpenOptions&) {
  const auto baud = take_baud(type, address.options);
  if (!baud) co_return fail(baud.error());
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto stream = co_await open_once_released(scheduler, address.where, *baud);
  if (!stream) co_return fail(stream.error());
  co_return real_wire(std::move(*stream));
}

Task<Result<Wire>> open_tcp_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess>, const OpenOptions&) {
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto stream = co_await open_tcp(scheduler, std::move(address.where));
  if (!stream) co_return fail(stream.error());
  co_return real_wire(std::move(*stream));
}

Task<Result<Wire>> open_rfc2217_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                     std::shared_ptr<BenchAccess>, const OpenOptions&) {
  const auto baud = take_baud(type, address.options);
  if (!baud) co_return fail(baud.error());
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto stream = co_await open_rfc2217(scheduler, std::move(address.where), *baud);
  if (!stream) co_return fail(stream.error());
  co_return real_wire(std::move(*stream));
}

Task<Result<Wire>> open_usb_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess>, const OpenOptions&) {
  const auto catalog = type.make_catalog({});
  if (!catalog) co_return fail(catalog.error());
  if (!catalog->can.usb)
    co_return bad(fmt::format("The {} has no USB.", catalog->short_name), use_one_for(*catalog));
  if (!address.ids().empty())
    co_return bad("On USB a controller has no id: it does not share its wire.", "Leave id= out.");
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto stream = co_await open_performax_usb(scheduler, std::move(address.where));
  if (!stream) co_return fail(stream.error());
  co_return real_wire(std::move(*stream));
}

Wire real_window(std::unique_ptr<Window> window) {
  Wire wire;
  wire.window = std::move(window);
  return wire;
}

Task<Result<Wire>> open_bus_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess>, const OpenOptions&) {
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto window = co_await open_bus_port(scheduler, std::move(address.where));
  if (!window) co_return fail(window.error());
  co_return real_window(std::move(*window));
}

// Takes base=: "0xF000", or a plain number.
Result<std::uint32_t> take_base(DeviceOptions& keys) {
  const std::string text = take(keys, "base", "0xF000");
  char* end = nullptr;
  const unsigned long base = std::strtoul(text.c_str(), &end, 0);
  if (*end == '\0' && base <= 0xFFFF) return static_cast<std::uint32_t>(base);
  return bad(fmt::format("base={} is not an address in the short address space.", text),
             "Give the address that the jumpers of the board set, for example base=0xF000.");
}

Task<Result<Wire>> open_vme_wire(Scheduler& scheduler, const DeviceType& type, Address address,
                                 std::shared_ptr<BenchAccess>, const OpenOptions&) {
  const auto base = take_base(address.options);
  if (!base) co_return fail(base.error());
  if (auto checked = check_device_keys(type, address); !checked) co_return fail(checked.error());
  auto window = open_vme_device(scheduler, address.where, *base);
  if (!window) co_return fail(window.error());
  co_return real_window(std::move(*window));
}

using Open = Task<Result<Wire>> (*)(Scheduler&, const DeviceType&, Address, std::shared_ptr<BenchAccess>,
                                    const OpenOptions&);
constexpr std::pair<std::string_view, Open> openers[] = {
    {"emulator", open_emulator},    {"serial", open_serial_wire}, {"tcp", open_tcp_wire},
    {"rfc2217", open_rfc2217_wire}, {"usb", open_usb_wire},       {"bus", open_bus_wire},
    {"vme", open_vme_wire},
};

// A board in a memory window and a byte-stream device need different transports.
Result<> check_kind(const TransportInfo& transport, const DeviceType& type) {
  using Reaches = TransportInfo::Reaches;
  if (transport.reaches == Reaches::both) return {};
  const auto catalog = type.make_catalog({});
  if (!catalog) return fail(catalog.error());
  if (catalog->can.window == (transport.reaches == Reaches::windows)) return {};
  return bad(
      catalog->can.window
          ? fmt::format("The {} is a board on a bus, not at the end of a line: \"{}\" does not reach it.",
                        catalog->short_name, transport.name)
          : fmt::format("The {} is not a board on a bus: \"{}\" does not reach it.", catalog->short_name,
                        transport.name),
      use_one_for(*catalog));
}

Task<Result<Wire>> open_wire(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again,
                             std::shared_ptr<const OpenOptions> options) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) co_return fail(unknown_model(address.model));
  const TransportInfo* transport = find_transport(address.transport);
  if (transport) {
    if (auto fits = check_kind(*transport, *type); !fits) co_return fail(fits.error());
    for (const auto& [name, open] : openers) {
      if (name != address.transport) continue;
      auto wire = co_await open(scheduler, *type, std::move(address), std::move(again), *options);
      if (wire) wire->keeper = options->keeper;
      co_return wire;
    }
  }
  co_return bad(fmt::format("The {} cannot be reached by \"{}\".", type->model, address.transport),
                "Check the name of the transport in its address.");
}

}  // namespace

WireOpener make_wire_opener(OpenOptions options) {
  auto shared = std::make_shared<const OpenOptions>(std::move(options));
  return [shared](Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
    return open_wire(scheduler, std::move(address), std::move(again), shared);
  };
}

Result<std::shared_ptr<EmulatorHost>> make_emulator_host(Scheduler& scheduler, const DeviceType& type,
                                                         DeviceOptions keys,
                                                         const std::vector<std::string>& ids,
                                                         const OpenOptions& options) {
  auto host_options = take_host_options(type.model, keys);
  if (!host_options) return fail(host_options.error());
  const std::string bench_file = take(keys, "bench");
  const auto sets = keys_of_each(std::move(keys), ids);
  const auto bench = read_bench(bench_file, type, sets.front());
  if (!bench) return fail(bench.error());
  std::vector<HostedDevice> devices;
  for (DeviceOptions own : sets) {
    for (const std::string& quirk : bench->quirks) {
      std::string& all = own["quirk"];
      all += (all.empty() ? "" : "+") + quirk;
    }
    if (!type.make_emulator) return bad(fmt::format("There is no emulated {}.", type.model), {});
    auto emulator = type.make_emulator(own);
    if (!emulator) return fail(emulator.error());
    devices.push_back(HostedDevice{own.contains("id") ? own["id"] : "", std::move(*emulator)});
  }
  auto host = EmulatorHost::make(scheduler, std::move(devices), std::move(*host_options), options.trouble);
  if (!host) return host;
  if (auto stands = (*host)->set_up(*bench); !stands) return fail(stands.error());
  return host;
}

}  // namespace hw
