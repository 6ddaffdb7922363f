#include "panels/program/run_from.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"
#include "core/sequence/places_before.h"
#include "core/sequence/within_loop.h"
#include "core/sequence/words.h"
#include "gui/model/run_places.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/message.h"
#include "panels/program/run_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

/// "axis X at 3.000 mm, axis Y at 4.000 mm": the positions of the axes that are sent to a target.
std::string standing_at(const Frame& f, const sequence::Rest& rest) {
  std::string all;
  for (std::size_t a = 0; a < rest.sequence.axes.size(); ++a) {
    const int place = f.catalog.find_axis(rest.sequence.axes[a].name);
    if (!rest.start[a] || place < 0) continue;
    const AxisId id{static_cast<std::uint8_t>(place)};
    const AxisState& axis = f.now.axes[id.index];
    all += fmt::format("{}{} at {}", all.empty() ? "" : ", ", spoken_name(f.catalog, place),
                       axis.position_known ? format_with_unit(axis.position, f.tab.settings.unit(id)).view()
                                           : std::string_view("an unknown position"));
  }
  return all;
}

/// The start positions of a sequence if it were run now.
sequence::Places standing_now(const Frame& f, const sequence::Sequence& of) {
  sequence::Places places;
  for (std::size_t a = 0; a < of.axes.size(); ++a) {
    const int axis = f.catalog.find_axis(of.axes[a].name);
    if (axis < 0 || !f.now.axes[ix(axis)].position_known || !is_moved(of, static_cast<int>(a))) continue;
    places[a] = static_cast<double>(f.now.axes[ix(axis)].commanded().value) / of.axes[a].per_unit;
  }
  return places;
}

/// Why the axes cannot be sent to the start of the rest; empty: they can.
std::string why_not_sent_there(const Frame& f, const sequence::Rest& rest,
                               std::span<const RehearsedAxis> rehearsed) {
  for (std::size_t a = 0; a < rest.sequence.axes.size(); ++a) {
    const std::string& name = rest.sequence.axes[a].name;
    const int axis = f.catalog.find_axis(name);
    if (axis < 0 || (!rest.start[a] && !is_moved(rest.sequence, static_cast<int>(a)))) continue;
    const AxisState& now = f.now.axes[ix(axis)];
    if (!now.position_known)
      return fmt::format(
          "The position of {} is not known. Nothing was started. Home it, or set its position, then ask "
          "again.",
          spoken_name(f.catalog, axis));
    for (const RehearsedAxis& then : rehearsed)
      if (then.name == name && then.in_counts != now.in_counts)
        return fmt::format(
            "{} counts in other units than in the rehearsal. Nothing was started. Simulate it again.", name);
  }
  return why_not_run_there(f.tab, rest.sequence);
}

bool mentions_a_tool(const sequence::Rest& rest) {
  for (std::size_t i = 0; i < rest.leading; ++i)
    if (std::holds_alternative<sequence::Pen>(rest.sequence.steps[i].body)) return true;
  return false;
}

}  // namespace

Result<RunFrom::Wanted> RunFrom::wanted_of(const sequence::Sequence& of, const Place& place,
                                           const sequence::Places& begin) {
  const auto rehearsed = place.begun ? sequence::Rehearsed::yes : sequence::Rehearsed::no;
  if (const auto within = sequence::loops_around(of, place.step)) {
    auto pass = place.pass;
    if (!pass && within->times == 1) pass = 0;
    if (!pass && place.axes.empty()) return fail(sequence::step_to_begin_at(of, place.step).error());
    if (!pass)
      return fail(
          FaultKind::refused,
          fmt::format("The line lies within the loop of step {}, and the path does not show in which pass.",
                      within->loop + 1),
          "Nothing was started.", std::string(choose_pass));
    auto found = sequence::rest_within(of, place.step, *pass, begin, rehearsed);
    if (!found) return fail(found.error());
    return Wanted{std::move(found->rest), std::move(found->begins)};
  }
  const auto at = sequence::step_to_begin_at(of, place.step);
  if (!at) return fail(at.error());
  auto rest = sequence::rest_from(of, *at, begin, rehearsed);
  if (!rest) return fail(rest.error());
  const sequence::Step::Body& first = of.steps[*at].body;
  return Wanted{std::move(*rest), fmt::format("step {}, {} {}", *at + 1, sequence::title_of(first),
                                              sequence::summary_of(first, of))};
}

void RunFrom::ask(Frame& f, const sequence::Sequence& of, const Place& place) {
  go_ahead_ = f.tab.desk().until_stopped();
  auto wanted = wanted_of(of, place, place.axes.empty() ? standing_now(f, of) : begin_of(place.axes, of));
  if (wanted && place.begun) {
    const std::string step = wanted->begins.substr(0, wanted->begins.find(','));
    if (auto fault = otherwise_rehearsed(wanted->rest, *place.begun, step, "steps", f.catalog))
      wanted = tl::unexpected(std::move(*fault));
  }
  if (wanted) {
    wanted->axes.assign(place.axes.begin(), place.axes.end());
    wanted->counts_from_now = place.axes.empty() && !wanted_of(of, place, {});
  }
  ask(f, std::move(wanted));
}

void RunFrom::ask(Frame& f, PlaceToBegin place) {
  Desk& desk = f.tab.desk();
  if (!desk.programs.language() || std::exchange(reading_, true)) return;
  go_ahead_ = desk.until_stopped();
  auto frame = sequence::frame_of(desk.blocks.editor.sequence());
  frame.pen_up.clear(), frame.pen_down.clear();
  desk.work.worker().run(
      [language = desk.programs.language(), place = std::move(place), frame = std::move(frame),
       catalog = std::make_shared<const Catalog>(f.catalog)] {
        auto found = rest_of_text(*language, place, frame, *catalog);
        if (!found) return Result<Wanted>(tl::unexpected(found.error()));
        return Result<Wanted>(
            Wanted{std::move(found->rest), std::move(found->begins), place.text, place.axes});
      },
      [this](Result<Wanted> wanted) { read_ = std::move(wanted), reading_ = false; }, alive_);
  f.ui.wake_in(0);
}

void RunFrom::ask(Frame& f, Result<Wanted> wanted) {
  const Language* language = f.tab.desk().programs.language();
  if (!language) return;
  if (!wanted) return refuse(wanted.error().sentence());
  if (std::string why = why_not_sent_there(f, wanted->rest, wanted->axes); !why.empty())
    return refuse(std::move(why));
  auto written = language->write(wanted->rest.sequence, f.catalog);
  if (!written) return refuse(written.error().sentence());
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  if (!wanted->text.empty() && texts.text(texts.chosen()) != wanted->text)
    return refuse("The text has been changed since. Nothing was started.");
  rest_ = std::move(wanted->rest), written_ = std::move(*written);
  replaces_ = texts.edited(texts.chosen());
  asking_ = true;
  compose_question(f, *wanted);
}

void RunFrom::compose_question(const Frame& f, const Wanted& wanted) {
  const std::string at = standing_at(f, rest_);
  question_ = at.empty() ? std::string() : fmt::format("Now: {}.\n", at);
  question_ += fmt::format("First: {}\n", words_of_leading(rest_));
  question_ += fmt::format("Then {}, and everything after it.", wanted.begins);
  if (wanted.counts_from_now)
    question_ += "\nDistances above it are counted from the present positions of the axes.";
  if (rest_.leaves_homing_out) question_ += "\nHoming is skipped: the counts are trusted.";
  if (!mentions_a_tool(rest_))
    question_ += "\nMake sure that nothing is in the way: no step mentions a tool.";
  question_ += replaces_ ? "\nThe text of the program has unsaved changes and is replaced."
                         : "\nThe text of the program is replaced.";
}

void RunFrom::run(Frame& f) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  f.tab.desk().programs.source.put({std::make_shared<const sequence::Sequence>(rest_.sequence), written_});
  texts.set_text(texts.chosen(), written_.text);
  if (go_ahead_.expired()) return refuse(std::string(put_but_not_run));
  std::string why(why_no_new_run(f));
  if (why.empty()) why = why_not_run_there(f.tab, written_.text);
  if (!why.empty()) return refuse(std::move(why));
  begin_run(f, RunRequest::run);
}

void RunFrom::draw_dialog(Frame& f, std::string_view where) {
  if (auto wanted = std::exchange(read_, std::nullopt)) ask(f, std::move(*wanted));
  if (!asking_) return;
  const Dialog what{.title = "Run from here?",
                    .sentences = question_,
                    .yes = "Go there and run",
                    .no = "Leave it",
                    .moving = true};
  if (dialog(f.ui, Path("{}/run_from", where), asking_, what) == Answer::yes) run(f);
}

std::optional<drawing::Point3> RunFrom::goes_to(const Frame& f, const PathAxes& axes) const {
  if (!asking_) return std::nullopt;
  auto at = place_now(f, axes);
  if (!at) return std::nullopt;
  const Directions all = directions_of(f, axes);
  for (std::size_t n = 0; n < all.count; ++n)
    for (std::size_t a = 0; a < rest_.sequence.axes.size(); ++a) {
      const sequence::Axis& axis = rest_.sequence.axes[a];
      if (!all.all[n].tab || axis.name != all.all[n].name || !rest_.start[a]) continue;
      along(*at, n) = from_steps(Steps(std::llround(*rest_.start[a] * axis.per_unit)), all.all[n].unit());
    }
  return at;
}

}  // namespace hw::panels
