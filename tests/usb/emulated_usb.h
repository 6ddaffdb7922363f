#pragma once
// A Performax controller on an emulated USB port: what the kernel would do with libusb's requests, done here
// in front of an Emulator whose transfers are 64 bytes. One thread of umockdev serves it; all members lock.
// As the kernel does, it goes on answering whoever has it open when it has been unplugged: it may be
// destroyed only when nobody has. libusb watches for hot plug with one socket for all its contexts; it lies
// in the folder of the bus that was there first, so one context left open deafens all tests that follow.
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <umockdev-1.0/umockdev.h>

#include "core/emulation/emulator.h"

namespace hw::test {

class EmulatedUsb {
 public:
  /// On the bus from the start.
  EmulatedUsb(UMockdevTestbed* bus, std::unique_ptr<Emulator> device, std::string serial, int number);
  ~EmulatedUsb();

  void unplug();
  /// Some program has it open, with the interface claimed.
  bool in_use();
  /// Unplugs it and hands the controller out, to be plugged in again somewhere: it has its own supply.
  std::unique_ptr<Emulator> pull_out();
  /// The next replies are cut off after so many bytes.
  void cut_next_replies(std::size_t bytes, int how_many = 1);
  /// Values of the control transfers so far.
  std::vector<int> controls();
  /// Commands as they came, without what fills them up.
  std::vector<std::string> commands();
  /// Leaves a reply behind that nobody has fetched.
  void leave_reply(std::string text);

 private:
  struct Urb;
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  void serve(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void advance();
  void take_replies();
  void finish(std::shared_ptr<Urb> urb, int status, std::size_t length);

  std::mutex mutex_;
  UMockdevTestbed* bus_;
  UMockdevIoctlBase* handler_ = nullptr;
  std::string path_, node_;
  std::unique_ptr<Emulator> device_;
  std::deque<std::string> replies_;
  std::deque<std::shared_ptr<Urb>> reading_, done_;
  std::vector<int> controls_;
  std::vector<std::string> commands_;
  std::size_t cut_ = 64;
  int to_cut_ = 0;
  int claims_ = 0;  // of the interface, by who has it open
  bool there_ = true;
};

}  // namespace hw::test
