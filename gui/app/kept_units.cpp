#include "gui/app/kept_units.h"

#include "core/session/session.h"
#include "gui/model/kept_unit.h"
#include "transports/ports.h"

namespace hw::app {

std::optional<script::AxisUnit> unit_of_profile(const Catalog& catalog, const Profile& profile, int axis) {
  const gui::DisplayUnit unit = gui::kept_unit(catalog, profile.axes[static_cast<std::size_t>(axis)]);
  if (!unit.real || unit.per_step == 0) return {};
  return script::AxisUnit{unit.name, 1 / unit.per_step};
}

std::optional<script::AxisUnit> KeptUnits::unit_of(const Session& session, int axis) {
  auto found = read_.find(session.weak_from_this());
  if (found == read_.end()) {
    auto profile = store_.load(profile_key(session.address(), usb_serial_behind(session.address())));
    if (!profile) complain_(profile.error());
    found = read_.emplace(session.weak_from_this(), profile ? std::move(*profile) : Profile()).first;
  }
  return unit_of_profile(session.catalog(), found->second, axis);
}

std::string usb_serial_behind(const Address& address) {
  if (address.transport != "serial") return {};
  for (const SerialPort& port : list_serial_ports())
    if (port.path == address.where) return port.serial;
  return {};
}

}  // namespace hw::app
