#pragma once
// The console's access to the rest of the program, passed by its creator. It is not in console.h, so that
// panels need not compile coroutines.
#include <functional>
#include <string>
#include <utility>

#include "core/session/user_files.h"
#include "core/session/wire.h"
#include "gui/model/traffic_log.h"

namespace hw::gui {

class DeviceFinder;
class PortFinder;
class Worker;

struct Outside {
  Scheduler& scheduler;
  WireOpener open_wire;
  std::function<void()> wake;   ///< any thread: requests a frame
  PortFinder* ports = nullptr;  ///< null: no ports are found
  DeviceFinder* devices = nullptr;
  Worker* worker = nullptr;  ///< for long jobs on programs; null: they run within the frame
  UserFolders folders = UserFolders::none();
  std::function<std::string(const Address&)> usb_serial;  ///< of the adapter behind an address; may be null
  DayClock day;                                           ///< time of day; 0: counts from the start
  Outside(Scheduler& s, WireOpener opener, std::function<void()> w)
      : scheduler(s), open_wire(std::move(opener)), wake(std::move(w)) {}
};

}  // namespace hw::gui
