// The parts of the driver, and its calls.
#include "core/devices/vxm/driver.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/driver_faults.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/text_goals.h"
#include "core/devices/vxm/text_meaning.h"

namespace hw::vxm {

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<VxmDriver>(std::move(context));
}

VxmDriver::VxmDriver(DriverContext context)
    : console_(std::move(context)),
      conversation_(
          console_.scheduler, [this] { return listening(); },
          [this](const Message& m) { watch_.unsolicited.received(m); }),
      known_(console_, conversation_, [this] { return course_.admission.may_change(); }),
      course_(console_, conversation_, known_),
      work_(console_, conversation_, known_, course_),
      watch_(console_, conversation_, known_, course_, work_) {
  console_.snapshot.axis_count = static_cast<int>(console_.catalog.axes.size());
  console_.snapshot.identity.model = console_.catalog.name;
  console_.snapshot.slot_bytes_used.fill(-1);
}

// ---- the wire

void VxmDriver::attach(Station& station) {
  course_.presence.forget_mode();
  watch_.echo.begin();
  conversation_.attach(station);
  known_.signals.begin();
  station.procedure_ended = [this] { course_.under_way.news().notify(); };
}

void VxmDriver::wire_lost() {
  if (!conversation_.station()) return;
  conversation_.lost();
  course_.under_way.wire_lost();
}

Task<Result<>> VxmDriver::connect() {
  conversation_.use_long_deadlines(true);
  auto made = co_await find_out_all();
  conversation_.use_long_deadlines(false);
  co_return made;
}

Task<Result<>> VxmDriver::find_out_all() {
  auto greeted = co_await watch_.opening.greet();
  if (!greeted) co_return greeted;
  course_.presence.is_found();
  if (conversation_.station()) known_.parameters.found_at(conversation_.station()->rate());
  if (!course_.under_way.busy() && !conversation_.echoes()) {
    auto caught_up = co_await known_.knowledge.catch_up();
    if (!caught_up) co_return caught_up;
  }
  auto polled = co_await poll(Round::usual);
  if (polled || !worth_another_try(polled.error())) co_return polled;
  auto quiet = co_await conversation_.wait_for_quiet();  // a status byte is asked once a round
  if (!quiet) co_return quiet;
  co_return co_await poll(Round::usual);
}

Listening VxmDriver::listening() const {
  Listening now;
  now.local = course_.presence.is_local(), now.running = course_.under_way.busy();
  now.halted = course_.presence.is_halted();
  now.digitized_lines = known_.identification.has_slave() ? max_motors : motors_per_controller;
  return now;
}

Task<Result<>> VxmDriver::poll(Round round) { return watch_.rounds.poll(round); }

Duration VxmDriver::moving_period() const { return watch_.rounds.moving_period(); }

bool VxmDriver::clears_up() const { return work_.legs.clears_up(); }

std::string VxmDriver::leaves_behind() const { return work_.legs.leaves_behind(); }

// ---- stops

Task<Result<std::string>> VxmDriver::stop(const StopOrder& order) {
  using What = StopOrder::What;
  if (!conversation_.station()) co_return stop_cannot_reach("controller", "Use its power switch.");
  if (order.what == What::broadcast) co_return std::string();  // a VXM is alone on its wire
  if (order.what == What::words) co_return co_await work_.texts.stop_by_words(order);
  auto sent = co_await work_.stops.send(order);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

LastWill VxmDriver::last_will(unsigned) const { return Stops::last_will(); }

StopProgress VxmDriver::stop_progress(const StopOrder& order) { return work_.stops.progress(order); }

// ---- texts

Task<Result<std::string>> VxmDriver::query(std::string text, Duration patience) {
  auto is_ready = co_await make_ready();
  if (!is_ready) co_return fail(is_ready.error());
  co_return co_await work_.texts.converse(std::move(text), patience, Priority::intent);
}

TextMeaning VxmDriver::meaning_of(const intent::SendText& text) const {
  return vxm::meaning_of(text.text, listening(), course_.under_way.job().active());
}

TextGoals VxmDriver::goals_of(std::string_view text) const {
  HeldPrograms held;
  for (int slot = 0; slot < program_count; ++slot) held.contents[ix(slot)] = known_.slots.contents(slot);
  held.selected = known_.slots.selected();
  held.program_4_first = (known_.parameters.value("DM").value_or(0) & mode_program_4_first) != 0;
  return vxm::goals_of(text, listening(), std::move(held), console_.snapshot);
}

// ---- requests

// Ensures that the next request meets a known controller that listens.
Task<Result<>> VxmDriver::make_ready() {
  auto clean = co_await course_.status.clean_if_dirty();
  if (!clean) co_return clean;
  auto received = co_await watch_.echo.end_before_request();
  if (!received) co_return received;
  co_return co_await work_.legs.settle();
}

Task<Result<>> VxmDriver::perform(const IntentBody& body) {
  using namespace intent;
  const auto* text = std::get_if<SendText>(&body);
  if (course_.presence.stays_local() && !text) {  // Q was sent earlier; this needs on-line mode
    auto on_line = co_await course_.presence.go_on_line();
    if (!on_line) co_return on_line;
    course_.presence.wants_on_line();
  }
  auto is_ready = co_await make_ready();
  if (!is_ready) co_return is_ready;
  if (text) co_return co_await work_.texts.send(text->text);
  if (const auto* i = std::get_if<MoveTo>(&body))
    co_return co_await work_.moves.move(i->targets, pace_of(*i), i->own_speeds, false);
  if (const auto* i = std::get_if<MoveBy>(&body))
    co_return co_await work_.moves.move(i->distances, pace_of(*i), i->own_speeds, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await work_.moves.jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await work_.moves.home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await work_.moves.set_position(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await work_.moves.set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) {
    if (i->mnemonic == "DM") known_.identification.forget();  // it may become the Master
    co_return co_await known_.parameters.set(*i);
  }
  if (std::holds_alternative<ReadParams>(body)) co_return co_await known_.parameters.read_all();
  if (std::holds_alternative<Store>(body)) co_return co_await known_.parameters.store();
  if (std::holds_alternative<Reset>(body)) co_return co_await course_.restarts.reset();
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_again();
  co_return co_await perform_program(body);
}

Task<Result<>> VxmDriver::perform_program(const IntentBody& body) {
  using namespace intent;
  const int slot = slot_of(body);
  if (slot >= program_count || slot < -1)
    co_return fail(FaultKind::refused, fmt::format("There is no program {}: programs are 0 to 4.", slot),
                   "Nothing was sent.");
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return co_await known_.slots.load(*i);
  if (std::holds_alternative<Pause>(body)) co_return co_await work_.runs.pause();
  if (std::holds_alternative<Resume>(body)) co_return co_await work_.runs.resume();
  if (std::holds_alternative<SingleStep>(body)) co_return co_await work_.runs.single_step();
  if (slot >= 0) {
    if (std::holds_alternative<RunProgram>(body)) co_return co_await work_.runs.run(slot);
    if (std::holds_alternative<UploadProgram>(body)) co_return co_await known_.slots.upload(slot);
    if (std::holds_alternative<ClearProgram>(body)) co_return co_await known_.slots.clear(slot);
    if (std::holds_alternative<SelectProgram>(body)) co_return co_await known_.slots.select(slot);
  } else if (std::holds_alternative<RunProgram>(body) && known_.slots.selected() >= 0) {
    co_return co_await work_.runs.run(known_.slots.selected());
  }
  co_return fail(FaultKind::refused, "A VXM has no command for this.", "Nothing was sent.");
}

int VxmDriver::slot_of(const IntentBody& body) {
  using namespace intent;
  if (const auto* i = std::get_if<LoadProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<RunProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<UploadProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<ClearProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<SelectProgram>(&body)) return i->slot;
  return -1;
}

Task<Result<>> VxmDriver::read_again() {
  if (course_.under_way.busy()) co_return co_await poll(Round::usual);
  known_.knowledge.doubt();
  auto read = co_await known_.knowledge.catch_up();
  if (!read) co_return read;
  co_return co_await poll(Round::usual);
}

}  // namespace hw::vxm
