// Raw text of the user's or a script's: cut so that nothing is sent while the controller answers (the overrun
// of the manual's p.30 locks it until power-off), and followed, so that the driver knows what it changed.
#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr Duration usual_patience = Millis(200);

/// How the answer to a command ends.
struct AnswerShape {
  ReplyShape shape;
  std::size_t (*stranger)(std::string_view) = nullptr;
  Duration patience = usual_patience;
};

/// At most the last command of it is answered, so it may go out at once.
struct Piece {
  std::string text;
  std::optional<AnswerShape> answer;
  bool stores = false;  ///< rsm
};

/// What decides which commands the controller takes, as it changes on the way through a text.
struct Listening {
  bool local = false, running = false, halted = false, to_slave = false;
  int digitized_lines = 2;

  [[nodiscard]] bool takes(const TextCommand& c) const {
    if (to_slave || c.flaw != Flaw::none) return false;
    const bool is_letter = c.verb == Verb::letter;
    if (halted) return is_letter && c.letter == 'K';
    const std::string_view letters = running ? accepted_while_running : accepted_in_local;
    if (running || local) return is_letter && letters.find(c.letter) != std::string_view::npos;
    return true;
  }
  void follow(const TextCommand& c) {
    if (c.verb == Verb::slave_begins) to_slave = true;
    if (c.verb == Verb::slave_ends) to_slave = false;
    if (c.verb == Verb::word && c.name == "res") local = true, running = halted = false;
    if (c.verb != Verb::letter || to_slave) return;
    if (c.letter == 'K') running = halted = false;
    if (running || halted) return;
    if (c.letter == 'E' || c.letter == 'F' || c.letter == 'G') local = false;
    if (c.letter == 'Q') local = true;
    if (c.letter == 'R') running = !local;
  }
};

AnswerShape line_answer() { return {ReplyShape::line(), before_number}; }

std::optional<AnswerShape> answer_shape(const TextCommand& c, const Listening& now) {
  if (!now.takes(c)) return std::nullopt;
  if (c.verb == Verb::get || c.verb == Verb::ask_selected || c.verb == Verb::ask_associate)
    return line_answer();
  if (c.verb == Verb::word && c.name == "lst") return AnswerShape{ReplyShape::until_quiet(listing_quiet_ms)};
  if (c.verb == Verb::word && c.name == "rsm")
    return AnswerShape{ReplyShape::bytes(1), before_prompt, store_patience};
  if (c.verb != Verb::letter) return std::nullopt;
  switch (c.letter) {
    case 'D':
      if (!now.local || now.running) return std::nullopt;
      return AnswerShape{ReplyShape::several_lines(static_cast<std::uint16_t>(now.digitized_lines))};
    case 'V': return AnswerShape{ReplyShape::bytes(1), before_state};
    case 'K': return AnswerShape{ReplyShape::bytes(1), before_prompt};
    case 'x':
    case 'y': return AnswerShape{ReplyShape::several_lines(4), before_number};
    case '?':
    case '~':
    case '$': return AnswerShape{ReplyShape::bytes(1)};
    default: break;
  }
  if (std::string_view("XYZTM#*@").find(c.letter) != std::string_view::npos) return line_answer();
  return std::nullopt;
}

/// Of what belongs together: ( ) and [ ].
bool within_a_group(std::string_view text) {
  const auto count = [text](char c) { return std::count(text.begin(), text.end(), c); };
  return count('(') != count(')') || count('[') != count(']');
}

// A stop waits for what is on the wire: long texts are cut where a command ends.
constexpr std::size_t most_at_once = 24;

std::vector<Piece> pieces_of(std::string_view text, const std::vector<TextCommand>& commands, Listening now) {
  std::vector<Piece> pieces;
  std::size_t from = 0;
  for (const TextCommand& c : commands) {
    const bool whole = c.end - from >= most_at_once && !within_a_group(text.substr(0, c.end));
    if (auto answer = answer_shape(c, now)) {
      const bool stores = c.verb == Verb::word && c.name == "rsm";
      pieces.push_back({std::string(text.substr(from, c.end - from)), answer, stores});
      from = c.end;
    } else if (whole) {
      pieces.push_back({std::string(text.substr(from, c.end - from)), std::nullopt});
      from = c.end;
    }
    now.follow(c);
  }
  if (from < text.size()) pieces.push_back({std::string(text.substr(from)), std::nullopt});
  return pieces;
}

std::string without_end(std::string reply) {
  if (reply.ends_with('\r')) reply.pop_back();
  return reply;
}

void add_answer(std::string& answers, std::string_view next) {
  if (!answers.empty()) answers += '\r';
  answers += next;
}

/// The answers that came before a failure are not lost.
std::string with_answers(std::string_view answers, std::string_view done) {
  return fmt::format("Before that it answered {}.{}{}", printable(answers), done.empty() ? "" : " ", done);
}

/// Which state takes a few commands only, for a sentence.
std::string_view what_listens(const Listening& now) {
  if (now.halted) return "After its error report the controller takes only K, or res";
  if (now.running) return "While a program runs the controller takes only a few letters";
  return "In local mode the controller takes only a few letters";
}

/// Taken in more states than one can know here: T and Z at a standstill, res always.
bool may_be_taken(const TextCommand& c) {
  return c.verb == Verb::letter ? c.letter == 'T' || c.letter == 'Z'
                                : c.verb == Verb::word && c.name == "res";
}

/// What becomes of a text in the controller's present state.
struct Reception {
  std::vector<TextCommand> taken;
  std::string dropped;         ///< known commands that it does not take: they go without a word as well
  std::string_view when = {};  ///< the state that drops the first of them
};

Reception reception_of(const std::vector<TextCommand>& commands, Listening now) {
  Reception r;
  for (const TextCommand& c : commands) {
    if (now.takes(c) || (!now.to_slave && may_be_taken(c))) {
      r.taken.push_back(c);
    } else if (c.flaw == Flaw::none && !now.to_slave) {
      if (r.dropped.empty()) r.when = what_listens(now);
      r.dropped += (r.dropped.empty() ? "" : " ") + canonical(c);
    }
    now.follow(c);
  }
  return r;
}

}  // namespace

// What the text changes of which the driver keeps a record.
void VxmDriver::note_taken(const std::vector<TextCommand>& commands) {
  const auto program_changed = [&] {
    if (selected_ < 0) return;
    draft_.slot_bytes_used[static_cast<std::size_t>(selected_)] = -1;
    listings_[static_cast<std::size_t>(selected_)].reset();
    if (confirmed_scratch_ == selected_) confirmed_scratch_ = -1;
    draft_.unsaved_programs = true;
    sizes_read_ = false;
  };
  for (const TextCommand& c : commands) {
    if (c.flaw != Flaw::none) continue;
    if (c.stored()) program_changed();
    if (c.verb == Verb::speed && c.motor >= 1 && c.motor <= max_motors)
      known_speed_[static_cast<std::size_t>(c.motor - 1)] = static_cast<int>(c.value);
    if (c.verb == Verb::select || c.verb == Verb::empty) {
      selected_ = static_cast<int>(c.value);
      if (!stored_running_) draft_.program.slot = static_cast<std::int8_t>(selected_);
      if (c.verb == Verb::empty) program_changed();
    }
    if (c.verb == Verb::set) {
      next_param_ = 0;
      for (std::size_t i = 0; i < catalog_.params.size(); ++i)
        if (catalog_.params[i].mnemonic == c.name) draft_.params[i].known = draft_.params[i].stored = false;
      draft_.unsaved_setup = true;
      if (c.name == "DM" || c.name == "I" || c.name == "D") essentials_read_ = false;
    }
    if (c.verb == Verb::word && c.name == "del") program_changed();
    if (c.verb == Verb::word && c.name == "rsm") all_stored();
    if (c.verb == Verb::word && c.name == "res") halted_ = 0;  // the next V finds it restarted
    if (c.verb != Verb::letter) continue;
    if (c.letter == 'C') program_changed();
    if (c.letter == 'K') doubt_positions(), killed();
    if (c.letter == 'D' && mode_ == Mode::on_line) note_stop();
    if (c.letter == 'H') hold_on_ = !hold_on_;
    if (c.letter == 'Q') stay_local_ = true, mode_ = Mode::local;
    if (c.letter == 'E' || c.letter == 'F' || c.letter == 'G') stay_local_ = false, mode_ = Mode::on_line;
    if (c.letter == 'G' && draft_.program.run != RunState::idle) draft_.program.run = RunState::running;
    if (c.letter == 'R' && !stored_running_) show_running(selected_);
    if (c.letter == 'N')
      for (int i = 0; i < draft_.axis_count; ++i) draft_.axes[i].position_doubtful = false;
  }
}

// The user's own D: nothing of the console's move follows it.
void VxmDriver::note_stop() {
  if (!job_.active()) return;
  drop_later_legs(-1);
  job_.jog = false;
  if (!job_.leg_over) job_.ended_by = EndedBy::stop;
}

// The controller drops what it does not know without a word.
void VxmDriver::warn_of_flaws(const std::vector<TextCommand>& commands) {
  std::string unknown;
  int unknown_count = 0;
  for (const TextCommand& c : commands)
    if (c.flaw == Flaw::unknown) unknown += (unknown_count++ > 0 ? " " : "") + printable(c.name);
  if (unknown_count == 1)
    tell(Notice::Kind::warning,
         fmt::format("{} is no command of the VXM: the controller drops it without a word. It was sent as it "
                     "is. The terminal lists the commands behind ?.",
                     unknown));
  if (unknown_count > 1)
    tell(
        Notice::Kind::warning,
        fmt::format("{} are no commands of the VXM: the controller drops them without a word. They were sent "
                    "as they are. The terminal lists the commands behind ?.",
                    unknown));
  for (const TextCommand& c : commands) {
    if (c.flaw == Flaw::range)
      tell(Notice::Kind::warning,
           fmt::format(
               "{} is not possible, it takes {}: the controller drops it without a word. It was sent as "
               "it is. Send it again with another number.",
               canonical(c), allowed_values(c)));
    if (c.flaw == Flaw::no_value)
      tell(Notice::Kind::warning,
           fmt::format(
               "{} lacks its number: the controller drops it without a word. It was sent as it is. Send "
               "it again with its number.",
               printable(c.name)));
  }
}

void VxmDriver::warn_of_dropped(const RawAnswer& sent) {
  if (!sent.dropped.empty()) tell(Notice::Kind::warning, sent.dropped + " It was sent as it is.");
}

// Echo would come between every question and its answer: F goes out for E.
static bool without_echo(std::string& text, const std::vector<TextCommand>& commands) {
  bool asked = false;
  for (const TextCommand& c : commands)
    if (c.verb == Verb::letter && c.letter == 'E') asked = true, text[c.begin] = 'F';
  return asked;
}

// Sends it piece by piece and gives back the answers, each without its end, joined by carriage returns.
// `answered`: whether the last piece was one that is answered.
Task<VxmDriver::RawAnswer> VxmDriver::send_pieces(std::string text, Duration patience) {
  const Priority priority = is_stop(text) ? Priority::stop : Priority::intent;
  const auto commands = read_text(text);
  warn_of_flaws(commands);
  if (without_echo(text, commands))
    tell(Notice::Kind::info, "Echo stays off: F was sent for E. The console shows what it sends by itself.");
  Listening now;
  now.local = mode_ == Mode::local, now.running = busy(), now.halted = halted_ != 0;
  now.digitized_lines = slave_present_ ? max_motors : motors_per_controller;
  const Reception reception = reception_of(commands, now);
  const auto pieces = pieces_of(text, commands, now);
  note_taken(reception.taken);
  bool to_store = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.stores; });
  const auto failed = [&](Fault why) {
    if (to_store) draft_.unsaved_setup = draft_.unsaved_programs = true;  // rsm is not confirmed
    return why;
  };
  RawAnswer all;
  if (!reception.dropped.empty())
    all.dropped = fmt::format("{} and drops {} without a word.", reception.when, reception.dropped);
  for (const Piece& piece : pieces) {
    all.last_is_answered = piece.answer.has_value();
    if (!piece.answer) {
      auto sent = co_await say(piece.text, priority);
      if (sent) continue;
      all.fault = failed(std::move(sent.error()));
      co_return all;
    }
    const bool last = &piece == &pieces.back();
    const Duration wait = std::max(piece.answer->patience, last ? patience : usual_patience);
    auto reply = co_await ask(piece.text, piece.answer->shape, priority, piece.answer->stranger, wait);
    if (!reply) {
      all.fault = failed(std::move(reply.error()));
      co_return all;
    }
    if (piece.stores) to_store = false;
    add_answer(all.text, without_end(std::move(*reply)));
  }
  co_return all;
}

Task<Result<>> VxmDriver::send_text(std::string text) {
  if (ends_open(text)) text += '\r';
  for (const TextCommand& c : read_text(text)) {
    const bool taken_while_running =
        c.verb == Verb::letter && accepted_while_running.find(c.letter) != std::string_view::npos;
    if (job_.active() && !taken_while_running && !(c.verb == Verb::word && c.name == "res"))
      co_return fail(
          FaultKind::refused,
          fmt::format("A move of the console is under way, and the controller does not take {} then.",
                      canonical(c)),
          "Nothing was sent.", "Wait until it ends, or stop it.");
  }
  RawAnswer sent = co_await send_pieces(std::move(text), usual_patience);
  warn_of_dropped(sent);
  if (!sent.text.empty()) for_scripts(std::move(sent.text));
  news_.notify();
  if (sent.fault) co_return fail(std::move(*sent.fault));
  co_return Result<>();
}

bool VxmDriver::answers(std::string_view text) const {
  Listening now;
  now.local = mode_ == Mode::local, now.running = busy(), now.halted = halted_ != 0;
  const auto pieces = pieces_of(text, read_text(text), now);
  return !pieces.empty() && pieces.back().answer.has_value();
}

bool VxmDriver::answers_later(std::string_view text) const { return !answers(text); }

// It begins with what stops, and starts nothing behind that.
bool VxmDriver::is_stop(std::string_view text) const {
  const auto commands = read_text(text);
  if (commands.empty()) return false;
  const TextCommand& first = commands.front();
  const bool ramps = first.letter == 'D' && busy();  // else it asks for places
  const bool stops = first.verb == Verb::letter ? first.letter == 'K' || ramps
                                                : first.verb == Verb::word && first.name == "res";
  return stops && std::none_of(commands.begin(), commands.end(), [](const TextCommand& c) {
           return c.verb == Verb::letter && c.letter == 'R';
         });
}

bool VxmDriver::changes_programs(std::string_view text) const {
  const auto commands = read_text(text);
  return std::any_of(commands.begin(), commands.end(), [](const TextCommand& c) {
    return c.stored() || c.verb == Verb::empty || (c.verb == Verb::letter && c.letter == 'C') ||
           (c.verb == Verb::word && (c.name == "del" || c.name == "res"));
  });
}

Task<Result<std::string>> VxmDriver::query(std::string text, Duration patience) {
  if (!is_stop(text)) {
    auto settled = co_await finish_leg();
    if (!settled) co_return fail(settled.error());
  }
  if (ends_open(text)) text += '\r';
  if (read_text(text).empty())
    co_return fail(FaultKind::refused, "There is no command in that text.", "Nothing was sent.");
  const std::uint64_t asked = next_unasked_;
  RawAnswer sent = co_await send_pieces(std::move(text), patience);
  if (sent.fault || sent.last_is_answered) warn_of_dropped(sent);
  if (sent.fault) {
    auto report = sent.fault->kind == FaultKind::no_answer ? take_since(asked, 'E') : std::nullopt;
    if (!sent.text.empty() && !report) sent.fault->done = with_answers(sent.text, sent.fault->done);
    if (!report) co_return fail(std::move(*sent.fault));
    add_answer(sent.text, *report);  // it came instead of an answer
    co_return std::move(sent.text);
  }
  if (sent.last_is_answered) co_return std::move(sent.text);
  auto prompt = co_await wait_for_prompt(asked, patience);
  if (!prompt && sent.text.empty()) {
    if (sent.dropped.empty()) co_return prompt;
    co_return fail(FaultKind::controller, sent.dropped, "It was sent as it is.");
  }
  warn_of_dropped(sent);
  if (prompt) add_answer(sent.text, *prompt);
  co_return std::move(sent.text);
}

// For texts that have no answer of their own: R and what else brings a prompt some time.
Task<Result<std::string>> VxmDriver::wait_for_prompt(std::uint64_t since, Duration patience) {
  const Instant deadline = scheduler_.now() + patience;
  const std::uint64_t stops_before = stops_said_;
  for (bool in_time = true;;) {
    if (auto text = take_since(since)) co_return std::move(*text);
    if (stops_said_ != stops_before)
      co_return fail(FaultKind::stopped, "A stop has ended what the answer was waited for.", "It was sent.");
    if (!station_) co_return fail(FaultKind::lost, "The connection was lost before an answer came.");
    if (!in_time)
      co_return fail(FaultKind::no_answer, fmt::format("No answer came in {:g} s.", seconds(patience)));
    in_time = co_await news_.wait_until(deadline);
  }
}

}  // namespace hw::vxm
