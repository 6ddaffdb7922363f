#include "transports/bus_port.h"

#include <algorithm>

#include <fmt/core.h>
#include <sys/socket.h>

#include "core/emulation/bus_target.h"
#include "transports/gone.h"
#include "transports/tcp.h"

namespace hw {
namespace {

constexpr char write_bit = '\x80';
constexpr std::size_t head_bytes = 3;

std::size_t width_of(char op) { return static_cast<unsigned char>(op) & 0x7Fu; }
bool is_op(char op) {
  const std::size_t width = width_of(op);
  return width == 1 || width == 2 || width == 4;
}

void put(std::string& bytes, std::uint32_t value, std::size_t width) {
  for (std::size_t i = width; i-- > 0;) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
}
std::uint32_t number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

/// The peer's raw socket address; empty: not connected.
std::string peer_of(int socket) {
  sockaddr_storage peer{};
  socklen_t length = sizeof peer;
  if (::getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &length) != 0) return {};
  return {reinterpret_cast<const char*>(&peer), length};
}

class BusPort final : public Window, private Stream::Listener {
 public:
  BusPort(Scheduler& scheduler, std::unique_ptr<Stream> stream, std::string where)
      : scheduler_(scheduler),
        stream_(std::move(stream)),
        where_(std::move(where)),
        deadline_(scheduler, [this] { give_up(); }) {
    stream_->listen(this);
  }
  ~BusPort() override {
    if (stream_) stream_->listen(nullptr);
  }

  void listen(Window::Listener* listener) override { listener_ = listener; }
  // The watchdog dials a connection of its own. On this connection its bytes could be taken for the rest of a
  // message that was cut short.
  [[nodiscard]] WireShare share() const override {
    WireShare share = stream_ ? stream_->share() : WireShare();
    if (share.how != WireShare::How::bytes) return {};
    share.place = peer_of(share.fd);
    share.how = share.place.empty() ? WireShare::How::none : WireShare::How::dial;
    share.fd = -1;
    return share;
  }
  [[nodiscard]] std::string describe() const override { return "bus port " + where_; }

  Task<Result<>> run(std::span<BusCycle> cycles) override {
    if (!stream_) co_return fail(gone_);
    expected_ = 0;
    messages_.clear();
    for (const BusCycle& cycle : cycles) add_message(cycle);
    received_.clear();
    stream_->send(messages_);
    if (expected_ > 0) deadline_.arm(scheduler_.now() + longest_silence);
    while (stream_ && received_.size() < expected_) co_await answered_.here();
    deadline_.disarm();
    if (received_.size() < expected_) co_return fail(gone_);
    std::string_view rest = received_;
    for (BusCycle& cycle : cycles) {
      if (cycle.write) continue;
      cycle.value = number(rest.substr(0, cycle.width));
      rest.remove_prefix(cycle.width);
    }
    co_return Result<>();
  }

  void abandon() override { close(Fault(FaultKind::lost, "The bus port was closed.")); }

 private:
  static constexpr Duration longest_silence = Millis(2000);

  void add_message(const BusCycle& cycle) {
    append_bus_message(messages_, cycle);
    if (!cycle.write) expected_ += cycle.width;
  }

  void bytes_arrived(std::string_view bytes) override {
    if (received_.size() >= expected_) return;  // unsolicited
    received_ += bytes;
    deadline_.arm(scheduler_.now() + longest_silence);
    if (received_.size() >= expected_) answered_.resume(scheduler_.executor());
  }
  void stream_closed(const Fault& why) override { end(why); }

  // A later byte could not be assigned to a reply, so a new connection is needed.
  void give_up() {
    end(gone(fmt::format("The bus port {} has not answered for {:.0f} s.", where_, seconds(longest_silence)),
             "Check the program that serves the port. The console keeps trying."));
  }
  void close(Fault why) {
    if (!stream_) return;
    gone_ = std::move(why);
    stream_->listen(nullptr);
    // A stream must not be destroyed inside its own call.
    asio::post(scheduler_.executor(), [gone = std::shared_ptr<Stream>(std::move(stream_))] {});
    deadline_.disarm();
    answered_.resume(scheduler_.executor());
  }
  void end(const Fault& why) {
    close(why);
    if (listener_) listener_->window_closed(gone_);
  }

  Scheduler& scheduler_;
  std::unique_ptr<Stream> stream_;  ///< null: the connection is lost
  std::string where_;
  Window::Listener* listener_ = nullptr;
  std::string messages_, received_;  // both keep their capacity
  std::size_t expected_ = 0;
  Suspended answered_;
  Timer deadline_;
  Fault gone_;
};

}  // namespace

void append_bus_message(std::string& bytes, const BusCycle& cycle) {
  bytes += static_cast<char>(cycle.width | (cycle.write ? write_bit : 0));
  put(bytes, cycle.offset, 2);
  if (cycle.write) put(bytes, cycle.value, cycle.width);
}

std::unique_ptr<Window> make_bus_port(Scheduler& scheduler, std::unique_ptr<Stream> stream,
                                      std::string where) {
  return std::make_unique<BusPort>(scheduler, std::move(stream), std::move(where));
}

Task<Result<std::unique_ptr<Window>>> open_bus_port(Scheduler& scheduler, std::string where,
                                                    Duration patience) {
  auto stream = co_await open_tcp(scheduler, where, patience);
  if (!stream) co_return fail(stream.error());
  co_return make_bus_port(scheduler, std::move(*stream), std::move(where));
}

Result<> BusPortTalk::take(std::string_view bytes, const std::function<void(BusCycle&)>& perform,
                           std::string& answers) {
  unfinished_ += bytes;
  std::size_t done = 0;
  while (done < unfinished_.size()) {
    const char op = unfinished_[done];
    if (!is_op(op))
      return fail(FaultKind::garbled,
                  fmt::format("A client of the bus port sent {:02X} instead of an operation.",
                              static_cast<unsigned char>(op)),
                  "Its connection was closed.",
                  "01, 02 and 04 read that many bytes; 81, 82 and 84 write them.");
    const bool write = (op & write_bit) != 0;
    const std::size_t width = width_of(op), length = head_bytes + (write ? width : 0);
    if (unfinished_.size() - done < length) break;
    const std::string_view message = std::string_view(unfinished_).substr(done, length);
    const auto offset = static_cast<std::uint16_t>(number(message.substr(1, 2)));
    const std::size_t begin = width == 1 ? offset : offset & ~std::size_t{1};
    if (begin + width > bus_window_bytes)
      return fail(FaultKind::garbled,
                  fmt::format("A client of the bus port {} {} {} at 0x{:X}, which lies beyond the window.",
                              write ? "wrote" : "asked for", width, width == 1 ? "byte" : "bytes", offset),
                  "Its connection was closed.",
                  fmt::format("The window ends at 0x{:X}.", bus_window_bytes - 1));
    const auto bytes_wide = static_cast<std::uint8_t>(width);
    BusCycle cycle = write ? BusCycle::store(bytes_wide, offset, number(message.substr(head_bytes)))
                           : BusCycle::read(bytes_wide, offset);
    perform(cycle);
    if (!write) put(answers, cycle.value, width);
    done += length;
  }
  unfinished_.erase(0, done);
  return {};
}

}  // namespace hw
