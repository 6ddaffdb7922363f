#include "panels/path/program_path.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/track.h"
#include "core/drawing/sequence_path.h"
#include "core/session/way_together.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/surface/ui.h"

namespace hw::panels {

using namespace gui;

std::string length_text(double units, const DisplayUnit& unit, bool one_unit) {
  if (!one_unit) return "in several units";
  return fmt::format("{} {}", format_number(units, std::min(unit.decimals, 3)).view(), unit.name);
}

namespace {

struct Meant {
  std::shared_ptr<const sequence::Sequence> sequence;  ///< null: not visible in these axes
  drawing::SequenceAxes axes;
};

/// The intended path, from the start of the rehearsal.
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

// ---- content

int ProgramPath::Part::started() const { return tab->desk().programs.texts.start_of(slot); }

const Rehearsals::Outcome* ProgramPath::Part::outcome() const {
  return tab ? tab->desk().programs.rehearsals.of(started()) : nullptr;
}

ProgramPath::Made ProgramPath::wanted_of(const Frame& f, const PathAxes& axes, PathTool tool) const {
  Made wanted;
  wanted.tool = tool;
  if (drawn_.number > passed_over_) wanted.drawn = drawn_.rehearsal;
  const Directions all = directions_of(f, axes);
  const auto part_of = [&wanted](Tab* tab) {
    std::size_t n = 0;
    while (n < wanted.count && wanted.parts[n].tab != tab) ++n;
    if (n == wanted.count) {
      Part& part = wanted.parts[wanted.count++];
      part.tab = tab, part.slot = tab->desk().programs.texts.chosen();
      const Rehearsals::Outcome* outcome = part.outcome();
      part.rehearsal = outcome && outcome->result ? outcome->number : 0;
    }
    return static_cast<int>(n);
  };
  const auto seen = [&](const Direction& d, AxisId on_bus) {
    TrackAxes::Axis axis{d.axis.index, from_steps(Steps(1), d.unit()), part_of(d.tab)};
    if (wanted.drawn) axis.place = on_bus.index, axis.track = 0;
    return axis;
  };
  wanted.axes.over_time = axes.over_time;
  if (!axes.over_time) wanted.axes.right = seen(all.all[0], axes.right);
  wanted.axes.up = seen(all.all[1], axes.up);
  if (all.count > 2) wanted.axes.third = seen(all.all[2], *axes.third);
  if (!tool.own) wanted.axes.tool_output = tool.output;
  return wanted;
}

bool ProgramPath::follow(Frame& f, const PathAxes& axes, PathTool tool) {
  follow_drawn(f);
  Made wanted = wanted_of(f, axes, tool);
  follow_refusal();
  if (wanted == made_) return false;
  made_ = std::move(wanted);
  path_ = commanded_ = nullptr;
  if (made_.drawn)
    work_out_drawn(f, directions_of(f, axes));
  else if (rehearsed())
    work_out(f, directions_of(f, axes));
  return true;
}

/// Follows the progress of the drawing.
void ProgramPath::follow_drawn(const Frame& f) {
  step_at_work_ = -1;
  left_s_.reset();
  if (!f.tab.bus) return;
  const Bus& bus = *f.tab.bus;
  if (bus.drawn.number != drawn_.number) drawn_ = bus.drawn;
  const PiecesState& now = bus.pieces();
  clock_.follow(now, f.clock);
  if (!drawn_.rehearsal || !now.running || bus.begun != drawn_.sequence) return;
  step_at_work_ = now.step;
  if (drawn_.rehearsal->finished && now.percent > 0)
    left_s_ = std::max(
        seconds_from(now.step, *drawn_.rehearsal) * 100 / now.percent - clock_.time_at_step_s(), 0.0);
}

void ProgramPath::follow_refusal() {
  const Rehearsals::Outcome* refused = nullptr;
  for (std::size_t n = 0; n < made_.count; ++n)
    if (const auto* outcome = made_.parts[n].outcome(); outcome && !outcome->result) refused = outcome;
  if (std::exchange(refused_, refused ? refused->number : 0) == (refused ? refused->number : 0)) return;
  refusal_ = refused ? refused->result.error().sentence() : std::string();
}

bool ProgramPath::rehearsed() const {
  return made_.drawn ||
         std::any_of(made_.parts.begin(), made_.parts.end(), [](const Part& p) { return p.rehearsal > 0; });
}

void ProgramPath::rehearse(const Frame& f) {
  if (!why_not_rehearse().empty()) return;
  passed_over_ = drawn_.number;
  if (made_.count == 0) return f.tab.desk().programs.requests.rehearse(f.now, f.bench);
  for (std::size_t n = 0; n < made_.count; ++n)
    made_.parts[n].tab->desk().programs.requests.rehearse(made_.parts[n].tab->now(),
                                                          made_.parts[n].tab->bench());
}

bool ProgramPath::under_way() const {
  return std::any_of(made_.parts.begin(), made_.parts.begin() + made_.count,
                     [](const Part& p) { return p.tab->desk().programs.rehearsals.under_way(p.started()); });
}

std::string_view ProgramPath::why_not_rehearse() const {
  bool any = false;
  for (std::size_t n = 0; n < made_.count; ++n) {
    const Desk& desk = made_.parts[n].tab->desk();
    if (!desk.programs.language()) return no_rehearsal;
    any = any || !desk.programs.texts.text(made_.parts[n].slot).empty();
  }
  if (!any) return of_several() ? "Their programs are empty." : "The program is empty.";
  for (std::size_t n = 0; n < made_.count; ++n) {
    const Tab& tab = *made_.parts[n].tab;
    if (const auto why = why_not_rehearse_now(tab.now(), tab.catalog()); !why.empty()) return why;
  }
  return under_way() ? "Calculating." : "";
}

// ---- the path

/// A controller without a rehearsal contributes its position.
std::vector<Rehearsal> ProgramPath::tracks() const {
  std::vector<Rehearsal> all(made_.count);
  for (std::size_t n = 0; n < made_.count; ++n) {
    const Part& part = made_.parts[n];
    if (const auto* outcome = part.rehearsal > 0 ? part.outcome() : nullptr) {
      all[n].duration_s = outcome->result->duration_s;
      all[n].track = outcome->result->track;
      all[n].events = outcome->result->events, all[n].turns = outcome->result->turns;
      continue;
    }
    RehearsedPlace here;
    for (std::size_t a = 0; a < max_axes; ++a) here.position[a] = part.tab->now().axes[a].position.value;
    all[n].track.push_back(here);
  }
  return all;
}

void ProgramPath::work_out(Frame& f, const Directions& seen) {
  const Part& first = made_.parts[0];
  const Rehearsals::Outcome* outcome = of_several() ? nullptr : first.outcome();
  Desk& desk = first.tab->desk();
  const Catalog& catalog = first.tab->catalog();
  std::vector<Rehearsal> ways = tracks();
  double longest = 0;
  for (const Rehearsal& way : ways) longest = std::max(longest, way.duration_s);
  facts_ = {};
  facts_.time = format_duration(longest).view();
  TrackAxes axes = made_.axes;
  places_ = {};
  Meant meant;
  if (outcome) {
    places_ = source_places(desk.programs.language()->analyse(outcome->text, first.slot), first.slot);
    const WrittenSequence* source =
        desk.programs.source.of(outcome->text, desk.blocks, desk.programs.language(), catalog);
    if (source && made_.tool.own) take_tool_of(*source->sequence, catalog, axes);
    if (source && !axes.over_time) meant = meant_in(source->sequence, catalog, axes, *outcome->result);
  }
  keep_tool(catalog, axes);
  std::vector<DisplayUnit> units;
  for (const Direction& d : seen) units.push_back(d.unit());
  desk.work.worker().run(
      [ways = std::move(ways), axes, slot = first.slot, alone = outcome != nullptr,
       sources = places_.of_command, meant = std::move(meant)] {
        const auto shared = [](drawing::ToolPath&& path) {
          return std::make_shared<const drawing::ToolPath>(std::move(path));
        };
        Paths paths;
        paths.path =
            shared(alone ? track_path(ways[0], axes, slot, sources) : track_path_together(ways, axes));
        if (meant.sequence) paths.commanded = shared(sequence_path_in(*meant.sequence, meant.axes));
        for (const Rehearsal& way : ways)
          paths.every = std::max(paths.every, thinned_to(way.track, track_seen_every_s));
        return paths;
      },
      [this, wanted = made_, units](Paths paths) {
        if (wanted == made_) take(std::move(paths), units);
      },
      alive_);
  f.ui.wake_in(0);
}

void ProgramPath::work_out_drawn(Frame& f, const Directions& seen) {
  facts_ = {};
  facts_.time = format_duration(made_.drawn->duration_s).view();
  if (!made_.drawn->finished) facts_.time = fmt::format("more than {}", facts_.time);
  TrackAxes axes = made_.axes;
  places_ = {};
  if (made_.tool.own) take_tool_of(*drawn_.sequence, f.catalog, axes);
  keep_tool(f.catalog, axes);
  const Meant meant = axes.over_time ? Meant() : meant_in(drawn_.sequence, f.catalog, axes, *made_.drawn);
  std::vector<DisplayUnit> units;
  for (const Direction& d : seen) units.push_back(d.unit());
  f.tab.desk().work.worker().run(
      [done = made_.drawn, axes, meant, count = drawn_.sequence->steps.size()] {
        std::vector<int> steps(count);
        std::iota(steps.begin(), steps.end(), 0);
        Paths paths;
        paths.path = std::make_shared<const drawing::ToolPath>(track_path(*done, axes, 0, steps));
        if (meant.sequence)
          paths.commanded =
              std::make_shared<const drawing::ToolPath>(sequence_path_in(*meant.sequence, meant.axes));
        paths.every = thinned_to(done->track, track_seen_every_s);
        return paths;
      },
      [this, wanted = made_, units](Paths paths) {
        if (wanted == made_) take(std::move(paths), units);
      },
      alive_);
  f.ui.wake_in(0);
}

void ProgramPath::keep_tool(const Catalog& catalog, const TrackAxes& axes) {
  tool_axes_ = axes;
  if (axes.tool_output >= 0 && ix(axes.tool_output) < catalog.outputs.size())
    facts_.tool = catalog.outputs[ix(axes.tool_output)].name;
  else if (axes.lowers)
    facts_.tool = catalog.axes[ix(axes.lowers->place)].name;
}

std::optional<bool> ProgramPath::tool_on(const Frame& f) const {
  if (!path_) return std::nullopt;
  if (made_.drawn) return tool_on_now(f, tool_axes_, *drawn_.sequence);
  const Snapshot& now = made_.parts[0].tab->now();
  return tool_on_now(tool_axes_, now, now, tool_axes_.lowers ? tool_axes_.lowers->place : 0);
}

void ProgramPath::take(Paths paths, const std::vector<DisplayUnit>& units) {
  const drawing::ToolPath* path = paths.path.get();
  const bool one_unit = std::all_of(units.begin(), units.end(),
                                    [&](const DisplayUnit& unit) { return unit.name == units[0].name; });
  facts_.every = paths.every;
  if (!made_.axes.over_time) {
    facts_.way_on = length_text(path->way_on, units[0], one_unit);
    facts_.way_off = length_text(path->way_off, units[0], one_unit);
  }
  most_passes_.assign(places_.all.size(), 0);
  for (const drawing::ToolPath::Run& run : path->runs)
    if (run.source >= 0 && ix(run.source) < most_passes_.size())
      most_passes_[ix(run.source)] = std::max(most_passes_[ix(run.source)], run.pass + 1);
  if (path->bounds.empty) return;
  const drawing::Point3 size = path->bounds.size();
  for (std::size_t i = 0; i < units.size(); ++i) {
    const bool named = i + 1 == units.size() || !one_unit;
    facts_.size += fmt::format("{}{}{}{}", i == 0 ? "" : " \u00d7 ",
                               format_number(along(size, i), std::min(units[i].decimals, 3)).view(),
                               named ? " " : "", named ? units[i].name : "");
  }
  path_ = std::move(paths.path), commanded_ = std::move(paths.commanded);
}

// ---- the text of the path

const std::string* ProgramPath::text() const {
  const Rehearsals::Outcome* outcome = of_several() || made_.drawn ? nullptr : made_.parts[0].outcome();
  return outcome ? &outcome->text : nullptr;
}

bool ProgramPath::older() const {
  return !made_.drawn &&
         std::any_of(made_.parts.begin(), made_.parts.begin() + made_.count, [](const Part& part) {
           Desk& desk = part.tab->desk();
           return desk.programs.rehearsals.older_than_line(part.started(),
                                                           desk.programs.texts.text(part.slot)) >= 0;
         });
}

/// Passes that the controller makes without a break are a single run, so they cannot be distinguished.
std::optional<int> ProgramPath::pass_of(std::size_t run) const {
  const std::vector<drawing::ToolPath::Run>& runs = path_->runs;
  const bool reported = std::any_of(runs.begin(), runs.end(), [&](const drawing::ToolPath::Run& r) {
    return r.source == runs[run].source && r.pass > 0;
  });
  return reported ? std::optional(runs[run].pass) : std::nullopt;
}

int ProgramPath::source_at_work() const {
  if (made_.drawn) return step_at_work_;
  const std::string* rehearsed = text();
  if (!path_ || !rehearsed) return -1;
  const Part& part = made_.parts[0];
  Desk& desk = part.tab->desk();
  const RunFollower::Place at = desk.programs.follower.place();
  if (!part.tab->now().link.connected() || at.slot != part.slot || at.command < 0) return -1;
  if (desk.programs.texts.held(at.slot).text != *rehearsed || ix(at.command) >= places_.of_command.size())
    return -1;
  int source = places_.of_command[ix(at.command)];
  const int line = places_.line_of(source);
  while (source > 0 && most_passes_[ix(source)] == 0 && places_.line_of(source - 1) == line) --source;
  return source;
}

std::optional<int> ProgramPath::pass_at_work() const {
  const int source = source_at_work();
  if (made_.drawn || source < 0 || ix(source) >= most_passes_.size()) return std::nullopt;
  const int pass = made_.parts[0].tab->desk().programs.follower.place().pass - 1;
  return pass >= 0 && pass < most_passes_[ix(source)] ? std::optional(pass) : std::nullopt;
}

const Rehearsal* ProgramPath::rehearsal() const {
  const Rehearsals::Outcome* outcome = of_several() ? nullptr : made_.parts[0].outcome();
  return outcome && outcome->result ? &*outcome->result : nullptr;
}

}  // namespace hw::panels
