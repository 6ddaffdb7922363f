#include "gui/app/kept_limits.h"

#include "core/base/index.h"
#include "core/device/travel_check.h"
#include "gui/app/kept_units.h"
#include "gui/app/output.h"
#include "gui/model/kept_unit.h"
#include "gui/model/units_format.h"

namespace hw::app {

KeptLimits::KeptLimits(Session& session) : session_(session) {
  const std::string key = profile_key(session.address(), usb_serial_behind(session.address()));
  if (auto profile = ProfileStore(UserFolders::standard()).load(key))
    profile_ = std::move(*profile);
  else
    write_aside(profile.error().sentence());
  for (std::size_t i = 0; i < session.catalog().axes.size(); ++i)
    if (const Travel& travel = profile_.axes[i].travel; travel.any())
      session.pump().post(Intent(0, intent::SetTravel(AxisId{static_cast<std::uint8_t>(i)}, travel)));
}

std::string KeptLimits::words_of(const Notice& notice) const {
  if (!notice.past) return notice.text;
  const Catalog& catalog = session_.catalog();
  const PlaceWords words = [&](AxisId axis, Steps place) {
    gui::DisplayUnit unit = gui::kept_unit(catalog, profile_.axes[axis.index]);
    if (!unit.real && profile_.axes[axis.index].travel.in_counts) unit.name = catalog.loop_word;
    return std::string(gui::format_with_unit(place, unit).view());
  };
  return describe_warned(catalog, *notice.past, words);
}

}  // namespace hw::app
