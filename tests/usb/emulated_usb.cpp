#include "tests/usb/emulated_usb.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

namespace hw::test {
namespace {

// Device, configuration 1, interface 0, bulk IN 0x82, bulk OUT 0x02, 64 bytes each.
constexpr const char* descriptors =
    "12011001000000408915"
    "01A1000101020301"
    "09022000010100803209040000"
    "02FF000000"
    "0705820240000007050202400000";

}  // namespace

// A request of libusb's that the "kernel" holds.
struct EmulatedUsb::Urb {
  UMockdevIoctlData *urb, *buffer;
  Urb(UMockdevIoctlData* u, UMockdevIoctlData* b) : urb(u), buffer(b) {}
  ~Urb() {
    g_object_unref(urb);
    if (buffer) g_object_unref(buffer);
  }
  Urb(const Urb&) = delete;
  [[nodiscard]] usbdevfs_urb& request() const { return *reinterpret_cast<usbdevfs_urb*>(urb->data); }
};

EmulatedUsb::EmulatedUsb(UMockdevTestbed* bus, std::unique_ptr<Emulator> device, std::string serial,
                         int number)
    : bus_(bus), device_(std::move(device)) {
  path_ = fmt::format("/devices/pci0000:00/usb1/1-{}", number);
  node_ = fmt::format("/dev/bus/usb/001/{:03}", number);
  const std::string description = fmt::format(
      "P: {}\nN: bus/usb/001/{:03}={}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME={}\n"
      "E: BUSNUM=001\nE: DEVNUM={:03}\nA: busnum=1\\n\nA: devnum={}\\n\nA: bConfigurationValue=1\\n\n"
      "A: idVendor=1589\\n\nA: idProduct=a101\\n\nA: product=Performax USB\\n\nA: serial={}\\n\nA: "
      "speed=12\\n\n"
      "H: descriptors={}\n",
      path_, number, descriptors, node_, number, number, serial, descriptors);
  GError* error = nullptr;
  handler_ = umockdev_ioctl_base_new();
  g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
  if (!umockdev_testbed_add_from_string(bus_, description.c_str(), &error) ||
      !umockdev_testbed_attach_ioctl(bus_, node_.c_str(), handler_, &error))
    throw std::runtime_error(error->message);
  umockdev_testbed_uevent(bus_, ("/sys" + path_).c_str(), "add");
}

EmulatedUsb::~EmulatedUsb() {
  unplug();
  umockdev_testbed_detach_ioctl(bus_, node_.c_str(), nullptr);
  g_signal_handlers_disconnect_by_data(handler_, this);
  g_object_unref(handler_);
}

void EmulatedUsb::unplug() {
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(there_, false)) return;
    while (!reading_.empty()) {
      finish(reading_.front(), -ENODEV, 0);
      reading_.pop_front();
    }
  }
  umockdev_testbed_uevent(bus_, ("/sys" + path_).c_str(), "remove");
  umockdev_testbed_remove_device(bus_, ("/sys" + path_).c_str());
}

bool EmulatedUsb::in_use() {
  const std::lock_guard lock(mutex_);
  return claims_ > 0;
}

std::unique_ptr<Emulator> EmulatedUsb::pull_out() {
  unplug();
  const std::lock_guard lock(mutex_);
  return std::move(device_);
}

// One time for all of them, so that a controller keeps its own from one port to the next.
void EmulatedUsb::advance() {
  static const auto began = std::chrono::steady_clock::now();
  device_->advance_to(Instant(std::chrono::steady_clock::now() - began));
}

void EmulatedUsb::cut_next_replies(std::size_t bytes, int how_many) {
  const std::lock_guard lock(mutex_);
  cut_ = std::min(bytes, std::size_t{64});
  to_cut_ = how_many;
}
std::vector<int> EmulatedUsb::controls() {
  const std::lock_guard lock(mutex_);
  return controls_;
}
std::vector<std::string> EmulatedUsb::commands() {
  const std::lock_guard lock(mutex_);
  return commands_;
}
void EmulatedUsb::leave_reply(std::string text) {
  const std::lock_guard lock(mutex_);
  text.resize(64, '\0');
  replies_.push_back(std::move(text));
}

gboolean EmulatedUsb::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  static_cast<EmulatedUsb*>(self)->serve(client);
  return TRUE;
}

void EmulatedUsb::serve(UMockdevIoctlClient* client) {
  const std::lock_guard lock(mutex_);
  const gulong request = umockdev_ioctl_client_get_request(client);
  UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
  if (request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY) return reap(client, arg);
  if (request == USBDEVFS_DISCARDURB) return discard(client, arg);
  if (request == USBDEVFS_RELEASEINTERFACE) --claims_;
  if (!there_) return umockdev_ioctl_client_complete(client, -1, ENODEV);
  if (request == USBDEVFS_CLAIMINTERFACE) ++claims_;
  if (request == USBDEVFS_SUBMITURB) return submit(client, arg);
  if (request == USBDEVFS_GET_CAPABILITIES) {
    UMockdevIoctlData* answer = umockdev_ioctl_data_resolve(arg, 0, sizeof(guint32), nullptr);
    guint32 none = 0;
    umockdev_ioctl_data_update(answer, 0, reinterpret_cast<guint8*>(&none), sizeof none);
    g_object_unref(answer);
    return umockdev_ioctl_client_complete(client, 0, 0);
  }
  const gulong harmless[] = {USBDEVFS_CLAIMINTERFACE, USBDEVFS_RELEASEINTERFACE, USBDEVFS_SETCONFIGURATION,
                             USBDEVFS_CLEAR_HALT};
  if (std::find(std::begin(harmless), std::end(harmless), request) != std::end(harmless))
    return umockdev_ioctl_client_complete(client, 0, 0);
  umockdev_ioctl_client_complete(client, -1, ENOTTY);
}

void EmulatedUsb::submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  UMockdevIoctlData* data = umockdev_ioctl_data_resolve(arg, 0, sizeof(usbdevfs_urb), nullptr);
  const auto& request = *reinterpret_cast<usbdevfs_urb*>(data->data);
  const auto length = static_cast<gsize>(request.buffer_length);
  auto urb = std::make_shared<Urb>(
      data, umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer), length, nullptr));
  const std::string sent(reinterpret_cast<const char*>(urb->buffer->data), length);
  if (request.type == USBDEVFS_URB_TYPE_CONTROL) {
    const int value = static_cast<unsigned char>(sent[2]) | static_cast<unsigned char>(sent[3]) << 8;
    controls_.push_back(value);
    if (value == 1) replies_.clear();  // flush
    finish(std::move(urb), 0, 0);
  } else if ((request.endpoint & 0x80) != 0) {
    reading_.push_back(std::move(urb));
  } else {
    commands_.push_back(sent.substr(0, sent.find('\0')));
    advance();
    device_->receive(sent);
    finish(std::move(urb), 0, length);
  }
  umockdev_ioctl_client_complete(client, 0, 0);
}

void EmulatedUsb::take_replies() {
  advance();
  std::string output;
  device_->take_output(output);
  for (; output.size() >= 64; output.erase(0, 64)) replies_.push_back(output.substr(0, 64));
  while (!reading_.empty() && !replies_.empty()) {
    auto urb = reading_.front();
    reading_.pop_front();
    const bool cut = to_cut_ > 0 && to_cut_-- > 0;
    const std::size_t length = cut ? cut_ : 64;
    umockdev_ioctl_data_update(urb->buffer, 0, reinterpret_cast<guint8*>(replies_.front().data()),
                               static_cast<gint>(length));
    replies_.pop_front();
    finish(std::move(urb), 0, length);
  }
}

void EmulatedUsb::finish(std::shared_ptr<Urb> urb, int status, std::size_t length) {
  urb->request().status = status;
  urb->request().actual_length = static_cast<int>(length);
  done_.push_back(std::move(urb));
}

void EmulatedUsb::reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  if (there_) take_replies();
  if (done_.empty()) return umockdev_ioctl_client_complete(client, -1, there_ ? EAGAIN : ENODEV);
  const auto urb = done_.front();
  done_.pop_front();
  UMockdevIoctlData* place = umockdev_ioctl_data_resolve(arg, 0, sizeof(void*), nullptr);
  umockdev_ioctl_data_set_ptr(place, 0, urb->urb);
  umockdev_ioctl_client_complete(client, 0, 0);
  g_object_unref(place);
}

void EmulatedUsb::discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  const gulong wanted = *reinterpret_cast<gulong*>(arg->data);
  for (auto at = reading_.begin(); at != reading_.end(); ++at) {
    if ((*at)->urb->client_addr != wanted) continue;
    finish(*at, -ENOENT, 0);
    reading_.erase(at);
    return umockdev_ioctl_client_complete(client, 0, 0);
  }
  umockdev_ioctl_client_complete(client, -1, EINVAL);
}

}  // namespace hw::test
