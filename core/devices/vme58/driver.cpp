// Status rounds, intents, stops and texts. Connecting and resets: driver_connect.cpp.
#include "core/devices/vme58/driver.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/text_goals.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr Duration sample_pause = std::chrono::microseconds(50);  // between two rounds of a recording

/// The axes that a request moves, bit per axis; none: it moves nothing, or nobody knows what.
unsigned axes_of(const IntentBody& body) {
  unsigned axes = 0;
  const auto take = [&axes](const std::vector<AxisTarget>& places) {
    for (const AxisTarget& place : places) axes |= 1u << place.axis.index;
  };
  if (const auto* i = std::get_if<intent::MoveTo>(&body)) take(i->targets);
  if (const auto* i = std::get_if<intent::MoveBy>(&body)) take(i->distances);
  if (const auto* i = std::get_if<intent::JogStart>(&body)) axes = 1u << i->axis.index;
  if (const auto* i = std::get_if<intent::Home>(&body)) axes = 1u << i->axis.index;
  return axes;
}

}  // namespace

// ---- intents

Task<Result<>> Vme58Driver::perform(const IntentBody& body) {
  if (!talk_.wire.is_open()) co_return no_connection();
  auto done = co_await carry_out(body);
  if (!done && done.error().kind == FaultKind::refused) co_return done;  // nothing was sent
  const unsigned axes = axes_of(body);
  strings_.texts.prepared().forget(axes, (axes & (axes - 1)) != 0);
  if (std::holds_alternative<intent::RunProgram>(body)) strings_.texts.forget_prepared();
  co_return done;
}

Task<Result<>> Vme58Driver::carry_out(const IntentBody& body) {
  using namespace intent;
  if (const auto* i = std::get_if<MoveTo>(&body))
    co_return co_await work_.moves.move(i->targets, pace_of(*i), false);
  if (const auto* i = std::get_if<MoveBy>(&body))
    co_return co_await work_.moves.move(i->distances, pace_of(*i), true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await work_.moves.jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await work_.moves.home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await work_.drive.set_position(*i);
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await work_.drive.set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await known_.lines.set(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await work_.setup.set(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await work_.actions.act(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await send_text(i->text);
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return strings_.programs.load(i->text);
  if (std::holds_alternative<ClearProgram>(body)) co_return strings_.programs.load({});
  if (std::holds_alternative<RunProgram>(body)) co_return co_await strings_.programs.run();
  if (std::holds_alternative<SelectProgram>(body)) co_return Result<>();  // there is only one
  if (std::holds_alternative<UploadProgram>(body)) {
    strings_.programs.show();
    co_return Result<>();
  }
  if (const auto* i = std::get_if<Watch>(&body)) {
    known_.questions.watch(i->groups);
    co_return Result<>();
  }
  if (const auto* i = std::get_if<Sample>(&body)) {
    samples_.start(*i);
    co_return Result<>();
  }
  if (std::holds_alternative<ReadParams>(body)) co_return co_await talk_.readings.read_all(Priority::intent);
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_state();
  if (std::holds_alternative<Reset>(body)) co_return co_await reset();
  if (std::holds_alternative<SetEncoder>(body))
    co_return fail(FaultKind::refused, "A VME58 has no command for the encoder counter alone.",
                   "Nothing was sent.", "Set the position: LP loads both counters.");
  if (std::holds_alternative<Store>(body))
    co_return fail(FaultKind::refused,
                   "A VME58 has no permanent memory: it starts from factory values each time.",
                   "Nothing was sent.", "Save the set-up to a file; restoring the file sets it again.");
  co_return fail(FaultKind::refused, "A VME58 has no command for this.", "Nothing was sent.");
}

Task<Result<>> Vme58Driver::send_text(std::string text) {
  auto sent = co_await strings_.texts.send(std::move(text), Millis(200));
  if (!sent) co_return fail(sent.error());
  if (!sent->empty()) script_texts_.add(std::move(*sent));
  co_return Result<>();
}

Task<Result<std::string>> Vme58Driver::query(std::string text, Duration patience) {
  if (!talk_.wire.is_open()) co_return no_connection();
  co_return co_await strings_.texts.send(std::move(text), patience);
}

TextMeaning Vme58Driver::meaning_of(const intent::SendText& text) const {
  return vme58::meaning_of(text.text, talk_.selection.context(), axes());
}

TextGoals Vme58Driver::goals_of(std::string_view text) const {
  return vme58::goals_of(text, talk_.selection.context(), talk_.selection.user_units(),
                         strings_.texts.prepared(), snapshot_);
}

// ---- stops

Task<Result<std::string>> Vme58Driver::stop(const StopOrder& order) {
  if (order.what == StopOrder::What::broadcast) co_return std::string();
  const bool tool = order.what == StopOrder::What::tool;
  if (tool && !talk_.conversation.is_known())
    co_return fail(FaultKind::no_answer, "The console has not read the board's command ring yet.",
                   "The tool was not switched off.");
  Result<> sent;
  if (tool)
    sent = co_await known_.lines.switch_tool_off(order.tool);
  else
    sent = co_await strings_.stops.send(order);
  if (!sent) co_return fail(sent.error());
  if (order.what == StopOrder::What::words)
    strings_.texts.note_stop(order.words);
  else if (!tool && order.axis >= 0)
    strings_.texts.prepared().forget(1u << order.axis, true);
  else if (!tool)
    strings_.texts.forget_prepared();
  co_return std::string();
}

LastWill Vme58Driver::last_will(unsigned) const { return strings_.stops.last_will(); }

StopProgress Vme58Driver::stop_progress(const StopOrder& order) { return strings_.stops.progress(order); }

// ---- rounds of status

// A recording needs every copy that the board makes: one per millisecond.
Duration Vme58Driver::moving_period() const {
  return samples_.are_taken() ? sample_pause : Duration(Millis(20));
}
Duration Vme58Driver::idle_period() const {
  if (snapshot_.working) return moving_period();
  return samples_.are_taken() ? sample_pause : Duration(Millis(200));
}

Task<Result<>> Vme58Driver::poll(Round round) {
  const Priority priority = round == Round::stopping ? Priority::stop : Priority::poll;
  const Instant began = talk_.wire.now();
  talk_.readings.look_after(samples_.are_taken() ? Readings::copy_time - sample_pause : Readings::copy_time);
  const auto registers = co_await talk_.readings.read_registers(priority, true);
  if (!registers) co_return fail(registers.error());
  if (!registers->started()) {
    talk_.wire.count_miss();
    co_return fail(FaultKind::garbled, "The board is starting: it has been reset.",
                   "Its state is not known yet.");
  }
  talk_.readings.take(*registers);
  if (registers->mark == 0) {
    auto reset_handled = co_await found_reset(Doubt::restarted);
    if (!reset_handled) co_return reset_handled;
    co_return co_await read_state();
  }
  auto read = co_await talk_.readings.read_axes(priority, Readings::Copy::is_asked_for);
  if (!read) co_return read;
  talk_.wire.count_answer(began, true);
  record_round();
  if (round == Round::stopping) co_return co_await strings_.all_stop.look_at_queues();
  co_return co_await read_more(*registers);
}

/// The rest of a round: unsolicited replies, and questions by command.
Task<Result<>> Vme58Driver::read_more(Registers registers) {
  known_.questions.begins();
  auto received = co_await talk_.conversation.receive(registers.input_put, Priority::poll);
  if (!received) co_return received;
  if (known_.values.mark_is_due()) {
    auto marked = co_await finding_.leave_mark();
    if (!marked) co_return marked;
  }
  snapshot_.window.rings_known = known_.questions.watches(memory_group);
  if (snapshot_.window.rings_known) {
    auto rings = co_await talk_.readings.read_rings(Priority::poll);
    if (!rings) co_return rings;
  }
  // Text that the board has not read holds questions back too, and must not be taken back.
  Result<> asked;
  if (talk_.conversation.is_taken_up_to(registers.output_get, registers.output_put)) {
    asked = co_await known_.questions.ask_in_turn();
  } else {
    known_.queues.show_full();
    asked = co_await known_.questions.look_at_done();
  }
  if (!asked) co_return asked;
  auto watched = co_await strings_.programs.watch();
  show_worst();
  co_return watched;
}

void Vme58Driver::registers_read(const Registers& registers) {
  known_.questions.take_slip_flag((registers.status & status::slip) != 0);
  const LimitEnds::Change change = known_.limits.take(registers.limit);
  if (change.any) known_.next.asks_flags();
  known_.motions.met_switches(change.met);
  for (int i = 0; i < axes(); ++i) snapshot_.axes[i].home = bit(registers.home, i);
  known_.lines.take(registers.io);
}

void Vme58Driver::axes_read(int whole, Instant at) {
  known_.speeds.take(whole);
  known_.values.take(whole);
  for (int i = 0; i < axes(); ++i) {
    known_.motions.show(i, at);
    snapshot_.axes[i].own_speed = Pps(static_cast<double>(known_.speeds.velocity.own(i)));
  }
  samples_.take(at);
}

void Vme58Driver::record_round() {
  round_text_.clear();
  for (int i = 0; i < axes(); ++i)
    fmt::format_to(std::back_inserter(round_text_), "{}{}", i == 0 ? "" : " ",
                   snapshot_.axes[i].position.value);
  talk_.wire.record(Way::sent, Priority::poll, "data area");
  talk_.wire.record(Way::received, Priority::poll, round_text_);
}

void Vme58Driver::show_worst() {
  snapshot_.notice.clear();
  talk_.commands.show_late_if_any();
  if (snapshot_.program.run == RunState::error) snapshot_.notice = strings_.programs.rejection();
  if (talk_.selection.recording())
    snapshot_.notice = "A contour is being recorded: end it (CE or CK) before moves and set-up.";
}

}  // namespace hw::vme58
