// Rounds of status, intents, stops and texts. Connecting and resets: driver_connect.cpp.
#include "core/devices/vme58/driver.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr Duration sample_pause = std::chrono::microseconds(50);  // between two rounds of a recording

}  // namespace

// ---- intents

Task<Result<>> Vme58Driver::perform(const IntentBody& body) {
  using namespace intent;
  if (!wire_.is_open()) co_return no_connection();
  if (const auto* i = std::get_if<MoveTo>(&body)) co_return co_await moves_.move(i->targets, i->speed, false);
  if (const auto* i = std::get_if<MoveBy>(&body))
    co_return co_await moves_.move(i->distances, i->speed, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await moves_.jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await moves_.home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await drive_.set_position(*i);
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await drive_.set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await lines_.set(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await setup_.set(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await actions_.act(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await send_text(i->text);
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return programs_.load(i->text);
  if (std::holds_alternative<ClearProgram>(body)) co_return programs_.load({});
  if (std::holds_alternative<RunProgram>(body)) co_return co_await programs_.run();
  if (std::holds_alternative<SelectProgram>(body)) co_return Result<>();  // there is one
  if (std::holds_alternative<UploadProgram>(body)) {
    programs_.show();
    co_return Result<>();
  }
  if (const auto* i = std::get_if<Watch>(&body)) {
    questions_.watch(i->groups);
    co_return Result<>();
  }
  if (const auto* i = std::get_if<Sample>(&body)) {
    samples_.start(*i);
    co_return Result<>();
  }
  if (std::holds_alternative<ReadParams>(body)) co_return co_await readings_.read_all(Priority::intent);
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_state();
  if (std::holds_alternative<Reset>(body)) co_return co_await reset();
  if (std::holds_alternative<SetEncoder>(body))
    co_return fail(FaultKind::refused, "A VME58 has no command for the encoder counter alone.",
                   "Nothing was sent.", "Set the position: LP loads both counters.");
  if (std::holds_alternative<Store>(body))
    co_return fail(FaultKind::refused,
                   "A VME58 has no memory that stays: it starts from factory values each time.",
                   "Nothing was sent.", "Save the set-up to a file; restoring the file sets it again.");
  co_return fail(FaultKind::refused, "A VME58 has no command for this.", "Nothing was sent.");
}

Task<Result<>> Vme58Driver::send_text(std::string text) {
  auto sent = co_await texts_.send(std::move(text), Millis(200));
  if (!sent) co_return fail(sent.error());
  if (!sent->empty()) texts_heard_.add(std::move(*sent));
  co_return Result<>();
}

Task<Result<std::string>> Vme58Driver::query(std::string text, Duration patience) {
  if (!wire_.is_open()) co_return no_connection();
  co_return co_await texts_.send(std::move(text), patience);
}

TextMeaning Vme58Driver::meaning_of(const intent::SendText& text) const {
  return vme58::meaning_of(text.text, selection_.context(), axes());
}

// ---- stops

Task<Result<std::string>> Vme58Driver::stop(const StopOrder& order) {
  if (order.what == StopOrder::What::broadcast) co_return std::string();
  auto sent = co_await stops_.send(order);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

StopProgress Vme58Driver::stop_progress(const StopOrder& order) { return stops_.progress(order); }

// ---- rounds of status

// A recording wants each copy that the board makes: one a millisecond.
Duration Vme58Driver::moving_period() const {
  return samples_.are_taken() ? sample_pause : Duration(Millis(20));
}
Duration Vme58Driver::idle_period() const {
  if (draft_.working) return moving_period();
  return samples_.are_taken() ? sample_pause : Duration(Millis(200));
}

Task<Result<>> Vme58Driver::poll(Round round) {
  const Priority priority = round == Round::stopping ? Priority::stop : Priority::poll;
  const Instant began = wire_.now();
  readings_.look_after(samples_.are_taken() ? Readings::copy_time - sample_pause : Readings::copy_time);
  const auto registers = co_await readings_.read_registers(priority, true);
  if (!registers) co_return fail(registers.error());
  if (!registers->started()) {
    wire_.count_miss();
    co_return fail(FaultKind::garbled, "The board is starting: it has been reset.",
                   "Nothing is known of it yet.");
  }
  readings_.take(*registers);
  if (registers->mark == 0) {
    auto told = co_await found_reset(Doubt::restarted);
    if (!told) co_return told;
    co_return co_await read_state();
  }
  auto read = co_await readings_.read_axes(priority, Readings::Copy::is_asked_for);
  if (!read) co_return read;
  wire_.count_answer(began, true);
  record_round();
  if (round == Round::stopping) co_return co_await all_stop_.look_at_queues();
  co_return co_await read_more(*registers);
}

/// What else a round tells: replies that nobody waits for, and what the board answers to.
Task<Result<>> Vme58Driver::read_more(Registers registers) {
  questions_.begins();
  auto heard = co_await conversation_.hear(registers.input_put, Priority::poll);
  if (!heard) co_return heard;
  if (values_.mark_is_due()) {
    auto marked = co_await finding_.leave_mark();
    if (!marked) co_return marked;
  }
  draft_.window.rings_known = questions_.watches(memory_group);
  if (draft_.window.rings_known) {
    auto rings = co_await readings_.read_rings(Priority::poll);
    if (!rings) co_return rings;
  }
  // Text that the board has not come to holds questions back too, and is nobody's to take away.
  Result<> asked;
  if (conversation_.is_taken_up_to(registers.output_get)) {
    asked = co_await questions_.ask_in_turn();
  } else {
    queues_.show_full();
    asked = co_await questions_.look_at_done();
  }
  if (!asked) co_return asked;
  auto watched = co_await programs_.watch();
  show_worst();
  co_return watched;
}

void Vme58Driver::registers_read(const Registers& registers) {
  questions_.take_slip_flag((registers.status & status::slip) != 0);
  const LimitEnds::Change change = limits_.take(registers.limit);
  if (change.any) next_.asks_flags();
  motions_.met_switches(change.met);
  for (int i = 0; i < axes(); ++i) draft_.axes[i].home = bit(registers.home, i);
  lines_.take(registers.io);
}

void Vme58Driver::axes_read(int whole, Instant at) {
  speeds_.take(whole);
  values_.take(whole);
  for (int i = 0; i < axes(); ++i) {
    motions_.show(i, at);
    draft_.axes[i].own_speed = Pps(static_cast<double>(speeds_.own(i)));
  }
  samples_.take(at);
}

void Vme58Driver::record_round() {
  round_text_.clear();
  for (int i = 0; i < axes(); ++i)
    fmt::format_to(std::back_inserter(round_text_), "{}{}", i == 0 ? "" : " ", draft_.axes[i].position.value);
  wire_.record(Way::sent, Priority::poll, "data area");
  wire_.record(Way::received, Priority::poll, round_text_);
}

void Vme58Driver::show_worst() {
  draft_.notice.clear();
  commands_.show_late_if_any();
  if (draft_.program.run == RunState::error) draft_.notice = programs_.rejection();
  if (selection_.recording())
    draft_.notice = "A contour is being recorded: moves and set-up wait for its end (CE or CK).";
}

}  // namespace hw::vme58
