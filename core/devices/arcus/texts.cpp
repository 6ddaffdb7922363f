#include "core/devices/arcus/texts.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/arcus/text_meaning.h"

namespace hw::arcus {
namespace {

constexpr Duration typed_patience = Millis(200);

/// Whether the axis no longer comes to rest at its target after this text.
bool takes_target_away(std::string_view text) {
  if (text.starts_with('T')) return text.find('=') == text.npos;
  const bool counter = text.size() > 3 && text[2] == '=' && (text[0] == 'P' || text[0] == 'E');
  return counter && text[1] != 'O';
}

/// Keeps only the first of several commands: each has its own reply, and the second reply would be taken for
/// the reply to the next question. True: commands were cut off.
bool cut_to_one_command(std::string& text) {
  constexpr std::string_view ends("\r\n\0", 3), nothing(" \r\n\0", 4);
  text.erase(0, std::min(text.find_first_not_of(ends), text.size()));
  const auto end = text.find_first_of(ends);
  const bool more = end != text.npos && text.find_first_not_of(nothing, end) != text.npos;
  text.erase(std::min(end, text.size()));
  return more;
}

EndedBy ended_by_text(std::string_view stop) {
  return stop.starts_with("ABORT") ? EndedBy::abort : EndedBy::stop;
}

}  // namespace

Task<Result<std::string>> Texts::query(std::string text, Duration patience) {
  if (cut_to_one_command(text))
    co_return fail(FaultKind::refused, "This is more than one command: a line end ends a command.",
                   "Nothing was sent.", "Send them one by one.");
  auto looked = co_await silence_.look();
  if (!looked && looked.error().kind == FaultKind::stopped) co_return fail(looked.error());
  auto returned = co_await borrowed_.give_back_first();
  if (!returned) co_return fail(returned.error());
  co_return co_await transmit(std::move(text), Priority::intent, patience);
}

Task<Result<std::string>> Texts::stop(const StopOrder& order) {
  std::string text = order.words;
  const bool more = cut_to_one_command(text);
  list_.end();
  if (order.meaning.addressee == TextMeaning::For::all && address_of(text) < 0) {
    auto sent = co_await conversation_.broadcast(text, Priority::stop);
    if (!sent) co_return fail(sent.error());
    note_sent(text);
    co_return std::string();
  }
  // Limits how long the stop waits for the reply. If a device that has answered before does not answer, the
  // console repeats the stop.
  const bool was_received = conversation_.is_open() && conversation_.station()->has_received();
  const Duration asked = order.patience > Duration::zero() ? order.patience : typed_patience;
  const Duration patience = was_received ? std::min(asked, typed_patience) : asked;
  auto stopped = co_await transmit(text, Priority::stop, patience);
  if (stopped && stopped->starts_with('?'))  // it received another text
    co_return fail(FaultKind::controller, fmt::format("The controller answered {} to {}.", *stopped, text));
  const bool its_own = address_of(text) < 0 || address_of(text) == console_.catalog.address;
  if (stopped && its_own && ends_motion(command_in(text)) &&
      *stopped != "OK")  // the reply to an earlier text
    co_return fail(FaultKind::garbled, fmt::format("The controller answered {} to {}.", *stopped, text),
                   "It was sent, followed by a stop from the console.");
  if (!stopped || !more) co_return stopped;
  co_return fail(FaultKind::refused, "The text holds another command after the stop.",
                 "Only the stop was sent.", "Send the other command by itself.");
}

Task<Result<std::string>> Texts::transmit(std::string text, Priority priority, Duration patience) {
  const std::string command = command_in(text);
  const int to = address_of(text);
  if (console_.model().broadcast >= 0 && to == console_.model().broadcast) {
    auto sent = co_await conversation_.broadcast(std::string(text_of(text)), priority);
    if (!sent) co_return fail(sent.error());
    note_sent(command);
    note_done(command);
    co_return std::string();
  }
  const bool anothers = to >= 0 && to != console_.catalog.address;
  auto reply = co_await conversation_.exchange(text, priority, patience);
  if (!reply && anothers && reply.error().kind == FaultKind::no_answer)
    co_return fail(FaultKind::no_answer,
                   fmt::format("Device {:02} did not answer {} in time.", to, text_of(text)));
  if (!anothers && ends_motion(command) && (!reply || !reply->refused()))
    note_stop(command);  // confirmed or not
  if (!reply) co_return fail(reply.error());
  if (!reply->refused() && !anothers) {
    note_sent(command);
    note_done(command);
  }
  co_return std::move(reply->text);
}

// Sent to all, unless the text has an address: then that device answers, or it is the address of all.
Task<Result<>> Texts::send(const intent::SendText& request) {
  std::string text = request.text;
  if (request.broadcast && address_of(text) < 0) {
    if (console_.model().broadcast < 0 || conversation_.framing() == Framing::message)
      co_return co_await conversation_.broadcast(std::move(text),
                                                 Priority::intent);  // it refuses, and says why
    text.insert(0, fmt::format("@{:02}", console_.model().broadcast));
  }
  auto reply = co_await query(std::move(text), typed_patience);
  if (!reply) co_return fail(reply.error());
  if (!reply->empty()) console_.texts.add(std::move(*reply));
  co_return Result<>();
}

// State that the text may change is read afresh: intents go before polls.
void Texts::note_broadcast(const std::string& text) {
  const std::string command = command_in(text);
  watch_.goes_out(command);
  threads_.may_start(command);
  code_.goes_out(command);
  note_sent(command);
  note_done(command);
}

// Effects that hold only if the controller has accepted the text.
void Texts::note_done(std::string_view command) {
  if (command == "STORE") setup_.is_stored();
  if (command == "ABS" || command == "INC") readouts_.put("MM", command == "INC");
  // The controller accepts a move only of an axis at rest: the console's own motion there is over.
  if (!arcus::may_move(console_.forms, command) || takes_target_away(command)) return;
  const int named = console_.axes() == 1 ? 0 : axis_named_in(console_.forms, command);
  if (named >= 0) motions_.another_begins(named);
}

// State that the user's own text changes is read afresh, not guessed.
void Texts::note_sent(std::string_view as_typed) {
  const std::string clean = bare_text(as_typed);
  const std::string_view text = clean;
  const auto equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (equals != text.npos) {
    const int index = console_.catalog.find_param(name);
    if (index >= 0) setup_.changed(index);
    if (name.starts_with('V'))
      if (const auto n = decode_number(name.substr(1)); n && *n >= 0 && *n < variables)
        console_.snapshot.variables_known.reset(static_cast<std::size_t>(*n));
  }
  if (may_switch_motor(text)) lines_.look_soon();
  threads_.command_sent(text);
  code_.goes_out(text);
  if (text.starts_with("SA") && equals != text.npos) code_.forget();
  if (const int axis = axis_named_in(console_.forms, text); axis >= 0 && takes_target_away(text))
    console_.snapshot.axes[axis].has_target = false;
  if (ends_motion(text)) note_stop(text);
  if (!arcus::may_move(console_.forms, text)) return;
  // Homing sets the counters; a short move to zero may end before it is seen moving.
  watch_.counters_may_be_set();
  console_.changed();
}

// The user's own stop: motions that it ended did not end by themselves.
void Texts::note_stop(std::string_view text) {
  list_.end();
  const int only = console_.axes() > 1 ? axis_named_in(console_.forms, text) : -1;
  for (int i = 0; i < console_.axes(); ++i)
    if ((only < 0 || i == only) && console_.snapshot.axis_moves(i))
      motions_.ended_by_us(i, ended_by_text(text));
}

}  // namespace hw::arcus
