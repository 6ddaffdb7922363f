#include "gui/app/emulator_serving.h"

#include <atomic>

#include <fmt/core.h>

#include "core/base/asio.h"
#include "core/base/ring.h"
#include "core/session/session.h"
#include "transports/emulator_service.h"

namespace hw::app {

struct EmulatorServing::Wire {
  Ring<gui::ServedEmulator> news{16};
  std::atomic<int> clients{0};
  std::unique_ptr<EmulatorService> service;  // io thread
  std::function<void()> wake;

  void publish(gui::ServedEmulator now) {
    news.push(std::move(now));
    if (wake) wake();
  }
};

static Result<std::shared_ptr<EmulatorHost>> host_to_serve(Scheduler& scheduler, const Address& address,
                                                           const std::shared_ptr<Session>& session) {
  if (!session) return make_private_host(scheduler, address);
  if (auto host = EmulatorHost::of(session->bench())) return host;
  return fail(FaultKind::port, "The emulator is not connected.", "It is not served.",
              "Wait until it answers, and switch it on again.");
}

static void start_serving(Scheduler& scheduler, const Address& address,
                          const std::shared_ptr<Session>& session, const EmulatorService::Place& place,
                          const std::shared_ptr<EmulatorServing::Wire>& wire) {
  gui::ServedEmulator now;
  const auto host = host_to_serve(scheduler, address, session);
  if (!host) {
    now.trouble = host.error().sentence();
    return wire->publish(std::move(now));
  }
  auto service = EmulatorService::start(scheduler, *host, place,
                                        [weak = std::weak_ptr<EmulatorServing::Wire>(wire)](int clients) {
                                          const auto there = weak.lock();
                                          if (!there) return;
                                          there->clients = clients;
                                          if (there->wake) there->wake();
                                        });
  if (!service) {
    now.trouble = service.error().sentence();
    return wire->publish(std::move(now));
  }
  now.tcp = (*service)->address();
  now.terminal = (*service)->terminal();
  wire->service = std::move(*service);
  wire->publish(std::move(now));
}

void EmulatorServing::serve(const std::string& key, const Address& address,
                            std::shared_ptr<Session> session) {
  constexpr int first_port = 5801;
  end(key);
  auto wire = std::make_shared<Wire>();
  wire->wake = wake_;
  const EmulatorService::Place place{first_port + started_++ % 100, terminal_for(key)};
  asio::post(scheduler_.executor(), [&scheduler = scheduler_, address, session = std::move(session), place,
                                     wire] { start_serving(scheduler, address, session, place, wire); });
  served_[key].wire = std::move(wire);
}

void EmulatorServing::end(std::string_view key) {
  const auto served = served_.find(key);
  if (served == served_.end()) return;
  asio::post(scheduler_.executor(), [wire = served->second.wire] { wire->service.reset(); });
  served_.erase(served);
}

const gui::ServedEmulator* EmulatorServing::find(std::string_view key) {
  const auto served = served_.find(key);
  if (served == served_.end()) return nullptr;
  Served& s = served->second;
  s.wire->news.drain([&s](gui::ServedEmulator& now) { s.now = std::move(now); });
  s.now.clients = s.wire->clients;
  return &s.now;
}

}  // namespace hw::app
