// The user's own text: sent, asked, stopped by, and heard from a neighbour's terminal on the same line.
#include <fmt/core.h>

#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr Duration typed_patience = Millis(200);

/// After it, where the axis was sent is not where it is to come to rest.
bool takes_target_away(std::string_view text) {
  if (text.starts_with('T')) return text.find('=') == text.npos;
  const bool counter = text.size() > 3 && text[2] == '=' && (text[0] == 'P' || text[0] == 'E');
  return counter && text[1] != 'O';
}

/// Each of several is answered by itself: the second answer would be taken for that to the next question.
/// True: there is something behind the first, which alone is left.
bool cut_to_one_command(std::string& text) {
  constexpr std::string_view ends("\r\n\0", 3), nothing(" \r\n\0", 4);
  text.erase(0, std::min(text.find_first_not_of(ends), text.size()));
  const auto end = text.find_first_of(ends);
  const bool more = end != text.npos && text.find_first_not_of(nothing, end) != text.npos;
  text.erase(std::min(end, text.size()));
  return more;
}

EndedBy how_it_ends(std::string_view stop) {
  return stop.starts_with("ABORT") ? EndedBy::abort : EndedBy::stop;
}

}  // namespace

Task<Result<std::string>> ArcusDriver::query(std::string text, Duration patience) {
  if (!cut_to_one_command(text)) co_return co_await say_command(std::move(text), patience);
  if (!is_stop(text))
    co_return fail(FaultKind::refused, "This is more than one command: the end of a line ends one.",
                   "Nothing was sent.", "Send them one by one.");
  auto stopped = co_await say_command(std::move(text), patience);
  if (!stopped) co_return stopped;
  co_return fail(FaultKind::refused, "There is another command behind the stop.", "The stop was sent alone.",
                 "Send the other by itself.");
}

// A stop waits for nothing that is to come first.
Task<Result<std::string>> ArcusDriver::say_command(std::string text, Duration patience) {
  const Priority priority = is_stop(text) ? Priority::stop : Priority::intent;
  if (priority != Priority::stop) {
    if (auto returned = co_await give_back_first(); !returned) co_return fail(returned.error());
  }
  if (model().broadcast >= 0 && address_of(text) == model().broadcast) {
    auto sent = co_await broadcast(std::string(text_of(text)), priority);
    if (!sent) co_return fail(sent.error());
    note_sent(text_of(text));
    note_done(text_of(text));
    co_return std::string();
  }
  const int to = address_of(text);
  const bool anothers = to >= 0 && to != catalog_.address;
  if (station_ && anothers) station_->let_others_hear(text, Hearsay::said);
  if (const std::string command = command_in(text); !anothers && ends_motion(command))
    stop_is_said(axis_stopped_by(command), how_it_ends(command));  // whether or not it is confirmed
  auto reply = co_await exchange(text, priority, patience);
  const bool not_done = reply ? reply->refused() : was_kept_back(reply.error());
  if (station_ && anothers && (reply || not_done))
    station_->let_others_hear(text, not_done ? Hearsay::refused : Hearsay::done);
  if (!reply && anothers && reply.error().kind == FaultKind::no_answer)
    co_return fail(FaultKind::no_answer,
                   fmt::format("Device {:02} did not answer {} in time.", to, text_of(text)));
  if (!reply) co_return fail(reply.error());
  if (!reply->refused() && !anothers) {
    note_sent(text_of(text));
    note_done(text_of(text));
  }
  co_return std::move(reply->text);
}

bool ArcusDriver::answers(std::string_view text) const {
  return model().broadcast < 0 || address_of(text) != model().broadcast;
}

// The automatic message at the end of a move (DMX manual, AR).
bool ArcusDriver::answers_later(std::string_view) const { return param("AR") == 1; }

// A line of the program memory: SA[line]=[code].
bool ArcusDriver::changes_programs(std::string_view text) const {
  const std::string command = command_in(text);
  return command.starts_with("SA") && command.find('=') != command.npos;
}

bool ArcusDriver::is_stop(std::string_view text) const {
  return ends_motion(text_of(text)) || ends_program(text_of(text));
}

bool ArcusDriver::stops_another(std::string_view text) const {
  const int to = address_of(text);
  return is_stop(text) && to >= 0 && to != catalog_.address && to != model().broadcast;
}

bool ArcusDriver::stops_all(std::string_view text) const {
  const std::string word = command_in(text);
  return is_stop(text) && !stops_another(text) && (word == "STOP" || word == "ABORT");
}

Addressees ArcusDriver::meant_for(const intent::SendText& wish) const {
  const int to = address_of(wish.text);
  if (to < 0) return wish.broadcast ? Addressees::all() : Addressees::one(catalog_.address);
  return to == model().broadcast ? Addressees::all() : Addressees::one(to);
}

// To all, unless it says itself to whom: then that one answers, or it is the address of all.
Task<Result<>> ArcusDriver::send_text(const intent::SendText& wish) {
  std::string text = wish.text;
  if (wish.broadcast && address_of(text) < 0) {
    if (model().broadcast < 0 || framing() == Framing::message)
      co_return co_await broadcast(std::move(text), Priority::intent);  // which says why not
    text.insert(0, fmt::format("@{:02}", model().broadcast));
  }
  auto reply = co_await query(std::move(text), typed_patience);
  if (!reply) co_return fail(reply.error());
  if (!reply->empty()) for_scripts(std::move(*reply));
  co_return Result<>();
}

// From a neighbour's terminal to this one, or to all. What it may change is read afresh after it: intents go
// before polls.
void ArcusDriver::overhear(std::string_view text, Hearsay what) {
  const int to = address_of(text);
  if (to < 0 || (to != catalog_.address && to != model().broadcast)) return;
  const std::string command = command_in(text);
  if (what == Hearsay::done) return note_done(command);
  if (what == Hearsay::refused) {
    if (command.starts_with("GS")) called_ = called_before_hearsay_;
    return;
  }
  if (station_ && is_stop(text)) stop_heard_(stops_all(text));  // nothing that waits here is said behind it
  may_set(command);
  if (changes_programs(text)) {
    ++draft_.program_changes;
    draft_.program_changed_by = 0;
  }
  if (command.starts_with("GS")) called_before_hearsay_ = called_;
  note_sent(command);
}

// What is true only when the controller has taken it.
void ArcusDriver::note_done(std::string_view text) {
  if (bare_text(text) == "STORE") is_stored();
}

// What the user's own text changes is read afresh, not guessed.
void ArcusDriver::note_sent(std::string_view as_typed) {
  const std::string clean = bare_text(as_typed);
  const std::string_view text = clean;
  const auto equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (equals != text.npos) {
    const int index = catalog_.find_param(name);
    if (index >= 0) changed_param(index);
    if (name.starts_with('V'))
      if (const auto n = decode_number(name.substr(1)); n && *n >= 0 && *n < variables)
        draft_.variables_known.reset(static_cast<std::size_t>(*n));
  }
  io_due_ = io_due_ || may_switch_motor(text);
  forget_thread(text);
  note_call(text);
  if (text.starts_with("SA") && equals != text.npos) stored_code_.reset();
  if (const int axis = axis_named_in(text); axis >= 0 && takes_target_away(text))
    draft_.axes[axis].has_target = false;
  if (ends_motion(text)) note_stop(text);
  if (!arcus::may_move(forms_, text)) return;
  counters_.may_be_set();  // homing sets them; a short move to zero ends before anybody has seen it move
  changed_();
}

// The user's own stop: what it has ended did not end by itself, and nothing that waits here begins again.
void ArcusDriver::note_stop(std::string_view text) {
  const int only = axis_stopped_by(text);
  const EndedBy why = how_it_ends(text);
  stop_is_said(only, why);
  for (int i = 0; i < axis_count(); ++i)
    if ((only < 0 || i == only) && moving(i)) ended_by_us(i, why);
}

int ArcusDriver::axis_stopped_by(std::string_view text) const {
  return axis_count() > 1 ? axis_named_in(text) : -1;
}

/// "PX=0", "TX500", "STOPX" -> 0; -1: none. With one axis it need not be named.
int ArcusDriver::axis_named_in(std::string_view text) const {
  if (axis_count() == 1) return 0;
  const std::string_view name = text.substr(0, text.find_first_of("=0123456789-"));
  const auto axis = name.empty() ? std::string_view::npos : model().axis_letters.find(name.back());
  return axis == std::string_view::npos ? -1 : static_cast<int>(axis);
}

}  // namespace hw::arcus
