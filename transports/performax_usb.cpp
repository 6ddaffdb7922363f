#include "transports/performax_usb.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <libusb-1.0/libusb.h>
#include <unistd.h>

#include "transports/gone.h"
#include "transports/sysfs.h"
#include "transports/usb_loop.h"

namespace hw {

const char* const udev_advice =
    "Install the udev rule that comes with Handwheel: copy assets/udev/70-handwheel.rules to "
    "/etc/udev/rules.d, "
    "run \"udevadm control --reload\" as root, and plug the controller in again.";

namespace {

namespace fs = std::filesystem;

// WIRE-FACTS about the maker's library.
constexpr int vendor = 0x1589, product = 0xA101;
constexpr int configuration = 1, interface = 0;
constexpr unsigned char endpoint_out = 0x02, endpoint_in = 0x82;
constexpr std::size_t transfer_size = 64;
constexpr std::uint8_t request_type = 0x40, request = 0x02;
enum Control : std::uint16_t { control_flush = 1, control_open = 2, control_close = 4 };

constexpr unsigned patience_ms = 500;  // time for a control transfer, and for sending a command
constexpr unsigned drain_ms = 40;

struct FreeTransfer {
  void operator()(libusb_transfer* t) const { libusb_free_transfer(t); }
};
using Transfer = std::unique_ptr<libusb_transfer, FreeTransfer>;

}  // namespace

// An open controller: its transfers and a clean close. The handlers of pending transfers keep this object
// alive.
struct PerformaxWire : std::enable_shared_from_this<PerformaxWire> {
  Scheduler& scheduler;
  std::unique_ptr<UsbLoop> loop;
  std::string name;  // "USB 4ex00"
  libusb_device_handle* handle = nullptr;
  int file = -1;  // the library's descriptor, for the watchdog; -1: not found
  std::function<void(std::string_view)> received;
  std::function<void(const Fault&)> ended;

  explicit PerformaxWire(Scheduler& s) : scheduler(s), moved(s) {}
  ~PerformaxWire() {
    closing = true;
    if (loop && busy()) {
      cancel();
      loop->run_until([this] { return !busy(); }, Millis(1000));
    }
    close_handle();
  }
  void close_handle() {
    if (!handle) return;
    libusb_release_interface(handle, interface);
    libusb_close(std::exchange(handle, nullptr));
  }

  /// A pending transfer.
  struct PendingTransfer {
    Transfer transfer{libusb_alloc_transfer(0)};
    std::array<unsigned char, LIBUSB_CONTROL_SETUP_SIZE + transfer_size> bytes{};
    bool under_way = false;
    PerformaxWire* wire = nullptr;
    void (PerformaxWire::*done)() = nullptr;
  };
  PendingTransfer control_, out_, in_;
  Event moved;
  std::deque<std::string> waiting;
  bool closing = false, reading = false, over = false;
  int submitted = LIBUSB_SUCCESS;  ///< result of the latest submit()

  [[nodiscard]] bool busy() const { return control_.under_way || out_.under_way || in_.under_way; }
  void cancel() {
    for (PendingTransfer* u : {&control_, &out_, &in_})
      if (u->under_way) libusb_cancel_transfer(u->transfer.get());
  }

  static void LIBUSB_CALL finished(libusb_transfer* transfer) {
    auto& under = *static_cast<PendingTransfer*>(transfer->user_data);
    under.under_way = false;
    PerformaxWire& wire = *under.wire;
    if (wire.weak_from_this().expired()) return;  // during destruction
    const auto keep = wire.shared_from_this();
    if (under.done && !wire.closing) (wire.*under.done)();
    wire.moved.notify();
  }
  bool submit(PendingTransfer& under) {
    under.wire = this;
    submitted = libusb_submit_transfer(under.transfer.get());
    under.under_way = submitted == LIBUSB_SUCCESS;
    return under.under_way;
  }

  [[nodiscard]] const char* why_not_submitted() const {
    return submitted == LIBUSB_ERROR_NO_DEVICE ? "it is no longer connected"
                                               : "it does not accept transfers any more";
  }

  Task<bool> control(std::uint16_t value) {
    const auto self = shared_from_this();
    libusb_fill_control_setup(control_.bytes.data(), request_type, request, value, 0, 0);
    libusb_fill_control_transfer(control_.transfer.get(), handle, control_.bytes.data(), finished, &control_,
                                 patience_ms);
    if (!submit(control_)) co_return false;
    while (control_.under_way) co_await moved.wait();
    co_return control_.transfer->status == LIBUSB_TRANSFER_COMPLETED;
  }
  // Discards replies to earlier questions that were not fetched.
  Task<> drain() {
    const auto self = shared_from_this();
    for (bool more = true; more;) {
      libusb_fill_bulk_transfer(in_.transfer.get(), handle, endpoint_in, in_.bytes.data(), transfer_size,
                                finished, &in_, drain_ms);
      if (!submit(in_)) co_return;
      while (in_.under_way) co_await moved.wait();
      more = in_.transfer->status == LIBUSB_TRANSFER_COMPLETED;
    }
  }

  void read() {
    if (std::exchange(reading, true)) return;
    in_.done = &PerformaxWire::reply_came;
    read_next();
  }
  void read_next() {
    libusb_fill_bulk_transfer(in_.transfer.get(), handle, endpoint_in, in_.bytes.data(), transfer_size,
                              finished, &in_, 0);
    if (!submit(in_)) end_soon(why_not_submitted());
  }
  // A reply includes its closing zero. A transfer without it was cut off, and half a number must not be taken
  // for a whole number.
  void reply_came() {
    const auto status = in_.transfer->status;
    if (status == LIBUSB_TRANSFER_COMPLETED) {
      const auto* text = reinterpret_cast<const char*>(in_.bytes.data());
      const auto length = static_cast<std::size_t>(in_.transfer->actual_length);
      const auto zero = static_cast<std::size_t>(std::find(text, text + length, '\0') - text);
      const std::string reply(text, std::min(zero + 1, length));
      read_next();
      if (!reply.empty() && received) received(reply);
    } else if (status == LIBUSB_TRANSFER_STALL || status == LIBUSB_TRANSFER_OVERFLOW) {
      read_next();
    } else if (status != LIBUSB_TRANSFER_CANCELLED) {
      end_soon("it was unplugged");
    }
  }

  void send(std::string_view text) {
    waiting.emplace_back(text.substr(0, transfer_size - 1));
    if (!out_.under_way) write_next();
  }
  void write_next() {
    if (waiting.empty() || over) return;
    out_.bytes.fill(0);
    std::copy(waiting.front().begin(), waiting.front().end(), out_.bytes.begin());
    waiting.pop_front();
    out_.done = &PerformaxWire::written;
    libusb_fill_bulk_transfer(out_.transfer.get(), handle, endpoint_out, out_.bytes.data(), transfer_size,
                              finished, &out_, patience_ms);
    if (!submit(out_)) end_soon(why_not_submitted());
  }
  void written() {
    if (out_.transfer->status == LIBUSB_TRANSFER_NO_DEVICE) return end_soon("it was unplugged");
    write_next();  // a text that was not sent is noticed by its missing reply
  }

  void end_soon(const char* why) {
    if (std::exchange(over, true)) return;
    Fault fault = gone(fmt::format("{} is gone: {}.", name, why), "Check its USB cable and its power.");
    asio::post(scheduler.executor(), [self = shared_from_this(), fault = std::move(fault)] {
      if (self->ended) self->ended(fault);
    });
  }

  // Without a listener: cancels pending transfers, sends the closing request, closes.
  static Task<> close(std::shared_ptr<PerformaxWire> wire) {
    wire->received = nullptr, wire->ended = nullptr;
    wire->closing = true;
    wire->cancel();
    while (wire->busy()) co_await wire->moved.wait();
    if (!wire->over) co_await wire->control(control_close);
    wire->close_handle();
  }
};

namespace {

class PerformaxStream final : public Stream {
 public:
  explicit PerformaxStream(std::shared_ptr<PerformaxWire> wire) : wire_(std::move(wire)) {}
  ~PerformaxStream() override {
    asio::co_spawn(wire_->scheduler.executor(), PerformaxWire::close(wire_), asio::detached);
  }
  void listen(Listener* listener) override {
    wire_->received = nullptr, wire_->ended = nullptr;
    if (!listener) return;
    wire_->received = [listener](std::string_view reply) { listener->bytes_arrived(reply); };
    wire_->ended = [listener](const Fault& why) { listener->stream_closed(why); };
    wire_->read();
  }
  void send(std::string_view bytes) override { wire_->send(bytes); }
  void discard_unsent() override { wire_->waiting.clear(); }
  Result<> set_rate(int) override { return {}; }
  [[nodiscard]] int rate() const override { return 0; }
  [[nodiscard]] bool carries_messages() const override { return true; }
  [[nodiscard]] WireShare share() const override {
    if (!wire_->handle || wire_->over || wire_->file < 0) return {};
    return {WireShare::How::messages, wire_->file, {}, 0};
  }
  [[nodiscard]] std::string describe() const override { return wire_->name; }

 private:
  std::shared_ptr<PerformaxWire> wire_;
};

tl::unexpected<Fault> not_opened(std::string what, std::string advice) {
  return fail(FaultKind::port, std::move(what), "Nothing was opened.", std::move(advice));
}

std::string serials(const std::vector<PerformaxDevice>& devices) {
  std::string all;
  for (const PerformaxDevice& d : devices) all += (all.empty() ? "" : ", ") + d.serial;
  return all;
}

Result<PerformaxDevice> choose(const std::vector<PerformaxDevice>& there, const std::string& serial) {
  if (there.empty())
    return not_opened("No Performax controller is connected by USB.",
                      "Check its USB cable and its power; lsusb shows it as 1589:a101.");
  if (serial.empty()) {
    if (there.size() == 1) return there.front();
    return not_opened(
        fmt::format("{} Performax controllers are connected by USB: {}.", there.size(), serials(there)),
        fmt::format("Say which one, as pmx-4ex-sa@usb:{}.", there.front().serial));
  }
  for (const PerformaxDevice& d : there)
    if (d.serial == serial) return d;
  return not_opened(fmt::format("No Performax controller named {} is connected by USB.", serial),
                    fmt::format("Connected: {}.", serials(there)));
}

tl::unexpected<Fault> why_not_opened(int error, const PerformaxDevice& device) {
  const std::string name = "USB device " + device.serial;
  if (error == LIBUSB_ERROR_ACCESS)
    return not_opened(fmt::format("This user may not open {}.", name), udev_advice);
  if (error == LIBUSB_ERROR_BUSY)
    return not_opened(fmt::format("{} is in use by another program.", name),
                      "Close that program, then connect again.");
  return not_opened(fmt::format("{} cannot be opened: {}.", name, usb_error(error)),
                    "Check its USB cable and its power.");
}

int claim(libusb_device_handle* handle) {
  int now = 0;
  if (libusb_get_configuration(handle, &now) != 0 || now != configuration)
    if (const int error = libusb_set_configuration(handle, configuration); error != 0) return error;
  return libusb_claim_interface(handle, interface);
}

std::string node_of(const PerformaxDevice& device) {
  return fmt::format("/dev/bus/usb/{:03}/{:03}", device.bus, device.number);
}

// Finds the library's descriptor, which it does not give. A process that shares the open file may write to
// the interface that was claimed through it.
int file_of(const std::string& node) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd", error))
    if (fs::read_symlink(entry.path(), error) == node) return std::atoi(entry.path().filename().c_str());
  return -1;
}

int open_device(PerformaxWire& wire, const PerformaxDevice& wanted) {
  libusb_device** all = nullptr;
  const ssize_t count = libusb_get_device_list(wire.loop->context(), &all);
  int error = count < 0 ? static_cast<int>(count) : LIBUSB_ERROR_NO_DEVICE;
  for (ssize_t i = 0; i < count; ++i)
    if (libusb_get_bus_number(all[i]) == wanted.bus && libusb_get_device_address(all[i]) == wanted.number)
      error = libusb_open(all[i], &wire.handle);
  if (count >= 0) libusb_free_device_list(all, 1);
  if (error == 0) wire.file = file_of(node_of(wanted));
  return error != 0 ? error : claim(wire.handle);
}

class Watch final : public PerformaxWatch {
 public:
  explicit Watch(std::unique_ptr<UsbLoop> loop) : loop_(std::move(loop)) {}

 private:
  std::unique_ptr<UsbLoop> loop_;
};

}  // namespace

std::vector<PerformaxDevice> list_performax(const std::string& sys) {
  std::vector<PerformaxDevice> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(sys) / "bus" / "usb" / "devices", error)) {
    const fs::path& at = entry.path();
    if (first_line(at / "idVendor") != "1589" || first_line(at / "idProduct") != "a101") continue;
    PerformaxDevice device;
    device.serial = first_line(at / "serial");
    device.product = first_line(at / "product");
    device.bus = std::atoi(first_line(at / "busnum").c_str());
    device.number = std::atoi(first_line(at / "devnum").c_str());
    device.permitted = ::access(node_of(device).c_str(), R_OK | W_OK) == 0;
    found.push_back(std::move(device));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.serial < b.serial; });
  return found;
}

Task<Result<std::unique_ptr<Stream>>> open_performax_usb(Scheduler& scheduler, std::string serial) {
  std::transform(serial.begin(), serial.end(), serial.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto device = choose(list_performax(), serial);
  if (!device) co_return fail(device.error());
  auto loop = UsbLoop::make(scheduler);
  if (!loop) co_return fail(loop.error());
  const auto wire = std::make_shared<PerformaxWire>(scheduler);
  wire->loop = std::move(*loop);
  wire->name = "USB " + device->serial;
  if (const int error = open_device(*wire, *device); error != 0) co_return why_not_opened(error, *device);
  const bool opened = co_await wire->control(control_open);
  const bool flushed = opened && co_await wire->control(control_flush);
  if (!flushed)
    co_return not_opened(fmt::format("{} does not answer when it is opened.", wire->name),
                         "Switch it off and on, and plug it in again.");
  co_await wire->drain();
  co_return std::make_unique<PerformaxStream>(wire);
}

Result<std::unique_ptr<PerformaxWatch>> PerformaxWatch::start(Scheduler& scheduler,
                                                              std::function<void()> changed) {
  auto loop = UsbLoop::make(scheduler);
  if (!loop) return fail(loop.error());
  if (auto watched = (*loop)->watch(vendor, product, std::move(changed)); !watched)
    return fail(watched.error());
  return std::make_unique<Watch>(std::move(*loop));
}

}  // namespace hw
