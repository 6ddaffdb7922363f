#include "panels/path/program_path.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/drawing/sequence_path.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;

std::string length_text(double units, const DisplayUnit& unit, bool one_unit) {
  if (!one_unit) return "in several units";
  return fmt::format("{} {}", format_number(units, std::min(unit.decimals, 3)).view(), unit.name);
}

namespace {

struct Meant {
  std::shared_ptr<const sequence::Sequence> sequence;  ///< null: it is not seen in these axes
  drawing::SequenceAxes axes;
};

/// From where the rehearsal began.
Meant meant_in(std::shared_ptr<const sequence::Sequence> sequence, const Catalog& catalog,
               const TrackAxes& track, const Rehearsal& rehearsal) {
  Meant meant{std::move(sequence), {}};
  const std::vector<sequence::Axis>& own = meant.sequence->axes;
  const auto find = [&](const TrackAxes::Axis& seen, double& scale) {
    for (std::size_t a = 0; a < own.size(); ++a) {
      if (catalog.find_axis(own[a].name) != seen.place) continue;
      scale = own[a].per_unit * seen.units_per_step;
      return static_cast<int>(a);
    }
    return -1;
  };
  drawing::SequenceAxes& axes = meant.axes;
  axes.right = find(track.right, axes.scale.x), axes.up = find(track.up, axes.scale.y);
  axes.third = track.third ? find(*track.third, axes.scale.z) : -1;
  if (axes.right < 0 || axes.up < 0) return {};
  for (const RehearsedAxis& axis : rehearsal.axes)
    for (std::size_t a = 0; a < own.size(); ++a)
      if (own[a].name == axis.name) axes.begin[a] = static_cast<double>(axis.begin) / own[a].per_unit;
  return meant;
}

}  // namespace

bool ProgramPath::follow(Frame& f, const TrackAxes& axes) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  const Rehearsals::Outcome* outcome = desk.rehearsals.of(slot);
  const Made wanted{outcome && outcome->result ? outcome->number : 0, slot, axes};
  if (wanted == made_) return false;
  made_ = wanted;
  path_ = commanded_ = nullptr;
  if (wanted.rehearsal > 0) work_out(f, *outcome);
  return true;
}

void ProgramPath::work_out(Frame& f, const Rehearsals::Outcome& outcome) {
  Desk& desk = f.tab.desk();
  line_of_command_ = lines_of_commands(desk.language()->analyse(outcome.text, made_.slot), made_.slot);
  facts_.time = fmt::format("{}", format_duration(outcome.result->duration_s).view());
  Rehearsal way;
  way.track = outcome.result->track, way.events = outcome.result->events;
  const auto unit = [&](int axis) { return f.tab.unit(AxisId{static_cast<std::uint8_t>(axis)}); };
  const TrackAxes& axes = made_.axes;
  const std::array units{unit(axes.right.place), unit(axes.up.place),
                         axes.third ? unit(axes.third->place) : DisplayUnit()};
  const WrittenSequence* source = desk.source.of(outcome.text, desk.blocks, desk.language(), f.catalog);
  desk.worker().run(
      [way = std::move(way), wanted = made_, lines = line_of_command_,
       meant = source ? meant_in(source->sequence, f.catalog, axes, *outcome.result) : Meant()] {
        const auto shared = [](drawing::ToolPath&& path) {
          return std::make_shared<const drawing::ToolPath>(std::move(path));
        };
        Paths paths{shared(track_path(way, wanted.axes, wanted.slot, lines)), nullptr};
        if (meant.sequence) paths.commanded = shared(sequence_path_in(*meant.sequence, meant.axes));
        return paths;
      },
      [this, wanted = made_, units](Paths paths) {
        if (wanted == made_) take(std::move(paths), units);
      },
      alive_);
  f.ui.wake_in(0);
}

void ProgramPath::take(Paths paths, const std::array<DisplayUnit, 3>& units) {
  const drawing::ToolPath* path = paths.path.get();
  const bool flat = !made_.axes.third;
  const bool one_unit = units[0].name == units[1].name && (flat || units[0].name == units[2].name);
  facts_.way_on = length_text(path->way_on, units[0], one_unit);
  facts_.way_off = length_text(path->way_off, units[0], one_unit);
  const drawing::Box3& box = path->bounds;
  if (box.empty) {
    facts_.size = "nothing moves";
    return;
  }
  const drawing::Point3 size = box.size();
  const std::array<double, 3> spans{size.x, size.y, size.z};
  facts_.size.clear();
  for (std::size_t i = 0; i < (flat ? 2u : 3u); ++i) {
    const bool last = i == (flat ? 1u : 2u);
    facts_.size += fmt::format("{}{}{}{}", i == 0 ? "" : " \u00d7 ",
                               format_number(spans[i], std::min(units[i].decimals, 3)).view(),
                               last || !one_unit ? " " : "", last || !one_unit ? units[i].name : "");
  }
  path_ = std::move(paths.path), commanded_ = std::move(paths.commanded);
}

const std::string* ProgramPath::text(const Frame& f) const {
  const Rehearsals::Outcome* outcome = f.tab.desk().rehearsals.of(made_.slot);
  return outcome ? &outcome->text : nullptr;
}

bool ProgramPath::older(const Frame& f) const {
  Desk& desk = f.tab.desk();
  return desk.rehearsals.older_than_line(made_.slot, desk.texts.text(made_.slot)) >= 0;
}

int ProgramPath::line_at_work(const Frame& f) const {
  Desk& desk = f.tab.desk();
  const RunFollower::Place at = desk.follower.place();
  const std::string* rehearsed = text(f);
  if (!path_ || !rehearsed || !f.connected() || at.slot != made_.slot || at.command < 0) return -1;
  if (desk.texts.held(at.slot).text != *rehearsed || ix(at.command) >= line_of_command_.size()) return -1;
  return line_of_command_[ix(at.command)];
}

}  // namespace hw::panels
