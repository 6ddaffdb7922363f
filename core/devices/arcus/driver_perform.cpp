// What the driver is asked to do, and where it is done; the set-up as far as it concerns other parts too.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"
#include "core/devices/arcus/text_meaning.h"

namespace hw::arcus {

Task<Result<>> ArcusDriver::perform(const IntentBody& body) {
  using namespace intent;
  if (!talk_.is_open()) co_return talk_.no_connection();
  if (auto looked = co_await silence_.look(); !looked) co_return looked;
  if (auto returned = co_await borrowed_.give_back_first(); !returned) co_return returned;
  if (const auto* i = std::get_if<MoveTo>(&body)) co_return co_await moves_.move(i->targets, i->speed, false);
  if (const auto* i = std::get_if<MoveBy>(&body))
    co_return co_await moves_.move(i->distances, i->speed, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await moves_.jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await moves_.home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await moves_.set_position(*i);
  if (const auto* i = std::get_if<SetEncoder>(&body)) co_return co_await moves_.set_encoder(*i);
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await lines_.set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await lines_.set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await set_param(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await actions_.act(*i);
  if (const auto* i = std::get_if<SetVariable>(&body)) co_return co_await set_variable(*i);
  if (const auto* i = std::get_if<FeedMoves>(&body)) co_return co_await feed_.start(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await texts_.send(*i);
  if (const auto* i = std::get_if<Watch>(&body)) {
    readouts_.watch(i->groups);
    co_return Result<>();
  }
  if (const auto* i = std::get_if<ReadParams>(&body)) co_return co_await read_params(i->only);
  if (const auto* i = std::get_if<ReadAnalog>(&body);
      i && i->number >= 1 && i->number <= console_.model().analog_inputs)
    co_return co_await readouts_.read_analog(i->number, Priority::intent);
  if (std::holds_alternative<Store>(body)) co_return co_await setup_.store();
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_again();
  if (std::holds_alternative<Reset>(body))
    co_return fail(FaultKind::refused, fmt::format("A {} has no reset command.", console_.model().title),
                   "Nothing was sent.", "Switch its power off and on.");
  co_return co_await programs_.perform(body);
}

Task<Result<std::string>> ArcusDriver::stop(const StopOrder& order) {
  if (!talk_.is_open())
    co_return fail(FaultKind::lost, "Stop does not reach the controller: there is no connection.",
                   "Nothing was sent.", "Use its power switch.");
  if (order.what == StopOrder::What::words) co_return co_await texts_.stop(order);
  auto sent = co_await stops_.stop(order);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

StopProgress ArcusDriver::stop_progress(const StopOrder& order) { return stops_.progress(order); }

Task<Result<std::string>> ArcusDriver::query(std::string text, Duration patience) {
  return texts_.query(std::move(text), patience);
}

void ArcusDriver::overhear(const std::string& text) { texts_.overhear(text); }

TextMeaning ArcusDriver::meaning_of(const intent::SendText& text) const {
  return arcus::meaning_of(console_.forms, text,
                           Addressing{console_.catalog.address, setup_.param("AR") == 1});
}

// What follows from it: whether StepNLoop is on.
Task<Result<>> ArcusDriver::set_param(intent::SetParam wish) {
  auto exactly = co_await setup_.set(std::move(wish));
  if (!exactly) co_return fail(exactly.error());
  if (!*exactly) co_return Result<>();
  co_return co_await status_.read_loops(Priority::intent);
}

Task<Result<>> ArcusDriver::read_params(std::string only) {
  if (!only.empty()) {
    const int index = console_.catalog.find_param(only);
    if (index >= 0) co_return co_await setup_.read(index, Priority::intent);
  }
  for (int i = 0; i < static_cast<int>(console_.catalog.params.size()); ++i) {
    auto read = co_await setup_.read(i, Priority::transfer);
    if (!read) co_return read;
    co_await live_.read();
  }
  for (int n = console_.catalog.variables.stored_from; n < console_.catalog.variables.count; ++n) {
    auto read = co_await readouts_.read_variable(n, Priority::transfer);
    if (!read) co_return read;
    co_await live_.read();
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_again() {
  setup_.forget_all();
  console_.draft.variables_known.reset();
  motions_.loops_are_unknown();
  co_return co_await read_state();
}

}  // namespace hw::arcus
