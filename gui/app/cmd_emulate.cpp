#include <algorithm>

#include <fmt/format.h>

#include "core/base/log.h"
#include "core/session/address.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/wiring.h"
#include "transports/open.h"
#include "transports/pty_endpoint.h"
#include "transports/tcp_endpoint.h"

namespace hw::app {
namespace {

struct Order {
  const DeviceType* type;
  DeviceOptions keys;
  std::vector<std::string> ids;
  std::vector<std::pair<std::string, std::string>> endpoints;  ///< "tcp", "bus" or "pty", and its address
  bool allow_remote;
};

// Whether one controller is alone on its line, with clients over TCP only. It then answers without its id
// too.
bool alone_on_its_line(const Order& order) {
  const auto is_pty = [](const auto& endpoint) { return endpoint.first == "pty"; };
  return order.ids.size() <= 1 && std::none_of(order.endpoints.begin(), order.endpoints.end(), is_pty);
}

Result<> understand_ids(Order& order) {
  const auto catalog = order.type->make_catalog({});
  if (!catalog) return fail(catalog.error());
  if (!order.ids.empty() && !catalog->addressed())
    return fail(FaultKind::text, fmt::format("The {} has no --id.", catalog->short_name), {},
                "It does not share a line.");
  for (const std::string& id : order.ids)
    if (id.size() != 2 || id.find_first_not_of("0123456789") != id.npos)
      return fail(FaultKind::text, fmt::format("--id {} is not a device number.", id), {},
                  "Give two digits, as --id 07.");
  for (auto id = order.ids.begin(); id != order.ids.end(); ++id)
    if (std::find(order.ids.begin(), id, *id) != id)
      return fail(FaultKind::text, fmt::format("--id {} is given twice.", *id), {},
                  "Give each controller on a line its own number.");
  if (catalog->addressed() && alone_on_its_line(order)) order.keys["unaddressed"] = "yes";
  return {};
}

// A board on a bus needs a bus port, a device on a line one of the other endpoints.
Result<> check_endpoints(const Order& order) {
  const auto catalog = order.type->make_catalog({});
  if (!catalog) return fail(catalog.error());
  const bool board = catalog->can.window;
  const std::string usual =
      board ? "Give --bus 127.0.0.1:5000." : "Give --tcp 127.0.0.1:4001 or --pty PATH, or both.";
  if (order.endpoints.empty())
    return fail(FaultKind::text, "No place to serve the emulator is named.", {}, usual);
  for (const auto& [kind, where] : order.endpoints) {
    if ((kind == "bus") != board)
      return fail(
          FaultKind::text,
          board ? fmt::format("The {} is a board on a bus: --{} cannot serve it.", catalog->short_name, kind)
                : fmt::format("The {} is not a board on a bus: --bus cannot serve it.", catalog->short_name),
          {}, usual);
    if (const auto place = split_host_port(where); kind != "pty" && !place)
      return fail(FaultKind::text, fmt::format("--{} {}: {}", kind, where, place.error().what), {},
                  fmt::format("Give a port too, as --{} 127.0.0.1:{}; port 0 takes any free one.", kind,
                              board ? 5000 : 4001));
  }
  return {};
}

// Turns the options of the command line into keys of an emulator's address.
Result<Order> understand(const Given& given) {
  Order order{find_device_type(given.words[0]), {}, given.all("id"), {}, given.has("allow-remote")};
  for (const auto& option : given.in_order)
    if (option.first == "tcp" || option.first == "pty" || option.first == "bus")
      order.endpoints.push_back(option);
  if (!order.type) return fail(unknown_model(given.words[0]));
  if (auto fit = check_endpoints(order); !fit) return fail(fit.error());
  for (const char* key : {"motors", "variant", "jumpers", "speed", "state", "bench"})
    if (given.has(key)) order.keys[key] = given.one(key);
  order.keys["wire"] = given.one("wire", given.has("pty") ? "real" : "off");
  std::string quirks;
  for (const std::string& quirk : given.all("quirk")) quirks += (quirks.empty() ? "" : "+") + quirk;
  if (!quirks.empty()) order.keys["quirk"] = quirks;
  if (auto understood = understand_ids(order); !understood) return fail(understood.error());
  return order;
}

void print_ready(const DeviceType& type, const char* kind, std::string_view where) {
  print_result("ready {} {} {}\n", type.model, kind, where);
}

Result<std::unique_ptr<TcpEndpoint>> serve_tcp(Scheduler& scheduler, const Order& order,
                                               const std::shared_ptr<EmulatorHost>& host,
                                               const std::string& kind, const std::string& where) {
  auto endpoint = TcpEndpoint::open(scheduler, where, order.allow_remote,
                                    [host, bus = kind == "bus"](std::unique_ptr<Stream> client) {
                                      if (bus)
                                        host->attach_bus(std::move(client));
                                      else
                                        host->attach(std::move(client));
                                    });
  if (endpoint) print_ready(*order.type, kind.c_str(), (*endpoint)->address());
  return endpoint;
}

Result<> serve_pty(Scheduler& scheduler, const Order& order, EmulatorHost& host, const std::string& path) {
  auto stream = open_pty_endpoint(scheduler, path, host.bench()->emulator().rate());
  if (!stream) return fail(stream.error());
  host.attach(std::move(*stream));
  print_ready(*order.type, "pty", path);
  return {};
}

// Warns of --state for a model that keeps nothing without power.
void warn_of_empty_memory(const Order& order) {
  const auto catalog = order.type->make_catalog({});
  if (!order.keys.contains("state") || !catalog || catalog->can.store) return;
  log::warning("emulate", fmt::format("The {} keeps nothing without power, so {} stays empty.",
                                      catalog->short_name, order.keys.at("state")));
}

Task<int> serve(Scheduler& scheduler, const Order& order) {
  OpenOptions options;
  options.trouble = [](const Fault& fault) { log::error("emulate", fault.sentence()); };
  warn_of_empty_memory(order);
  auto host = make_emulator_host(scheduler, *order.type, order.keys, order.ids, options);
  if (!host) co_return complain(host.error(), status_of(host.error()));

  Event ended(scheduler);
  Interruption interruption(scheduler, [&ended](int) { ended.notify(); });
  std::vector<std::unique_ptr<TcpEndpoint>> listening;
  for (const auto& [kind, where] : order.endpoints) {
    if (kind == "pty") {
      if (auto served = serve_pty(scheduler, order, **host, where); !served)
        co_return complain(served.error());
      continue;
    }
    auto endpoint = serve_tcp(scheduler, order, *host, kind, where);
    if (!endpoint) co_return complain(endpoint.error(), status_of(endpoint.error()));
    listening.push_back(std::move(*endpoint));
  }
  if (!output_is_lost()) co_await ended.wait();  // without the output the user does not know where to connect
  co_return done;
}

}  // namespace

static int emulate(const Given& given) {
  const auto order = understand(given);
  if (!order) return complain(order.error(), usage);
  return run_here([&](Scheduler& scheduler) { return serve(scheduler, *order); });
}

const Subcommand emulate_subcommand{
    "emulate",
    "serve an emulated controller to other programs until interrupted",
    {{"MODEL", "the controller", 1, 1}},
    {{"tcp", "HOST:PORT", "listen there; port 0: any free one", true},
     {"bus", "HOST:PORT", "serve the bus of a board there (vme58); port 0: any free one", true},
     {"pty", "PATH", "make a pseudo-terminal and this symlink to it", true},
     {"id", "NN", "number on its line, two digits; several: that many controllers on one line", true},
     {"motors", "N", "number of motors; 3 or 4: a Master with its Slave linked"},
     variant_option,
     jumpers_option,
     {"speed", "X", "speed relative to real time (default 1)"},
     {"wire", "real|off", "simulate the byte times of the baud rate (default: real with a --pty, else off)"},
     {"quirk", "NAME", "a quirk of some units, such as overrun or e-bar (vxm), padded (vme58)", true},
     {"state", "FILE", "file for the non-volatile memory; with several --id, FILE.NN of each"},
     {"bench", "FILE.toml",
      "bench of the controller (without it a VXM has limit switches at -100000 and 100000 steps)"},
     {"allow-remote", "", "let other hosts connect (else only this one)"}},
    emulate,
};

}  // namespace hw::app
