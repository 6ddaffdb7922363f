// Stored programs: writing and comparing, reading, selecting.
#include <algorithm>
#include <map>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/refusals.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/slots.h"

namespace hw::vxm {
namespace {

/// One item to be sent: a command, a pair of indexes in parentheses, or text in brackets for the Slave.
struct Entry {
  std::string text;                    ///< with its ender
  std::vector<std::string> canonical;  ///< as lst shows it, command by command; empty: lst does not show it
  int cost = 0;
};
struct Plan {
  std::map<int, std::vector<Entry>> slots;
  std::string left_out;  ///< commands of the text that are no part of a program
  bool clears = false;   ///< a heading says that its program is to be emptied (PM-x)
  [[nodiscard]] bool stores_nothing() const {
    return std::all_of(slots.begin(), slots.end(), [](const auto& slot) { return slot.second.empty(); });
  }
};

int line_of(std::string_view text, std::size_t place) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\r'));
}

std::string with_carriage_returns(std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n' && i > 0 && text[i - 1] == '\r') continue;
    all += text[i] == '\n' ? '\r' : text[i];
  }
  if (!all.ends_with('\r')) all += '\r';
  return all;
}

tl::unexpected<Fault> bad_line(int line, const std::string& what) {
  return fail(FaultKind::text, fmt::format("Line {}: {}", line, what),
              "Nothing was sent; the controller keeps its programs.", "Correct the line and load it again.");
}

bool is_digit_after_period(const TextCommand& c) {  // "5080.0": the period ends the number, the 0 is dropped
  return c.flaw == Flaw::unknown && c.name.size() == 1 && c.name[0] >= '0' && c.name[0] <= '9';
}

// Plans the loading of a text: commands per program, short forms with their motor written out.
class Planner {
 public:
  Planner(std::string_view text, int first_slot) : text_(text), slot_(first_slot) {
    if (slot_ >= 0) plan_.slots[slot_];
  }

  Result<Plan> plan() {
    for (const TextCommand& c : read_text(text_)) {
      if (is_digit_after_period(c)) continue;
      if (auto good = take(c); !good) return fail(good.error());
    }
    for (const auto& [number, entries] : plan_.slots)
      if (auto fits = check_size(number, entries); !fits) return fail(fits.error());
    return std::move(plan_);
  }

 private:
  Result<> take(const TextCommand& c) {
    if (auto good = check_spelling(c); !good) return good;
    if (c.verb == Verb::slave_begins) slave_begin_ = c.begin;
    if (slave_begin_ != nowhere) {
      take_for_slave(c);
    } else if (c.verb == Verb::select || c.verb == Verb::empty) {
      choose_slot(c);
    } else if (!c.stored()) {
      leave_out(c);
    } else if (slot_ < 0) {
      return bad_line(line_of(text_, c.begin), "it comes before the first program heading (PM-0 to PM-4).");
    } else {
      store(c);
    }
    return {};
  }

  [[nodiscard]] Result<> check_spelling(const TextCommand& c) const {
    const int line = line_of(text_, c.begin);
    if (c.flaw == Flaw::unknown)
      return bad_line(line, fmt::format("{} is not a command of the VXM.", c.name));
    if (c.flaw == Flaw::no_value || c.flaw == Flaw::open)
      return bad_line(line, fmt::format("{} lacks its number.", c.name));
    if (c.flaw == Flaw::range)
      return bad_line(line, fmt::format("{} is not possible: it takes {}.", canonical(c), allowed_values(c)));
    return {};
  }

  /// Text in brackets is sent to the Slave as written.
  void take_for_slave(const TextCommand& c) {
    if (c.verb != Verb::slave_ends) return;
    Entry for_slave;
    for_slave.text = std::string(text_.substr(slave_begin_, c.end - slave_begin_));
    slave_begin_ = nowhere;
    plan_.slots[std::max(slot_, 0)].push_back(std::move(for_slave));
  }

  void choose_slot(const TextCommand& c) {
    slot_ = static_cast<int>(c.value);
    if (c.verb == Verb::empty) plan_.slots[slot_].clear(), plan_.clears = true;
    plan_.slots[slot_];
    pair_ = nullptr;
  }

  /// A command that acts at once is no part of a program. Commands that only switch on-line are not reported.
  void leave_out(const TextCommand& c) {
    const bool needless =
        c.verb == Verb::letter && std::string_view("EFGC").find(c.letter) != std::string_view::npos;
    if (needless) return;
    plan_.left_out += fmt::format("{}{} in line {}", plan_.left_out.empty() ? "" : ", ", canonical(c),
                                  line_of(text_, c.begin));
  }

  /// Two indexes in parentheses are one entry.
  void store(const TextCommand& c) {
    auto& entries = plan_.slots[slot_];
    if (c.verb == Verb::pair_begins) pair_ = &entries.emplace_back();
    Entry& entry = pair_ ? *pair_ : entries.emplace_back();
    const bool bracket = c.verb == Verb::pair_begins || c.verb == Verb::pair_ends;
    entry.text += canonical(c) + (bracket ? "" : pair_ ? "," : "\r");
    entry.canonical.push_back(canonical(c));
    entry.cost += program_cost(c);
    if (c.verb == Verb::pair_ends) pair_ = nullptr;
  }

  static Result<> check_size(int number, const std::vector<Entry>& entries) {
    int cost = 0;
    for (const Entry& e : entries) cost += e.cost;
    if (cost <= program_bytes) return {};
    return fail(FaultKind::refused,
                fmt::format("Program {} needs {} bytes, {} more than the {} that it has.", number, cost,
                            cost - program_bytes, program_bytes),
                "Nothing was sent; the controller keeps its programs.",
                "Shorten the program, or move a part into another program (JM).");
  }

  static constexpr std::size_t nowhere = std::string_view::npos;
  const std::string_view text_;
  Plan plan_;
  int slot_;
  Entry* pair_ = nullptr;              ///< entry of the open parentheses
  std::size_t slave_begin_ = nowhere;  ///< of the open brackets
};

Result<Plan> plan_of(std::string_view text, int first_slot) { return Planner(text, first_slot).plan(); }

// `SmM-x` is listed as the speed that the analog input gives now (App. I p.53).
bool same_command(const std::string& sent, const TextCommand& held) {
  if (sent == canonical(held)) return true;
  const auto wanted = read_text(sent + '\r');
  return wanted.size() == 1 && wanted[0].verb == Verb::speed_analog && held.verb == Verb::speed &&
         wanted[0].motor == held.motor && wanted[0].full_power == held.full_power;
}

}  // namespace

// ---- writing

Task<Result<>> Slots::load(const intent::LoadProgram& request) {
  if (auto may = may_touch_(); !may) co_return may;
  const std::string text = with_carriage_returns(request.text);
  auto plan = plan_of(text, request.slot);
  if (!plan) co_return fail(plan.error());
  if (plan->stores_nothing() && !plan->clears && !plan->left_out.empty())
    co_return fail(FaultKind::text,
                   fmt::format("Nothing in this text is part of a program: {}.", plan->left_out),
                   "Nothing was sent; the controller keeps its programs.",
                   "Commands that act at once are sent, not loaded.");
  if (selected_ < 0) {
    auto read = co_await read_sizes();
    if (!read) co_return read;
  }
  Result<> loaded;
  for (const auto& [slot, entries] : plan->slots) {
    Lines lines, expected;
    for (const Entry& e : entries) {
      lines.push_back(e.text);
      expected.insert(expected.end(), e.canonical.begin(), e.canonical.end());
    }
    loaded = co_await load_slot(slot, lines, expected);
    if (!loaded) break;
  }
  if (!loaded) co_return loaded;
  if (!plan->left_out.empty())
    console_.report(Notice::Kind::info,
                    fmt::format("Not part of a program and so not sent: {}.", plan->left_out));
  (void)co_await give_back_selection();  // else the next round does
  co_return loaded;
}

// Lines may be written twice without harm.
Task<Result<>> Slots::load_slot(int slot, const Lines& lines, const Lines& expected) {
  auto chosen = co_await choose(slot, Priority::transfer);
  if (!chosen) co_return chosen;
  const std::uint8_t mark = torn_bit(console_.catalog, slot);
  console_.snapshot.slots_torn |= mark;
  doubt(slot);
  console_.snapshot.unsaved_programs = true;
  progress_.begin(slot, console_.scheduler.now());
  auto loaded = co_await write_slot(slot, lines, expected);
  if (!loaded && loaded.error().kind == FaultKind::garbled && !conversation_.listens().halted) {
    chosen = co_await choose(slot, Priority::transfer);
    if (chosen) loaded = co_await write_slot(slot, lines, expected);
  }
  progress_.end();
  if (loaded) console_.snapshot.slots_torn = static_cast<std::uint8_t>(console_.snapshot.slots_torn & ~mark);
  co_return loaded;
}

Task<Result<>> Slots::write_slot(int slot, const Lines& lines, const Lines& expected) {
  auto sent = co_await send_lines(lines);
  const auto may = may_touch_();
  if (conversation_.listens().halted && !may)
    co_return fail(FaultKind::controller, may.error().what, incomplete(slot), may.error().advice);
  if (!sent)
    co_return fail(sent.error().kind, sent.error().what, incomplete(slot), "Load it again before it is run.");
  progress_.enter(TransferState::Phase::comparing, 0);
  co_return co_await verify_slot(slot, expected);
}

// The listing afterwards takes about as long as the sending.
Task<Result<>> Slots::send_lines(const Lines& lines) {
  const int count = static_cast<int>(lines.size());
  progress_.enter(TransferState::Phase::writing, count);
  progress_.expect(2 * count);
  auto sent = co_await conversation_.transmit("C", Priority::transfer);
  for (std::size_t i = 0; i < lines.size() && sent && !conversation_.listens().halted; ++i) {
    sent = co_await conversation_.transmit(lines[i], Priority::transfer);
    if (!sent) break;
    const Instant now = console_.scheduler.now();
    progress_.line_done();
    progress_.worked(now);
    if (progress_.is_news(now)) console_.changed();
  }
  co_return sent;
}

std::string Slots::incomplete(int slot) const {
  const TransferState& t = console_.snapshot.transfer;
  const std::string written = report_written(t);
  const bool all = t.phase == TransferState::Phase::writing && t.total > 0 && t.done >= t.total;
  return fmt::format("Program {} {} in the controller{}{}.", slot,
                     all ? "may be incomplete" : "is incomplete", written.empty() ? "" : ": ", written);
}

Task<Result<>> Slots::verify_slot(int slot, const Lines& expected) {
  auto listing = co_await conversation_.listing(Priority::transfer);
  if (!listing)
    co_return fail(
        listing.error().kind,
        fmt::format("Program {} was sent but could not be read back: {}", slot, listing.error().what),
        "It was not run.", "Load it again before it is run.");
  holds(slot, *listing);
  const auto held = commands_of(listing->commands);
  for (std::size_t i = 0; i < std::max(held.size(), expected.size()); ++i) {
    if (i < held.size() && i < expected.size() && same_command(expected[i], held[i])) continue;
    const std::string wanted = i < expected.size() ? expected[i] : "nothing more";
    const std::string found = i < held.size() ? canonical(held[i]) : "nothing more";
    co_return fail(
        FaultKind::garbled,
        fmt::format("Program {} differs in the controller: command {} was sent as {}, and reads back as {}.",
                    slot, i + 1, wanted, found),
        "It was not run.", "Load it again before it is run.");
  }
  if (listing->slot != slot)
    co_return fail(FaultKind::garbled,
                   fmt::format("Program {} was to be written, but the controller lists program {}.", slot,
                               listing->slot),
                   "It was not run.", "Load it again before it is run.");
  co_return Result<>();
}

Task<Result<>> Slots::clear(int slot) {
  if (auto may = may_touch_(); !may) co_return may;
  const Lines nothing;
  auto cleared = co_await load_slot(slot, nothing, nothing);
  if (cleared) (void)co_await give_back_selection();
  co_return cleared;
}

// ---- reading

Task<Result<>> Slots::upload(int slot) {
  if (auto may = may_touch_(); !may) co_return may;
  auto chosen = co_await choose(slot, Priority::transfer);
  if (!chosen) co_return chosen;
  progress_.begin(slot, console_.scheduler.now());
  console_.changed();
  auto listing = co_await conversation_.listing(Priority::transfer);
  progress_.end();
  if (!listing) co_return fail(listing.error());
  if (listing->slot != slot)
    co_return fail(
        FaultKind::garbled,
        fmt::format("Program {} was requested, but the controller shows program {}.", slot, listing->slot),
        "Nothing was changed.", "Read it again.");
  holds(slot, *listing);
  std::string text;
  for (const std::string& command : listing->commands) text += command + "\n";
  Notice notice(Notice::Kind::program, console_.scheduler.now(), std::move(text));
  notice.slot = slot;
  if (console_.notify) console_.notify(std::move(notice));
  (void)co_await give_back_selection();
  co_return Result<>();
}

Task<Result<>> Slots::select(int slot) {
  if (auto may = may_touch_(); !may) co_return may;
  auto chosen = co_await choose(slot, Priority::intent);
  if (chosen) was_selected(slot);
  co_return chosen;
}

}  // namespace hw::vxm
