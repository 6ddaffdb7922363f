#include "panels/program/run_doubt.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/core.h>

#include "core/device/homing.h"
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
            return std::string(format_with_unit(place, f.tab.settings.unit(axis)).view());
          },
          [&f](Instant when) { return f.console.time_of_day(when); }};
}

/// The targets of axes with doubtful counts in a text that the user has typed, as far as it can be read.
std::vector<AxisTarget> places_in_doubt(const Frame& f, const std::string& text) {
  if (doubts_of(f.now) == AgreedDoubts()) return {};
  const auto read = read_sequence(f.tab, text);
  if (!read) return {};
  std::vector<AxisTarget> places = places_of_run(*read, f.catalog, f.now);
  std::erase_if(places, [&f](const AxisTarget& p) { return !f.now.axes[p.axis.index].trust.doubtful(); });
  return places;
}

}  // namespace

bool RunDoubt::find_places(const Frame& f, const std::string& text) {
  Desk& desk = f.tab.desk();
  const WrittenSequence* source =
      desk.programs.source.of(text, desk.blocks, desk.programs.language(), f.catalog);
  run_ = intent::RunProgram(
      desk.programs.texts.chosen(),
      source ? places_of_run(*source->sequence, f.catalog, f.now) : places_in_doubt(f, text));
  written_ = source != nullptr;
  doubted_ = doubts_of(f.now);
  return !run_.places.empty();
}

bool RunDoubt::is_beyond_travel(const Frame& f) const {
  return written_ && past_travel(f.catalog, f.now, run_).has_value();
}

bool RunDoubt::holds_back(const Frame& f, RunRequest request, const std::string& text) {
  if (request == RunRequest::none) return false;  // the question stays open
  request_ = RunRequest::none;
  if (!find_places(f, text)) return false;
  const std::uint32_t doubtful = doubtful_axes(f.catalog, f.now, run_);
  if (doubtful == 0 || is_beyond_travel(f)) return false;  // beyond a limit no remedy helps
  request_ = request;
  text_ = text;
  describe(f, doubtful);
  return true;
}

void RunDoubt::describe(const Frame& f, std::uint32_t doubtful) {
  doubtful_ = doubtful;
  axis_ = AxisId{static_cast<std::uint8_t>(std::countr_zero(doubtful))};
  words_ = describe_doubtful(f.catalog, f.now, run_, doubtful, words_here(f));
  offered_ = 0;
}

void RunDoubt::name_remedies(const Frame& f, std::string_view where) {
  const std::string& name = f.catalog.axes[axis_.index].name;
  const auto offer = [&](Remedy way, std::string_view id, std::string label, std::string brief) {
    offers_[offered_++] = {way, fmt::format("{}/doubt/{}", where, id), std::move(label), std::move(brief)};
  };
  refused_id_ = fmt::format("{}/doubt/refused", where);
  counted_ = f.now.axes[axis_.index].position;
  const NumberText count = format_with_unit(counted_, f.tab.settings.unit(axis_));
  offer(stands, "stands", fmt::format("{} stands at {}", name, count.view()),
        fmt::format("At {}", count.view()));
  const auto homes = [&](Sign sign) { return f.catalog.can.homes && homing_that_sets(f.catalog, -1, sign); };
  if (homes(Sign::minus)) offer(home_minus, "home/-", fmt::format("Home {} \u2212", name), "Home \u2212");
  if (homes(Sign::plus)) offer(home_plus, "home/+", fmt::format("Home {} +", name), "Home +");
  offer(once, "once", "Go on this once", "Go on once");
}

std::string_view RunDoubt::why_not(const Frame& f, Remedy way) const {
  if (!f.connected()) return f.no_link();
  if (way == once) return why_none_runs(f);
  if (way != stands) return f.tab.why_not_move(axis_);
  return f.now.axis_moves(axis_.index) ? "It moves." : "";
}

RunDoubt::AcceptedRun RunDoubt::draw(Frame& f, std::string_view where, const Rect& row,
                                     const std::string& text) {
  if (request_ == RunRequest::none) return {};
  const bool same_text = f.tab.desk().programs.texts.chosen() == run_.slot && text == text_;
  // The targets depend on the counts that are trusted.
  const bool other_doubts = doubted_ != doubts_of(f.now);
  if (!same_text || (other_doubts && !find_places(f, text)))
    return request_ = RunRequest::none, AcceptedRun();
  const std::uint32_t now = doubtful_axes(f.catalog, f.now, run_);
  if (now == 0 || is_beyond_travel(f)) return request_ = RunRequest::none, AcceptedRun();
  const bool shown_anew = other_doubts || now != doubtful_;
  if (shown_anew) describe(f, now);
  if (offered_ == 0 || counted_ != f.now.axes[axis_.index].position) offered_ = 0, name_remedies(f, where);
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
  if (touched.closed) request_ = RunRequest::none;
  if (touched.action < 0 || shown_anew) return {};  // the click was meant for the earlier question
  const Remedy way = offers_[static_cast<std::size_t>(touched.action)].way;
  if (way == once) return {std::exchange(request_, RunRequest::none), doubted_};
  go(f, way);
  return {};
}

void RunDoubt::go(Frame& f, Remedy way) const {
  if (way == stands) {
    f.send(stands_at(f.now, axis_, counted_));
    return;
  }
  const Sign sign = way == home_plus ? Sign::plus : Sign::minus;
  f.send(intent::Home(
      axis_, sign, homing_that_sets(f.catalog, -1, sign).value_or(0)));  // always present: homing was offered
}

}  // namespace hw::panels
