#include "transports/rfc2217.h"

#include <algorithm>
#include <functional>

#include <fmt/core.h>

#include "transports/fd_stream.h"
#include "transports/tcp.h"
#include "transports/telnet.h"

namespace hw {
namespace {

class Rfc2217Stream final : public FdStream {
 public:
  Rfc2217Stream(Scheduler& scheduler, int socket, std::string server, int baud)
      : FdStream(scheduler, socket, Kind::socket), server_(std::move(server)), baud_(baud) {}

  void send(std::string_view bytes) override {
    if (bytes.find(static_cast<char>(telnet::iac)) == bytes.npos) return FdStream::send(bytes);
    wire_.clear();
    telnet::escape(bytes, wire_);
    FdStream::send(wire_);
  }
  // The request is sent after all earlier bytes. If the server confirms another rate, the stream ends.
  Result<> set_rate(int baud) override {
    if (baud == baud_) return {};
    baud_ = baud;
    ++unanswered_rates_;
    wire_.clear();
    telnet::ask_rate(baud, wire_);
    FdStream::send(wire_);
    return {};
  }
  [[nodiscard]] int rate() const override { return baud_; }
  [[nodiscard]] std::string describe() const override {
    return fmt::format("rfc2217:{}, {} baud", server_, baud_);
  }

  void send_as_is(std::string_view wire) { FdStream::send(wire); }
  [[nodiscard]] const telnet::ServerWord& word() const { return receiver_.word(); }
  [[nodiscard]] Fault wrong_rate() const {
    return Fault(FaultKind::port,
                 fmt::format("{} does not accept {} baud (it uses {}).", server_, baud_, *word().baud),
                 "The connection was closed.", "Choose another rate, or set the port of the server.");
  }
  std::function<void()> negotiated;  ///< called when the server has confirmed the settings of its port

 private:
  void received(std::string_view bytes) override {
    data_.clear();
    reply_.clear();
    const int before = word().rates;
    receiver_.take(bytes, data_, reply_);
    const int replies = word().rates - before;
    if (!reply_.empty()) FdStream::send(reply_);
    if (negotiated) {
      negotiated();
    } else if (replies > 0) {  // only the last reply answers the last request
      unanswered_rates_ = std::max(0, unanswered_rates_ - replies);
      if (unanswered_rates_ == 0 && word().baud != baud_) end_soon(wrong_rate());
    }
    if (!data_.empty()) deliver(data_);
  }
  [[nodiscard]] Fault why_ended(int error) const override { return tcp_ended(server_, error); }

  std::string server_;
  int baud_;
  int unanswered_rates_ = 0;  ///< set_rate() requests without a reply yet
  telnet::Receiver receiver_;
  std::string wire_, data_, reply_;  // keep their capacity
};

/// Notices the end of the stream while the settings are negotiated.
struct CloseListener final : Stream::Listener {
  std::optional<Fault> closed;
  std::function<void()> news;
  void bytes_arrived(std::string_view) override {}
  void stream_closed(const Fault& why) override {
    closed = why;
    news();
  }
};

Fault no_rfc2217(const std::string& where) {
  return Fault(FaultKind::port, fmt::format("{} does not speak RFC 2217.", where),
               "The connection was closed.",
               fmt::format("Use tcp:{} and set the rate in the server, or switch RFC 2217 on there.", where));
}

std::optional<Fault> check(const Rfc2217Stream& stream, const std::string& where, int baud) {
  const telnet::ServerWord& word = stream.word();
  if (!word.com_port.value_or(false)) return no_rfc2217(where);
  if (!word.settings_complete())
    return Fault(FaultKind::port, fmt::format("{} did not confirm the settings of its port in time.", where),
                 "The connection was closed.", "Check whether another program uses its serial port.");
  if (*word.baud != baud) return stream.wrong_rate();
  if (*word.datasize != 8 || *word.parity != 1 || *word.stopsize != 1)
    return Fault(FaultKind::port,
                 fmt::format("{} does not set its port to 8 data bits, no parity, 1 stop bit.", where),
                 "The connection was closed.", "Set the port of the server.");
  return std::nullopt;
}

}  // namespace

Task<Result<std::unique_ptr<Stream>>> open_rfc2217(Scheduler& scheduler, std::string where, int baud,
                                                   Duration patience) {
  const auto socket = co_await connect_tcp(scheduler, where, patience);
  if (!socket) co_return fail(socket.error());
  auto stream = std::make_unique<Rfc2217Stream>(scheduler, *socket, where, baud);
  Event news(scheduler);
  CloseListener attendant;
  attendant.news = stream->negotiated = [&news] { news.notify(); };
  stream->listen(&attendant);

  const Instant deadline = scheduler.now() + patience;
  stream->send_as_is(telnet::offer());
  while (!stream->word().com_port && !attendant.closed)
    if (!co_await news.wait_until(deadline)) break;
  if (stream->word().com_port.value_or(false)) stream->send_as_is(telnet::ask_settings(baud));
  while (stream->word().com_port.value_or(false) && !stream->word().settings_complete() && !attendant.closed)
    if (!co_await news.wait_until(deadline)) break;

  stream->listen(nullptr);
  stream->negotiated = nullptr;
  if (attendant.closed) co_return fail(*attendant.closed);
  if (const auto fault = check(*stream, where, baud)) co_return fail(*fault);
  co_return stream;
}

}  // namespace hw
