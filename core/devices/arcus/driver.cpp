// Passes intents to the parts; the set-up as far as it concerns several parts.
#include "core/devices/arcus/driver.h"

#include <fmt/core.h>

#include "core/device/driver_faults.h"
#include "core/devices/arcus/text_goals.h"
#include "core/devices/arcus/text_meaning.h"

namespace hw::arcus {

ArcusDriver::ArcusDriver(DriverContext context, const Forms& forms, const language::Dialect& dialect)
    : console_(std::move(context), forms),
      conversation_(console_),
      known_(console_, conversation_,
             [this](std::string_view how_it_shows, unsigned moved) { restarted(how_it_shows, moved); }),
      work_(console_, conversation_, known_, dialect),
      silence_(console_, known_.watch, known_.status, known_.threads, known_.lines),
      stops_(console_, conversation_, known_.code, known_.setup, known_.list, known_.motions, known_.status,
             known_.threads),
      texts_(console_, conversation_, known_.code, known_.borrowed, known_.setup, known_.list, known_.watch,
             known_.motions, known_.readouts, known_.threads, known_.lines, silence_),
      finding_(console_, conversation_) {
  console_.snapshot.axis_count = console_.axes();
  console_.snapshot.identity.model = console_.catalog.name;
  for (int i = 0; i < console_.axes(); ++i) console_.snapshot.axes[i].enabled = false;
}

void ArcusDriver::attach(Station& station) { conversation_.attach(station); }

Task<Result<>> ArcusDriver::perform(const IntentBody& body) {
  using namespace intent;
  if (!conversation_.is_open()) co_return conversation_.no_connection();
  if (auto looked = co_await silence_.look(); !looked) co_return looked;
  if (auto returned = co_await undo_borrowed(body); !returned) co_return returned;
  if (const auto* i = std::get_if<MoveTo>(&body))
    co_return co_await work_.moves.move(i->targets, pace_of(*i), false);
  if (const auto* i = std::get_if<MoveBy>(&body))
    co_return co_await work_.moves.move(i->distances, pace_of(*i), true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await work_.moves.home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await work_.moves.set_position(*i);
  if (const auto* i = std::get_if<SetEncoder>(&body)) co_return co_await work_.moves.set_encoder(*i);
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await known_.lines.set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await known_.lines.set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await set_param(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await work_.actions.act(*i);
  if (const auto* i = std::get_if<GuardJogs>(&body); i && i->on) co_return co_await work_.guard.install();
  if (std::holds_alternative<GuardJogs>(body)) co_return co_await work_.guard.remove();
  if (const auto* i = std::get_if<SetVariable>(&body)) co_return co_await set_variable(*i);
  if (const auto* i = std::get_if<FeedMoves>(&body)) co_return co_await work_.feed.start(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await texts_.send(*i);
  if (const auto* i = std::get_if<Watch>(&body)) {
    known_.readouts.watch(i->groups);
    co_return Result<>();
  }
  if (const auto* i = std::get_if<ReadParams>(&body)) co_return co_await read_params(i->only);
  if (const auto* i = std::get_if<ReadAnalog>(&body);
      i && i->number >= 1 && i->number <= console_.model().analog_inputs)
    co_return co_await known_.readouts.read_analog(i->number, Priority::intent);
  if (std::holds_alternative<Store>(body)) co_return co_await known_.setup.store();
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_again();
  if (std::holds_alternative<Reset>(body))
    co_return fail(FaultKind::refused, fmt::format("A {} has no reset command.", console_.model().title),
                   "Nothing was sent.", "Switch its power off and on.");
  co_return co_await work_.programs.perform(body);
}

Task<Result<std::string>> ArcusDriver::stop(const StopOrder& order) {
  if (!conversation_.is_open()) co_return stop_cannot_reach("controller", "Use its power switch.");
  if (order.what == StopOrder::What::words) co_return co_await texts_.stop(order);
  Result<> sent;
  if (order.what == StopOrder::What::tool)
    sent = co_await known_.lines.switch_tool_off(order.tool);
  else
    sent = co_await stops_.stop(order);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

LastWill ArcusDriver::last_will(unsigned axes) const { return stops_.last_will(axes); }

StopProgress ArcusDriver::stop_progress(const StopOrder& order) { return stops_.progress(order); }

Task<Result<std::string>> ArcusDriver::query(std::string text, Duration patience) {
  if (conversation_.is_open())
    if (auto let = co_await work_.guard.let_go(); !let) co_return fail(let.error());
  if (auto may = guard_allows(text); !may) co_return fail(may.error());
  co_return co_await texts_.query(std::move(text), patience);
}

void ArcusDriver::note_broadcast(const std::string& text) {
  texts_.note_broadcast(text);
  work_.guard.goes_out(command_in(text));
}

TextMeaning ArcusDriver::meaning_of(const intent::SendText& text) const {
  return arcus::meaning_of(console_.forms, text,
                           Addressing{console_.catalog.address, known_.setup.param("AR") == 1});
}

TextGoals ArcusDriver::goals_of(std::string_view text) const {
  return arcus::goals_of(console_.forms, text, console_.catalog.address, known_.readouts.known_incremental(),
                         console_.snapshot);
}

std::string ArcusDriver::leaves_behind() const {
  const std::string left = work_.stored.leaves_behind(), borrowed = known_.borrowed.leaves_behind();
  return left.empty() || borrowed.empty() ? left + borrowed : left + ' ' + borrowed;
}

// Then reads what may follow from it: whether StepNLoop is on.
Task<Result<>> ArcusDriver::set_param(intent::SetParam request) {
  auto exactly = co_await known_.setup.set(std::move(request));
  if (!exactly) co_return fail(exactly.error());
  if (!*exactly) co_return Result<>();
  co_return co_await known_.status.read_loops(Priority::intent);
}

Task<Result<>> ArcusDriver::undo_borrowed(const IntentBody& before) {
  auto returned = co_await known_.borrowed.give_back_first();
  if (returned) returned = co_await work_.guard.let_go();
  const bool rewrites = std::holds_alternative<intent::LoadProgram>(before) ||
                        std::holds_alternative<intent::ClearProgram>(before);
  if (returned && rewrites) returned = work_.guard.may_be_overwritten();
  if (!returned) co_return returned;
  if (const auto* i = std::get_if<intent::SendText>(&before)) co_return guard_allows(i->text);
  if (std::holds_alternative<intent::Store>(before)) co_return work_.guard.allows("STORE");
  if (const auto* i = std::get_if<intent::SetParam>(&before))
    co_return work_.guard.allows(fmt::format("{}=", i->mnemonic));
  co_return returned;
}

// Checks texts to this device, alone or among all.
Result<> ArcusDriver::guard_allows(const std::string& text) const {
  const int to = address_of(text);
  const bool anothers = to >= 0 && to != console_.catalog.address && to != console_.model().broadcast;
  return anothers ? Result<>() : work_.guard.allows(command_in(text));
}

// A script's jog gets no guard: see Pump::keep_will().
Task<Result<>> ArcusDriver::jog(intent::JogStart request) {
  if (request.dead_man)
    if (auto watched = co_await work_.guard.watch(request.axis.index); !watched) co_return watched;
  co_return co_await work_.moves.jog(std::move(request));
}

Task<Result<>> ArcusDriver::set_variable(const intent::SetVariable& request) {
  const VariableFacts& facts = console_.catalog.variables;
  if (request.number < 0 || request.number >= facts.count || request.value < facts.minimum ||
      request.value > facts.maximum)
    co_return fail(FaultKind::refused,
                   fmt::format("V{} cannot be set to {}: the variables are V0 to V{}, each from {} to {}.",
                               request.number, request.value, facts.count - 1, facts.minimum, facts.maximum),
                   "Nothing was sent.");
  auto set = co_await conversation_.command(set_command(fmt::format("V{}", request.number), request.value),
                                            Priority::intent);
  if (!set) co_return set;
  if (request.number >= facts.stored_from) known_.setup.variable_is_unsaved();
  co_return co_await known_.readouts.read_variable(request.number, Priority::intent);
}

Task<Result<>> ArcusDriver::read_params(std::string only) {
  if (!only.empty()) {
    const int index = console_.catalog.find_param(only);
    if (index >= 0) co_return co_await known_.setup.read(index, Priority::intent);
    const auto variable =
        only.front() == 'V' ? decode_number(std::string_view(only).substr(1)) : std::nullopt;
    if (variable && *variable >= 0 && *variable < console_.catalog.variables.count)
      co_return co_await known_.readouts.read_variable(static_cast<int>(*variable), Priority::intent);
  }
  for (int i = 0; i < static_cast<int>(console_.catalog.params.size()); ++i) {
    auto read = co_await known_.setup.read(i, Priority::transfer);
    if (!read) co_return read;
    co_await work_.live.read();
  }
  for (int n = console_.catalog.variables.stored_from; n < console_.catalog.variables.count; ++n) {
    auto read = co_await known_.readouts.read_variable(n, Priority::transfer);
    if (!read) co_return read;
    co_await work_.live.read();
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_again() {
  known_.setup.forget_all();
  console_.snapshot.variables_known.reset();
  known_.motions.loops_are_unknown();
  co_return co_await read_state();
}

}  // namespace hw::arcus
