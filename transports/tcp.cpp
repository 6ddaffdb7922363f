#include "transports/tcp.h"

#include <boost/asio/redirect_error.hpp>
#include <cerrno>
#include <cstring>

#include <fmt/core.h>

#include "core/session/address.h"
#include "transports/fd_stream.h"
#include "transports/gone.h"
#include "transports/tcp_socket.h"

namespace hw {
namespace {

using namespace tcp;

using Resolver = asio::ip::basic_resolver<Tcp, Executor>;

class TcpStream final : public FdStream {
 public:
  TcpStream(Scheduler& scheduler, int socket, std::string peer)
      : FdStream(scheduler, socket, Kind::socket), peer_(std::move(peer)) {}
  Result<> set_rate(int) override { return {}; }
  [[nodiscard]] int rate() const override { return 0; }
  [[nodiscard]] std::string describe() const override { return "tcp:" + peer_; }

 private:
  [[nodiscard]] Fault why_ended(int error) const override { return tcp_ended(peer_, error); }
  std::string peer_;
};

Fault cannot_connect(const std::string& where, const Error& error) {
  std::string what = fmt::format("No connection to {}: ", where);
  std::string advice = "Check the address, the cable and that the device is switched on.";
  if (error == asio::error::connection_refused) {
    what += "nothing listens on that port.";
    advice = "Check the port number, and that the server or the device's network interface is running.";
  } else if (error == asio::error::operation_aborted || error == asio::error::timed_out) {
    what += "no answer in time.";
  } else if (error == asio::error::host_not_found || error == asio::error::no_data) {
    what += "no host has that name.";
    advice = "Check the name, or give the number (192.168.1.40).";
  } else {
    what += error.message() + ".";
  }
  return Fault(FaultKind::port, std::move(what), "Nothing was sent.", std::move(advice));
}

Task<Result<std::vector<Tcp::endpoint>>> look_up(Scheduler& scheduler, std::string where, Duration patience) {
  const auto place = split_host_port(where);
  if (!place) co_return fail(place.error());
  Error error;
  std::vector<Tcp::endpoint> found;
  const auto number = asio::ip::make_address(place->first, error);
  if (!error) {
    found.emplace_back(number, static_cast<unsigned short>(place->second));
    co_return found;
  }
  Resolver resolver(scheduler.executor());
  Timer deadline(scheduler, [&resolver] { resolver.cancel(); });
  deadline.arm(scheduler.now() + patience);
  const std::string port = std::to_string(place->second);
  auto token = asio::redirect_error(use_task, error);
  const auto results = co_await resolver.async_resolve(place->first, port, token);
  if (error) co_return fail(cannot_connect(where, error));
  for (const auto& entry : results) found.push_back(entry.endpoint());
  co_return found;
}

}  // namespace

Fault tcp_ended(const std::string& where, int error) {
  const std::string reason = error == 0            ? "The other side closed the connection"
                             : error == ECONNRESET ? "The other side reset the connection"
                             : error == EPIPE
                                 ? "The other side closed the connection"
                                 : fmt::format("The connection failed ({})", std::strerror(error));
  return gone(fmt::format("{} ({}).", reason, where),
              "Check the network and the device. The console keeps trying.");
}

Task<Result<int>> connect_tcp(Scheduler& scheduler, std::string where, Duration patience) {
  const auto endpoints = co_await look_up(scheduler, where, patience);
  if (!endpoints) co_return fail(endpoints.error());
  Error error = asio::error::host_not_found;
  for (const Tcp::endpoint& endpoint : *endpoints) {
    Socket socket(scheduler.executor());
    Timer deadline(scheduler, [&socket] {
      Error ignored;
      socket.close(ignored);
    });
    deadline.arm(scheduler.now() + patience);
    error = {};
    auto token = asio::redirect_error(use_task, error);
    co_await socket.async_connect(endpoint, token);
    deadline.disarm();
    if (error) continue;
    socket.set_option(Tcp::no_delay(true), error);
    if (!error) co_return socket.release();
  }
  co_return fail(cannot_connect(where, error));
}

Task<Result<std::unique_ptr<Stream>>> open_tcp(Scheduler& scheduler, std::string where, Duration patience) {
  const auto socket = co_await connect_tcp(scheduler, where, patience);
  if (!socket) co_return fail(socket.error());
  co_return make_tcp_stream(scheduler, *socket, where);
}

std::unique_ptr<Stream> make_tcp_stream(Scheduler& scheduler, int socket, std::string peer) {
  return std::make_unique<TcpStream>(scheduler, socket, std::move(peer));
}

}  // namespace hw
