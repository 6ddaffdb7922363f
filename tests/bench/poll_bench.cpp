// One poll through the whole stack against the least that a round trip can cost: the same question to the
// same responder from plain C and from a bare coroutine. Compare the three in one run.
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/bench/responder.h"
#include "tests/bench/stack.h"

namespace hw {
namespace {

void raw_c(benchmark::State& state) {
  Responder responder;
  const int s = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  there.sin_port = htons(static_cast<std::uint16_t>(responder.port()));
  if (connect(s, reinterpret_cast<sockaddr*>(&there), sizeof there) != 0)
    return state.SkipWithError("no responder");
  const int on = 1;
  setsockopt(s, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  char reply[16];
  if (write(s, "F", 1) != 1) return state.SkipWithError("no responder");
  for (auto _ : state) {
    if (write(s, "X", 1) != 1) break;
    for (ssize_t got = 0; got < 9;) got += read(s, reply + got, sizeof reply - got);
  }
  close(s);
}
BENCHMARK(raw_c)->UseRealTime();

using TcpSocket = asio::basic_stream_socket<asio::ip::tcp, Executor>;

Task<> ask_forever(TcpSocket& socket, long& rounds, const bool& over) {
  char reply[16];
  const auto question = asio::buffer("X", 1);
  const auto answer = asio::buffer(reply, 9);
  while (!over) {
    co_await asio::async_write(socket, question, use_task);
    co_await asio::async_read(socket, answer, use_task);
    ++rounds;
  }
}

void bare_asio_coroutine(benchmark::State& state) {
  Responder responder;
  IoContext io(1);
  TcpSocket socket(io.get_executor());
  socket.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(responder.port())});
  socket.set_option(asio::ip::tcp::no_delay(true));
  long rounds = 0;
  bool over = false;
  asio::write(socket, asio::buffer("F", 1));
  asio::co_spawn(io, ask_forever(socket, rounds, over), asio::detached);
  for (auto _ : state) {
    const long before = rounds;
    while (rounds == before) io.run_one();
  }
  over = true;
  socket.close();
  io.run();
}
BENCHMARK(bare_asio_coroutine)->UseRealTime();

void whole_stack(benchmark::State& state) {
  Responder responder;
  IoContext io(1);
  Stack stack(io, "vxm@tcp:127.0.0.1:" + std::to_string(responder.port()));
  const auto& transactions = stack.station->statistics().transactions;
  for (auto _ : state) {
    const auto before = transactions;
    while (transactions == before && !stack.ended) io.run_one();
  }
  if (stack.ended) state.SkipWithError(stack.trouble.c_str());
}
BENCHMARK(whole_stack)->UseRealTime();

}  // namespace
}  // namespace hw
