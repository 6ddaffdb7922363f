#include "panels/program/run_doubt.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "core/device/sequence_travel.h"
#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/console.h"

namespace hw::panels {

using namespace gui;
namespace {

DoubtWords words_here(const Frame& f) {
  return {[&f](AxisId axis, Steps place) {
            return std::string(format_with_unit(place, f.tab.unit(axis)).view());
          },
          [&f](Instant when) { return f.console.time_of_day(when); }};
}

/// The first way of homing after which the count is known.
int homing_that_settles(const Catalog& catalog) {
  const auto& modes = catalog.homing_modes;
  const auto first = std::find_if(modes.begin(), modes.end(), [](const auto& m) { return m.sets_position; });
  return first == modes.end() ? 0 : static_cast<int>(first - modes.begin());
}

/// A bit per axis whose count is not to be trusted, whatever the program does with it.
std::uint32_t doubted_of_all(const Frame& f) {
  std::uint32_t doubted = 0;
  for (std::size_t a = 0; a < std::min<std::size_t>(f.catalog.axes.size(), max_axes); ++a)
    if (f.now.axes[a].trust.doubtful()) doubted |= 1u << a;
  return doubted;
}

}  // namespace

bool RunDoubt::find_places(const Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  const WrittenSequence* source =
      desk.source.of(desk.texts.text(slot), desk.blocks, desk.language(), f.catalog);
  if (!source) return false;
  run_ = intent::RunProgram(slot, places_of_run(*source->sequence, f.catalog, f.now));
  doubted_ = doubted_of_all(f);
  return true;
}

bool RunDoubt::holds_back(const Frame& f, RunWish wish) {
  if (wish == RunWish::none) return false;  // the question stays
  wish_ = RunWish::none;
  if (!find_places(f)) return false;
  const std::uint32_t doubtful = doubtful_axes(f.catalog, f.now, run_);
  if (doubtful == 0 || past_travel(f.catalog, f.now, run_)) return false;  // no remedy helps beyond a limit
  wish_ = wish;
  text_ = f.tab.desk().texts.text(run_.slot);
  tell(f, doubtful);
  return true;
}

void RunDoubt::tell(const Frame& f, std::uint32_t doubtful) {
  doubtful_ = doubtful;
  axis_ = AxisId{static_cast<std::uint8_t>(std::countr_zero(doubtful))};
  words_ = say_doubtful(f.catalog, f.now, run_, doubtful, words_here(f));
  offered_ = 0;
}

void RunDoubt::name_ways(const Frame& f, std::string_view where) {
  const std::string& name = f.catalog.axes[axis_.index].name;
  const auto offer = [&](Way way, std::string_view id, std::string label, std::string brief) {
    offers_[offered_++] = {way, fmt::format("{}/doubt/{}", where, id), std::move(label), std::move(brief)};
  };
  refused_id_ = fmt::format("{}/doubt/refused", where);
  counted_ = f.now.axes[axis_.index].position;
  const NumberText count = format_with_unit(counted_, f.tab.unit(axis_));
  offer(stands, "stands", fmt::format("{} stands at {}", name, count.view()),
        fmt::format("At {}", count.view()));
  if (f.catalog.can.homes) {
    offer(home_minus, "home/-", fmt::format("Home {} \u2212", name), "Home \u2212");
    offer(home_plus, "home/+", fmt::format("Home {} +", name), "Home +");
  }
  offer(once, "once", "Go on for this once", "Go on once");
}

std::string_view RunDoubt::why_not(const Frame& f, Way way) const {
  if (!f.connected()) return f.no_link();
  if (way == once) return why_none_runs(f);
  if (way != stands) return f.tab.why_not_move(axis_);
  return f.now.axis_moves(axis_.index) ? "It moves." : "";
}

RunWish RunDoubt::draw(Frame& f, std::string_view where, const Rect& row) {
  if (wish_ == RunWish::none) return RunWish::none;
  const ProgramTexts& texts = f.tab.desk().texts;
  const bool same_text = texts.chosen() == run_.slot && texts.text(run_.slot) == text_;
  // Which places it is sent to by its counts depends on which of them are trusted.
  if (!same_text || (doubted_ != doubted_of_all(f) && !find_places(f))) return wish_ = RunWish::none;
  const std::uint32_t now = doubtful_axes(f.catalog, f.now, run_);
  if (now == 0 || past_travel(f.catalog, f.now, run_)) return wish_ = RunWish::none;
  const bool told_anew = now != doubtful_;
  if (told_anew) tell(f, now);
  if (offered_ == 0 || counted_ != f.now.axes[axis_.index].position) offered_ = 0, name_ways(f, where);
  std::array<Action, 4> actions;
  for (std::size_t i = 0; i < offered_; ++i)
    actions[i] = {.id = offers_[i].id,
                  .label = offers_[i].label,
                  .brief = offers_[i].brief,
                  .disabled = why_not(f, offers_[i].way),
                  .moving = offers_[i].way != stands};
  card_.begin(f, {.id = refused_id_, .about = "Run", .words = words_, .actions = {actions.data(), offered_}},
              row);
  const RefusalTouch touched = card_.end();
  if (touched.closed) wish_ = RunWish::none;
  if (touched.action < 0 || told_anew) return RunWish::none;  // that click was on what was told before
  const Way way = offers_[static_cast<std::size_t>(touched.action)].way;
  if (way == once) return std::exchange(wish_, RunWish::none);
  go(f, way);
  return RunWish::none;
}

void RunDoubt::go(Frame& f, Way way) const {
  if (way == stands) {
    f.send(stands_at(f.now, axis_, counted_));
    return;
  }
  f.send(intent::Home(axis_, way == home_plus ? Sign::plus : Sign::minus, homing_that_settles(f.catalog)));
}

}  // namespace hw::panels
