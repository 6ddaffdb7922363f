#include "transports/tcp_endpoint.h"

#include <fmt/core.h>

#include "core/session/address.h"
#include "transports/tcp.h"
#include "transports/tcp_socket.h"

namespace hw {
namespace {

using namespace tcp;

using Acceptor = asio::basic_socket_acceptor<Tcp, Executor>;

std::string text(const Tcp::endpoint& at) {
  const std::string host = at.address().to_string();
  return at.address().is_v6() ? fmt::format("[{}]:{}", host, at.port())
                              : fmt::format("{}:{}", host, at.port());
}

struct Listening : std::enable_shared_from_this<Listening> {
  Scheduler& scheduler;
  Acceptor acceptor;
  TcpEndpoint::Accepted accepted;
  Timer again;  // retries when no descriptor is left

  Listening(Scheduler& s, TcpEndpoint::Accepted a)
      : scheduler(s), acceptor(s.executor()), accepted(std::move(a)), again(s, [this] { accept(); }) {}

  void accept() {
    acceptor.async_accept([self = shared_from_this()](Error error, Socket socket) {
      if (!self->acceptor.is_open()) return;
      if (error) return self->again.arm(self->scheduler.now() + Millis(100));
      self->take(std::move(socket));
      if (self->acceptor.is_open()) self->accept();
    });
  }
  void take(Socket socket) {
    Error error;
    socket.set_option(Tcp::no_delay(true), error);
    const Tcp::endpoint peer = socket.remote_endpoint(error);
    if (error) return;  // the connection has closed already
    const int fd = socket.release(error);
    if (!error) accepted(make_tcp_stream(scheduler, fd, text(peer)));
  }
};

class Endpoint final : public TcpEndpoint {
 public:
  explicit Endpoint(std::shared_ptr<Listening> listening) : listening_(std::move(listening)) {}
  ~Endpoint() override {
    Error ignored;
    listening_->again.disarm();
    listening_->acceptor.close(ignored);
  }
  [[nodiscard]] std::string address() const override {
    Error ignored;
    return text(listening_->acceptor.local_endpoint(ignored));
  }

 private:
  std::shared_ptr<Listening> listening_;
};

Result<Tcp::endpoint> find_place(Scheduler& scheduler, const std::string& where) {
  const auto place = split_host_port(where);
  if (!place) return fail(place.error());
  Error error;
  asio::ip::basic_resolver<Tcp, Executor> resolver(scheduler.executor());
  const auto found = resolver.resolve(place->first, std::to_string(place->second), error);
  if (error || found.empty())
    return fail(FaultKind::port,
                fmt::format("{} is not an address of this machine: {}.", place->first, error.message()),
                "Nothing is served.", "Use 127.0.0.1 or localhost.");
  for (const auto& entry : found)
    if (entry.endpoint().address().is_v4()) return entry.endpoint();
  return found.begin()->endpoint();
}

Error start_listening(Acceptor& acceptor, const Tcp::endpoint& at) {
  Error error;
  acceptor.open(at.protocol(), error);
  if (!error) acceptor.set_option(Acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(at, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  return error;
}

}  // namespace

Result<std::unique_ptr<TcpEndpoint>> TcpEndpoint::open(Scheduler& scheduler, const std::string& where,
                                                       bool allow_remote, Accepted accepted) {
  const auto at = find_place(scheduler, where);
  if (!at) return fail(at.error());
  if (!allow_remote && !at->address().is_loopback())
    return fail(FaultKind::refused, fmt::format("{} would admit other machines.", where),
                "Nothing is served.", "Use 127.0.0.1, or add --allow-remote.");
  auto listening = std::make_shared<Listening>(scheduler, std::move(accepted));
  if (const Error error = start_listening(listening->acceptor, *at)) {
    const bool taken = error == asio::error::address_in_use;
    return fail(
        FaultKind::port,
        fmt::format("Cannot listen on {}: {}.", where, taken ? "another program does" : error.message()),
        "Nothing is served.", taken ? "Choose another port; 0 takes any free one." : "");
  }
  listening->accept();
  return std::make_unique<Endpoint>(std::move(listening));
}

}  // namespace hw
