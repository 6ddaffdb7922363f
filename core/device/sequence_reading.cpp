#include "core/device/sequence_reading.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/sequence_draft.h"
#include "core/device/snapshot.h"
#include "core/device/tool_off.h"

namespace hw {
namespace {

/// So many rounds each leave one step as text; the next round leaves all later steps of its list.
constexpr int patient_rounds = 24;

bool is_own(const ReadStep& step) { return std::holds_alternative<sequence::Custom>(step.body); }

/// `at` as separate lines: complete where they hold no other command, none empty, and indented no further
/// than necessary.
std::string lines_of(std::string_view text, Stretch at, char mark) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::size_t begin = at.begin, end = at.end;
  while (begin > 0 && blank(text[begin - 1])) --begin;
  if (begin > 0 && text[begin - 1] != '\n') begin = at.begin;
  while (end < text.size() &&
         (blank(text[end]) || ((text[end] == ',' || text[end] == ';') && text[end] != mark)))
    ++end;
  if (end < text.size() && text[end] == mark) end = std::min(text.find('\n', end), text.size());
  if (end < text.size() && text[end] != '\n') end = at.end;
  std::vector<std::string_view> lines;
  std::size_t indent = std::string_view::npos;
  for (std::string_view rest = text.substr(begin, end - begin); !rest.empty();) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    while (!line.empty() && blank(line.back())) line.remove_suffix(1);
    if (line.empty()) continue;
    indent = std::min(indent, line.find_first_not_of(" \t"));
    lines.push_back(line);
  }
  std::string all;
  for (const std::string_view line : lines) all.append(all.empty() ? "" : "\n").append(line.substr(indent));
  return all;
}

class Proof {
 public:
  Proof(ReadText read, std::string_view text, const ReadingLanguage& language)
      : read_(std::move(read)), text_(text), language_(language) {}

  Result<SequenceRead> run() {
    const Operations ours = essentials(language_.operations(text_), read_.assumed);
    for (round_ = 0;; ++round_) {
      for (ReadSteps* list : lists()) merge(*list);
      sequence::Sequence made = sequence();
      const auto written = language_.write(made);
      if (!written) {
        if (!leave_refused(written.error().what)) return fail(written.error());
        continue;
      }
      const Operations theirs = essentials(language_.operations(written->text), {});
      const auto [our, their] =
          std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        [](const Operation& a, const Operation& b) { return a.text == b.text; });
      if (our == ours.end() && their == theirs.end()) return finish(std::move(made));
      if (!leave_difference(our == ours.end() ? nullptr : &*our, their == theirs.end() ? nullptr : &*their,
                            *written))
        return no_block_for(text_, our == ours.end() ? text_.size() : our->at.begin,
                            "no block can represent this, and blocks around it would change it.");
    }
  }

 private:
  /// The step made from a place in the text, or, if not `taken`, the place where it would be.
  struct Spot {
    ReadSteps* list = nullptr;
    std::size_t i = 0;
    bool taken = false;
  };

  std::array<ReadSteps*, 3> lists() { return {&read_.steps, &read_.pen_up, &read_.pen_down}; }

  static void merge(ReadSteps& list) {
    ReadSteps merged;
    for (ReadStep& step : list) {
      merge(step.inner);
      if (!merged.empty() && is_own(merged.back()) && is_own(step))
        merged.back().at.end = step.at.end;
      else
        merged.push_back(std::move(step));
    }
    list = std::move(merged);
  }

  // ---- the steps as a sequence

  [[nodiscard]] sequence::Sequence sequence() const {
    sequence::Sequence s;
    s.unit = read_.unit, s.axes = read_.axes;
    s.steps = steps_of(read_.steps), s.pen_up = steps_of(read_.pen_up), s.pen_down = steps_of(read_.pen_down);
    return s;
  }
  [[nodiscard]] sequence::StepList steps_of(const ReadSteps& list) const {
    sequence::StepList steps;
    for (const ReadStep& step : list) {
      sequence::Step& made = steps.emplace_back(sequence::Step{step.body});
      if (auto* own = std::get_if<sequence::Custom>(&made.body))
        own->text = lines_of(text_, step.at, language_.comment_mark);
      if (auto* loop = std::get_if<sequence::Repeat>(&made.body)) loop->steps = steps_of(step.inner);
    }
    return steps;
  }
  Result<SequenceRead> finish(sequence::Sequence made) {
    if (!has_block(read_.steps)) {
      for (const ReadStep& step : read_.steps)
        if (is_own(step))
          return no_block_for(
              text_, step.at.begin,
              std::get<sequence::Custom>(step.body).about + ". The rest is not a block either.");
      return fail(FaultKind::text, "The text contains no command.", blocks_unchanged);
    }
    return SequenceRead{std::move(made), std::move(read_.remarks)};
  }
  static bool has_block(const ReadSteps& list) {
    return std::any_of(list.begin(), list.end(), [](const ReadStep& step) {
      return !is_own(step) && !std::holds_alternative<sequence::Comment>(step.body) &&
             (step.inner.empty() || has_block(step.inner));
    });
  }

  // ---- where something stands

  static Spot spot_in(ReadSteps& list, std::size_t at) {
    std::size_t behind = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].inside.covers(at)) return spot_in(list[i].inner, at);
      if (list[i].at.covers(at)) return {&list, i, true};
      if (list[i].at.begin <= at) behind = i + 1;
    }
    return {&list, behind, false};
  }
  Spot spot_of(std::size_t at) {
    for (ReadSteps* list : lists())
      if (!list->empty() && list->front().at.begin <= at && at < list->back().at.end)
        return spot_in(*list, at);
    return spot_in(read_.steps, at);
  }
  /// As SequenceText counts them.
  static Spot numbered(ReadSteps& list, int& number) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (number-- == 0) return {&list, i, true};
      if (const auto* contour = std::get_if<sequence::Contour>(&list[i].body)) {
        const int inner = sequence::count_steps(contour->steps);
        if (number < inner) return {&list, i, true};
        number -= inner;
      }
      if (Spot found = numbered(list[i].inner, number); found.taken) return found;
    }
    return {};
  }

  // ---- what is left to the controller

  /// Keeps the first of the steps made from one command; returns its index.
  static std::size_t only_step_of(ReadSteps& list, std::size_t i) {
    const Stretch at = list[i].at;
    const auto same = [&at](const ReadStep& s) {
      return at.begin < at.end && s.at.begin == at.begin && s.at.end == at.end;
    };
    while (i > 0 && same(list[i - 1])) --i;
    while (i + 1 < list.size() && same(list[i + 1]))
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(i + 1));
    return i;
  }
  /// False: it was left already.
  bool leave(const Spot& spot, std::string_view why) {
    if (!spot.taken || is_own((*spot.list)[spot.i])) return false;
    const std::size_t first = only_step_of(*spot.list, spot.i);
    std::size_t end = round_ < patient_rounds ? first + 1 : spot.list->size();
    for (std::size_t i = first; i < end; ++i) {
      only_step_of(*spot.list, i);
      end = std::min(end, spot.list->size());
      ReadStep& step = (*spot.list)[i];
      step = own_text(std::string(why), step.at);
    }
    return true;
  }
  /// To be called once for each place.
  static bool leave_between(const Spot& spot, const Operation& operation) {
    if (operation.at.begin == operation.at.end) return false;
    spot.list->insert(spot.list->begin() + static_cast<std::ptrdiff_t>(spot.i),
                      own_text("no block represents this alone", operation.at));
    return true;
  }
  bool leave_refused(std::string_view refusal) {
    if (refusal.find(no_own_speed) != refusal.npos && leave_speeds()) return true;
    const auto path = refused_step(refusal);
    if (!path) return false;
    Spot spot{&read_.steps, 0, false};
    for (const std::size_t place : *path) {
      ReadSteps& list = spot.taken ? (*spot.list)[spot.i].inner : *spot.list;
      if (place >= list.size()) break;  // within a contour: the whole contour
      spot = {&list, place, true};
    }
    std::string_view why = refusal.substr(std::min(refusal.find("): ") + 3, refusal.size()));
    if (why.ends_with('.')) why.remove_suffix(1);
    return leave(spot, why);
  }
  bool leave_difference(const Operation* our, const Operation* their, const SequenceText& written) {
    constexpr std::string_view why = "blocks would write it differently";
    if (((our && our->speed) || (their && their->speed)) && leave_speeds()) return true;
    if (our) {
      const Spot spot = spot_of(our->at.begin);
      if (leave(spot, why) || (!spot.taken && leave_between(spot, *our))) return true;
      // Its setting comes from a command without a step.
      const Spot set = spot_of(our->set_at.begin);
      if (our->set_at.end > 0 && !set.taken) return leave_between(set, {.text = {}, .at = our->set_at});
    }
    if (!their) return false;
    int step = written.step_of_line[ix(line_of(written.text, their->at.begin))];
    return step >= 0 && leave(numbered(read_.steps, step), why);
  }
  /// Removes all speed steps, so that motions have no speeds. False: there are none.
  bool leave_speeds() {
    bool any = false;
    for (ReadSteps* list : lists()) any = leave_speeds(*list) || any;
    return any;
  }
  static bool leave_speeds(ReadSteps& list) {
    bool any = false;
    for (ReadStep& step : list) {
      any = leave_speeds(step.inner) || any;
      if (!std::holds_alternative<sequence::Speed>(step.body)) continue;
      step = own_text("speeds that only this text sets", step.at);
      any = true;
    }
    return any;
  }

  ReadText read_;
  const std::string_view text_;
  const ReadingLanguage& language_;
  int round_ = 0;
};

}  // namespace

/// The tool line is written again from the routines.
static void leave_out_tool_line(sequence::Sequence& sequence) {
  if (!uses_tool(sequence)) return;
  const std::string line = tool_off_line(tool_off_of(sequence, max_outputs));
  std::erase_if(sequence.steps, [&line](const sequence::Step& step) {
    const auto* comment = std::get_if<sequence::Comment>(&step.body);
    return comment && comment->text == line;
  });
}

Result<SequenceRead> prove(ReadText read, std::string_view text, const ReadingLanguage& language) {
  auto proved = Proof(std::move(read), text, language).run();
  if (proved) leave_out_tool_line(proved->sequence);
  return proved;
}

namespace {

/// The values of all settings at a place in the text.
class Settings {
 public:
  explicit Settings(const std::map<std::string, std::string>& assumed) {
    for (const auto& [name, value] : assumed) known_[name] = {value, {}};
  }
  void set(const Operation& operation) {
    if (operation.constant)
      known_[operation.sets] = {operation.text, operation.at};
    else
      known_.erase(operation.sets);
  }
  [[nodiscard]] bool is_set(const Operation& operation) const {
    const auto found = known_.find(operation.sets);
    return operation.constant && found != known_.end() && found->second.value == operation.text;
  }
  /// False: nobody knows.
  bool put_into(Operation& operation) const {
    const auto found = known_.find(operation.uses);
    const bool known = found != known_.end();
    operation.text.insert(0, (known ? found->second.value : "?") + " ");
    if (known) operation.set_at = found->second.at;
    return known;
  }
  /// After a block that may be skipped or repeated, the settings that it changes are unknown.
  void forget_changed_settings(const Operations& operations, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (operations[i].flow == Operation::Flow::changes_all) return known_.clear();
      if (!operations[i].sets.empty() && !is_set(operations[i])) known_.erase(operations[i].sets);
    }
  }
  void forget() { known_.clear(); }

 private:
  struct Value {
    std::string value;
    Stretch at;
  };
  std::map<std::string, Value> known_;
};

/// For each operation that begins a block: the index of its end.
std::vector<std::size_t> ends_of_blocks(const Operations& operations) {
  std::vector<std::size_t> ends(operations.size(), operations.size()), open;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    if (operations[i].flow == Operation::Flow::begins_block) open.push_back(i);
    if (operations[i].flow == Operation::Flow::ends_block && !open.empty())
      ends[open.back()] = i, open.pop_back();
  }
  return ends;
}

}  // namespace

Operations essentials(const Operations& operations, const std::map<std::string, std::string>& assumed) {
  const std::vector<std::size_t> ends = ends_of_blocks(operations);
  Operations kept;
  Settings now(assumed);
  std::vector<Settings> throughout;       // for each open block
  std::map<std::string, bool> all_known;  // by setting
  for (std::size_t i = 0; i < operations.size(); ++i) {
    Operation operation = operations[i];
    if (operation.flow == Operation::Flow::begins_block) {
      now.forget_changed_settings(operations, i + 1, ends[i]);
      throughout.push_back(now);
    } else if (operation.flow == Operation::Flow::changes_all) {
      now.forget();
    } else if (operation.flow != Operation::Flow::on && !throughout.empty()) {
      now = throughout.back();
      if (operation.flow == Operation::Flow::ends_block) throughout.pop_back();
    }
    if (!operation.uses.empty()) {
      const bool known = now.put_into(operation);
      const auto [used, first] = all_known.try_emplace(operation.uses, known);
      if (!first) used->second = used->second && known;
    }
    if (!operation.sets.empty() && now.is_set(operation)) continue;
    if (!operation.sets.empty()) now.set(operation);
    kept.push_back(std::move(operation));
  }
  std::erase_if(kept, [&all_known](const Operation& operation) {
    const auto used = all_known.find(operation.sets);
    return used != all_known.end() && used->second;
  });
  return kept;
}

ReadText::ReadText(const sequence::Sequence& frame, const Catalog& catalog)
    : unit(frame.unit), axes(frame.axes) {
  if (!axes.empty()) return;
  unit = catalog.step_word;
  for (const AxisInfo& axis : catalog.axes)
    if (axes.size() < max_axes) axes.push_back({axis.name});
}

int ReadText::place_of(const Catalog& catalog, int axis) const {
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (catalog.find_axis(axes[a].name) == axis) return static_cast<int>(a);
  return -1;
}

int line_of(std::string_view text, std::size_t at) {
  return static_cast<int>(
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
}

tl::unexpected<Fault> no_block_for(std::string_view text, std::size_t at, std::string_view why) {
  return fail(FaultKind::text, fmt::format("Line {}: {}", line_of(text, at) + 1, why), blocks_unchanged);
}

}  // namespace hw
