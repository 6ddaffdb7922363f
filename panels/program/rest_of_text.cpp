#include "panels/program/rest_of_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/settings_in_text.h"
#include "core/sequence/places_before.h"
#include "core/sequence/steps_in.h"
#include "core/sequence/within_loop.h"
#include "core/sequence/words.h"
#include "gui/model/program_texts.h"

namespace hw::panels {

namespace seq = sequence;
namespace {

tl::unexpected<Fault> not_from(std::string why, std::string advice = {}) {
  return fail(FaultKind::refused, std::move(why), "Nothing was started.", std::move(advice));
}

// ---- finding the step

struct StepOfPlace {
  seq::Sequence sequence;
  int counted = 0;  ///< as SequenceText counts
};

/// Removes the line with this mark from its comment, and adds the steps before that place to `counted`.
/// False: no comment has the mark, or no step follows it.
bool take_out(seq::StepList& steps, std::string_view mark, int& counted) {
  for (std::size_t i = 0; i < steps.size(); ++i, ++counted) {
    if (auto* comment = std::get_if<seq::Comment>(&steps[i].body)) {
      std::string& text = comment->text;
      const std::size_t at = text.find(mark);
      if (at == text.npos) continue;
      const bool first = at == 0, last = at + mark.size() == text.size();
      text.erase(first || !last ? at : at - 1, mark.size() + (first && last ? 0 : 1));
      if (first && last) steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(i));
      return i + (last && !first ? 1 : 0) < steps.size();
    }
    if (seq::StepList* inner = steps_in(steps[i])) {
      int within = counted + 1;
      if (take_out(*inner, mark, within)) return counted = within, true;
      counted += seq::count_steps(*inner);
    }
  }
  return false;
}

/// Finds the step of a command: puts a remark before the command and reads the text with it. If the steps are
/// otherwise the same, the command begins the step after the remark.
class Finder {
 public:
  Finder(const Language& language, const PlaceToBegin& place, const seq::Sequence& frame,
         const Catalog& catalog)
      : language_(language), place_(place), frame_(frame), catalog_(catalog) {
    while (place.text.find(mark_) != std::string::npos) mark_ += "@";
  }

  Result<StepOfPlace> find() {
    auto read = language_.read(place_.text, frame_, catalog_);
    if (!read)
      return not_from(fmt::format(
          "The state at that line is known only for text that blocks can represent. {}", read.error().what));
    for (const std::size_t at : places_in_line())
      if (const int counted = step_at(at, read->sequence); counted >= 0)
        return StepOfPlace{std::move(read->sequence), counted};
    return not_from(fmt::format("Line {} is within text that blocks cannot represent.", place_.line + 1),
                    "Begin at another line.");
  }

 private:
  /// The place of the command, then those of earlier commands in the line, which may belong to the same step.
  [[nodiscard]] std::vector<std::size_t> places_in_line() const {
    std::size_t begin = 0;
    for (int line = 0; line < place_.line; ++line) begin = place_.text.find('\n', begin) + 1;
    const ProgramReport report = language_.analyse(place_.text, 0);
    std::vector<std::size_t> all{begin + ix(place_.byte)};
    if (ix(place_.line) >= report.lines.size()) return all;
    const std::vector<Token>& tokens = report.lines[ix(place_.line)].tokens;
    for (auto token = tokens.rbegin(); token != tokens.rend(); ++token)
      if (token->begin < place_.byte) all.push_back(begin + ix(token->begin));
    return all;
  }
  /// The step that begins at a place; -1: none.
  [[nodiscard]] int step_at(std::size_t at, const seq::Sequence& plain) const {
    const bool within_line = at > 0 && place_.text[at - 1] != '\n';
    std::string marked = place_.text;
    marked.insert(at, fmt::format("{}{} {}\n", within_line ? "\n" : "", catalog_.program.comment, mark_));
    auto read = language_.read(marked, frame_, catalog_);
    int counted = 0;
    if (!read || !take_out(read->sequence.steps, mark_, counted)) return -1;
    return read->sequence == plain ? counted : -1;
  }

  const Language& language_;
  const PlaceToBegin& place_;
  const seq::Sequence& frame_;
  const Catalog& catalog_;
  std::string mark_ = "@here@";
};

// ---- the state at that place

/// The last of these steps that leaves an unknown state behind.
template <class Is>
const seq::Step* last_such(const seq::StepList& steps, std::size_t count, Is is) {
  for (std::size_t i = std::min(count, steps.size()); i-- > 0;) {
    if (steps[i].skipped) continue;
    if (is(steps[i].body)) return &steps[i];
    const seq::StepList* inner = steps_in(steps[i]);
    if (const seq::Step* found = inner ? last_such(*inner, inner->size(), is) : nullptr) return found;
  }
  return nullptr;
}

seq::OnlySets only_sets_of(const Language& language) {
  const auto* settings = dynamic_cast<const SettingsInText*>(&language);
  if (!settings) return {};
  return [settings](const seq::Custom& own) { return settings->only_sets(own.text); };
}
bool ends_at_unknown_place(const seq::Step::Body& body) {
  return std::holds_alternative<seq::Home>(body) || std::holds_alternative<seq::Jog>(body) ||
         std::holds_alternative<seq::Stop>(body) || std::holds_alternative<seq::MoveOnInput>(body);
}
bool has_no_end(const seq::Step::Body& body) {
  const auto* loop = std::get_if<seq::Repeat>(&body);
  return loop && loop->times == 0;
}

/// The index, in the list, of the step itself or of the outermost step around it.
std::size_t outermost(const seq::StepList& steps, int counted) {
  std::size_t i = 0;
  for (; i < steps.size(); ++i) {
    const seq::StepList* inner = steps_in(steps[i]);
    const int size = 1 + (inner ? seq::count_steps(*inner) : 0);
    if (counted < size) break;
    counted -= size;
  }
  return i;
}

/// The fault in terms of the text, because the user has never seen the steps.
tl::unexpected<Fault> why_not_known(const StepOfPlace& step, const PlaceToBegin& place, const Fault& fault,
                                    const seq::OnlySets& only_sets) {
  const auto is_own_text = [&](const seq::Step::Body& body) {
    const auto* own = std::get_if<seq::Custom>(&body);
    return own && !(only_sets && only_sets(*own));
  };
  const seq::StepList& steps = step.sequence.steps;
  const std::size_t before = outermost(steps, step.counted);
  const bool in_loop = before < steps.size() && std::holds_alternative<seq::Repeat>(steps[before].body);
  if (const seq::Step* own = last_such(steps, before + (in_loop ? 1 : 0), is_own_text)) {
    const std::string& text = std::get<seq::Custom>(own->body).text;
    return not_from(fmt::format("The state after \"{}\" above line {} is unknown.",
                                text.substr(0, text.find('\n')), place.line + 1),
                    "Begin at that command, or above it.");
  }
  if (last_such(steps, before, has_no_end))
    return not_from(
        fmt::format("A loop above line {} has no end: the line is never reached.", place.line + 1));
  if (const seq::Step* lost = last_such(steps, before + (in_loop ? 1 : 0), ends_at_unknown_place))
    return not_from(
        fmt::format(
            "The position before line {} is unknown: the machine decides where \"{} {}\" above it ends.",
            place.line + 1, title_of(lost->body), summary_of(lost->body, step.sequence)),
        "Begin at that command, or after a command that sends the axis to a place.");
  return not_from(fault.what, fault.advice);
}

Result<seq::Rest> rest_there(const StepOfPlace& step, const std::optional<std::int64_t>& pass_in_loop,
                             const seq::Places& begin, seq::Rehearsed rehearsed,
                             const seq::OnlySets& only_sets) {
  if (pass_in_loop) {
    auto found = seq::rest_within(step.sequence, step.counted, *pass_in_loop, begin, rehearsed, only_sets);
    return found ? Result<seq::Rest>(std::move(found->rest)) : tl::unexpected(found.error());
  }
  const auto at = seq::step_to_begin_at(step.sequence, step.counted);
  return at ? seq::rest_from(step.sequence, *at, begin, rehearsed, only_sets) : tl::unexpected(at.error());
}

}  // namespace

std::optional<std::array<RehearsedPlace, 2>> begun_between(const Rehearsal& rehearsal,
                                                           std::span<const int> source_of_command, int source,
                                                           std::optional<int> pass) {
  std::optional<double> begun;
  int times = 0, at = -1, at_command = -1;
  for (const RehearsedTurn& turn : rehearsal.turns) {
    if (turn.command < 0 || ix(turn.command) >= source_of_command.size()) continue;
    const int here = source_of_command[ix(turn.command)];
    const bool anew = here != at || turn.command <= at_command;
    at = here, at_command = turn.command;
    if (here == source && anew && times++ == pass.value_or(0)) begun = turn.t;
  }
  if (!begun || (!pass && times > 1) || rehearsal.track.empty()) return std::nullopt;
  const auto next = std::lower_bound(rehearsal.track.begin(), rehearsal.track.end(), *begun,
                                     [](const RehearsedPlace& p, double t) { return p.t < t; });
  const RehearsedPlace& behind = next == rehearsal.track.end() ? rehearsal.track.back() : *next;
  return std::array{next == rehearsal.track.begin() ? behind : *(next - 1), behind};
}

seq::Places begin_of(std::span<const RehearsedAxis> axes, const seq::Sequence& sequence) {
  seq::Places begin;
  for (std::size_t a = 0; a < sequence.axes.size(); ++a) {
    const seq::Axis& own = sequence.axes[a];
    for (const RehearsedAxis& axis : axes)
      if (axis.name == own.name && (axis.travel > 0 || is_moved(sequence, static_cast<int>(a))))
        begin[a] = static_cast<double>(axis.begin) / own.per_unit;
  }
  return begin;
}

std::optional<Fault> otherwise_rehearsed(const seq::Rest& rest, const std::array<RehearsedPlace, 2>& begun,
                                         std::string_view what, std::string_view above,
                                         const Catalog& catalog) {
  for (std::size_t a = 0; a < rest.sequence.axes.size(); ++a) {
    const seq::Axis& axis = rest.sequence.axes[a];
    const int i = catalog.find_axis(axis.name);
    if (!rest.start[a] || i < 0) continue;
    const std::int64_t start = std::llround(*rest.start[a] * axis.per_unit);
    const auto [low, high] = std::minmax(begun[0].position[ix(i)], begun[1].position[ix(i)]);
    if (start >= low - 1 && start <= high + 1) continue;
    return not_from(fmt::format("In the rehearsal {} was not at {} {} at the start of {}, although the {} "
                                "above it send the axis there.",
                                axis.name, start, catalog.step_word, what, above),
                    fmt::format("Begin at a {} that starts when all axes are at rest.",
                                what.substr(0, what.find(' '))))
        .value();
  }
  return std::nullopt;
}

Result<RestOfText> rest_of_text(const Language& language, const PlaceToBegin& place,
                                const seq::Sequence& frame, const Catalog& catalog) {
  auto step = Finder(language, place, frame, catalog).find();
  if (!step) return tl::unexpected(step.error());
  std::optional<std::int64_t> pass_in_loop;
  if (const auto within = seq::loops_around(step->sequence, step->counted)) {
    if (!place.pass && within->times != 1)
      return not_from(fmt::format("Line {} lies within a loop, and the path does not show in which pass.",
                                  place.line + 1),
                      std::string(choose_pass));
    pass_in_loop = place.pass.value_or(0);
  }
  const seq::OnlySets only_sets = only_sets_of(language);
  auto rest = rest_there(*step, pass_in_loop, begin_of(place.axes, step->sequence),
                         place.begun ? seq::Rehearsed::yes : seq::Rehearsed::no, only_sets);
  if (!rest) return why_not_known(*step, place, rest.error(), only_sets);
  const std::string line = fmt::format("line {}", place.line + 1);
  if (!place.begun)
    return not_from(fmt::format("The rehearsal does not show the positions at the start of {}.", line),
                    "Begin at a line that moves an axis.");
  if (auto fault = otherwise_rehearsed(*rest, *place.begun, line, "commands", catalog))
    return fail(std::move(*fault));
  const std::string pass = pass_in_loop ? fmt::format(", pass {}", *pass_in_loop + 1) : std::string();
  std::string_view command = gui::line_of(place.text, place.line);
  command = command.substr(std::min(command.size(), ix(place.byte)));
  command = command.substr(0, command.find_last_not_of(", ;\r\t") + 1);
  for (seq::Step& leading : rest->sequence.steps)
    if (auto* comment = std::get_if<seq::Comment>(&leading.body)) {
      comment->text = fmt::format("From line {}{} on.", place.line + 1, pass);
      break;
    }
  return RestOfText{std::move(*rest), fmt::format("line {}, {}{}", place.line + 1, command, pass)};
}

}  // namespace hw::panels
