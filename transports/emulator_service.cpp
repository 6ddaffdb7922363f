#include "transports/emulator_service.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "transports/open.h"
#include "transports/pty_endpoint.h"
#include "transports/tcp_endpoint.h"

namespace hw {

class ServedStream;

/// The connected clients. The host owns the streams of the clients, which are notified when the service ends.
struct EmulatorService::ServedStreams {
  std::vector<ServedStream*> all;
  std::function<void(int)> changed;
  int by_tcp = 0;

  void count(int more) {
    by_tcp += more;
    if (changed) changed(by_tcp);
  }
};

/// Forwards a client's bytes in both directions.
class ServedStream final : public Stream, private Stream::Listener {
 public:
  ServedStream(std::shared_ptr<EmulatorService::ServedStreams> streams, std::unique_ptr<Stream> inner,
               bool counts)
      : streams_(std::move(streams)), inner_(std::move(inner)), counts_(counts) {
    streams_->all.push_back(this);
    if (counts_) streams_->count(1);
  }
  ~ServedStream() override {
    std::erase(streams_->all, this);
    if (counts_) streams_->count(-1);
  }
  /// The host releases the stream; *this no longer exists afterwards.
  void leave() {
    if (listener_) listener_->stream_closed(Fault(FaultKind::lost, "The emulator is no longer served."));
  }
  void listen(Stream::Listener* listener) override {
    listener_ = listener;
    inner_->listen(listener ? this : nullptr);
  }
  void send(std::string_view bytes) override { inner_->send(bytes); }
  void discard_unsent() override { inner_->discard_unsent(); }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void bytes_arrived(std::string_view bytes) override {
    if (listener_) listener_->bytes_arrived(bytes);
  }
  void stream_closed(const Fault& why) override {
    if (listener_) listener_->stream_closed(why);
  }

  std::shared_ptr<EmulatorService::ServedStreams> streams_;
  std::unique_ptr<Stream> inner_;
  const bool counts_;
  Stream::Listener* listener_ = nullptr;
};

EmulatorService::EmulatorService(std::shared_ptr<EmulatorHost> host, std::shared_ptr<ServedStreams> streams)
    : host_(std::move(host)), streams_(std::move(streams)) {}

EmulatorService::~EmulatorService() {
  endpoint_.reset();
  streams_->changed = nullptr;
  while (!streams_->all.empty()) {
    ServedStream* served = streams_->all.back();
    served->leave();
    std::erase(streams_->all, served);  // a stream without a listener is destroyed later
  }
}

std::string EmulatorService::address() const { return endpoint_->address(); }

Result<std::unique_ptr<EmulatorService>> EmulatorService::start(Scheduler& scheduler,
                                                                std::shared_ptr<EmulatorHost> host,
                                                                const Place& place,
                                                                std::function<void(int)> clients_changed) {
  auto streams = std::make_shared<ServedStreams>();
  streams->changed = std::move(clients_changed);
  std::unique_ptr<EmulatorService> service(new EmulatorService(std::move(host), streams));
  const auto accept = [host = service->host_, streams](std::unique_ptr<Stream> client) {
    auto served = std::make_unique<ServedStream>(streams, std::move(client), true);
    host->is_board() ? host->attach_bus(std::move(served)) : host->attach(std::move(served));
  };
  const auto listen = [&](int port) {
    return TcpEndpoint::open(scheduler, fmt::format("127.0.0.1:{}", port), false, accept);
  };
  auto endpoint = listen(place.port);
  if (!endpoint && place.port != 0) endpoint = listen(0);
  if (!endpoint) return fail(endpoint.error());
  service->endpoint_ = std::move(*endpoint);
  if (place.terminal.empty() || service->host_->is_board()) return service;
  auto terminal = open_pty_endpoint(scheduler, place.terminal, service->host_->bench()->emulator().rate());
  if (!terminal) return fail(terminal.error());
  service->terminal_ = place.terminal;
  service->host_->attach(std::make_unique<ServedStream>(streams, std::move(*terminal), false));
  return service;
}

Result<std::shared_ptr<EmulatorHost>> make_private_host(Scheduler& scheduler, const Address& address) {
  const DeviceType* type = find_device_type(address.model);
  if (!type) return fail(unknown_model(address.model));
  DeviceOptions keys = address.options;
  keys.erase("id");
  const auto catalog = type->make_catalog({});
  if (catalog && catalog->addressed() && address.ids().size() <= 1) keys["unaddressed"] = "yes";
  return make_emulator_host(scheduler, *type, std::move(keys), address.ids(), {});
}

std::string terminal_for(const std::string& name) {
  const char* own = std::getenv("XDG_RUNTIME_DIR");
  std::error_code error;
  const std::filesystem::path folder =
      own && *own && ::access(own, W_OK) == 0 ? own : std::filesystem::temp_directory_path(error);
  return folder / fmt::format("handwheel-{}", name);
}

}  // namespace hw
