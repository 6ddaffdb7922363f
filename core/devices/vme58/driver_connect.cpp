// Assembly of the parts; connecting; the state after a reset or a lost window.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/device/nothing_known.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration start_patience = std::chrono::seconds(3);
constexpr Duration reset_patience = Millis(250);  // as for other text
constexpr Duration reset_look = Millis(1);

const Variant& variant_of(const Catalog& catalog) {
  const auto same = [&](const Variant& v) { return catalog.name.ends_with("-" + std::string(v.name)); };
  const auto found = std::find_if(variants.begin(), variants.end(), same);
  return found == variants.end() ? variants.front() : *found;
}

}  // namespace

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<Vme58Driver>(std::move(context));
}

Vme58Driver::Vme58Driver(DriverContext context)
    : catalog_(context.catalog),
      snapshot_(context.snapshot),
      script_texts_(context.texts),
      changed_(context.changed),
      talk_(context, *this),
      known_(talk_, variant_of(catalog_), context),
      work_(talk_, known_, context),
      strings_(talk_, known_, context),
      samples_(talk_.wire, talk_.readings, known_.values, catalog_, snapshot_, context.sample),
      finding_(talk_.wire, talk_.readings, talk_.selection, talk_.conversation, known_.values, known_.lines,
               catalog_, variant_of(catalog_), snapshot_) {
  strings_.texts.reset = [this](std::string text) { return reset_by_text(std::move(text)); };
  snapshot_.axis_count = axes();
  snapshot_.identity.model = catalog_.name;
  snapshot_.slot_bytes_used.fill(0);
  for (int i = 0; i < axes(); ++i) snapshot_.axes[i].has_encoder = variant_of(catalog_).fitting(i).encoder;
  forget();
}

// ---- loss of knowledge

void Vme58Driver::forget() {
  talk_.readings.forget();
  talk_.conversation.echoes(false);
  snapshot_.window.rings_known = false;
  known_.forget();
  strings_.forget();
}

/// Marks motions and program as lost: their ends are not seen.
void Vme58Driver::lose_motions() {
  known_.motions.lose(strings_.programs.is_running());
  strings_.programs.lose();
}

void Vme58Driver::wire_lost() {
  // The next connection selects an axis, which ends a recording on the board too.
  if (talk_.selection.end_recording())
    talk_.wire.report(Notice::Kind::warning,
                      "Record the contour again from its CD: its first part was lost with the connection.");
  lose_motions();
  known_.speeds.wire_lost();
  forget();
  set_up_is_unknown(snapshot_);
  nothing_is_known(snapshot_);
  talk_.conversation.lose();
  samples_.end();
  talk_.wire.detach();
}

// ---- connecting

void Vme58Driver::attach(Station& station) {
  talk_.wire.attach(station);
  talk_.conversation.lose();
  station.interrupted = [this](std::uint8_t) {
    if (changed_) changed_();
  };
}

Task<Result<>> Vme58Driver::connect() {
  auto found = co_await finding_.find();
  if (!found) co_return found;
  auto taken = co_await talk_.conversation.take_over();
  if (!taken) co_return taken;
  auto identified = co_await finding_.identify();
  if (!identified) co_return identified;
  const auto marked = co_await finding_.is_marked();
  if (!marked) co_return fail(marked.error());
  Result<> known;
  if (connected_before_ && !*marked)
    known = co_await found_reset(Doubt::restarted);
  else if (!*marked)
    known = co_await finding_.leave_mark();
  else if (!connected_before_)
    known = co_await finding_.forget_others_units();
  if (!known) co_return known;
  connected_before_ = true;
  if (*marked) known_.motions.others_may_move_all();  // begun by an earlier session or program
  co_return co_await read_state();
}

Task<Result<>> Vme58Driver::read_state() {
  known_.next.asks_flags();
  known_.next.asks_loops();
  known_.next.awaits_queues();  // another program may have left commands there
  auto all = co_await talk_.readings.read_all(Priority::intent);
  if (!all) co_return all;
  co_return co_await poll(Round::usual);
}

// ---- resets

// All settings are back at factory values. The mark is left immediately before the reset is reported: a stop
// finds the board still unmarked, or everything reported.
Task<Result<>> Vme58Driver::found_reset(Doubt why) {
  auto taken = co_await talk_.conversation.take_over();
  if (!taken) co_return taken;
  known_.values.gains_are_whole(true);
  auto marked = co_await finding_.leave_mark();
  if (!marked) co_return marked;
  talk_.wire.report(Notice::Kind::warning,
                    "The board has been reset, or switched off and on, since the console last read it. "
                    "Positions, set-up and queues have their factory values: home the axes again.");
  ++snapshot_.restarts;
  lose_motions();
  known_.speeds.forget();
  forget();
  talk_.selection.forget();
  talk_.selection.lose();  // connecting selected the user's old axis, before the reset was known
  known_.values.as_from_factory();
  known_.lines.as_from_factory();
  for (int i = 0; i < axes(); ++i) snapshot_.axes[i].trust.doubt(why, talk_.wire.now());
  std::string text = fmt::format("EF {}\n", talk_.selection.selector());
  auto quiet = co_await talk_.conversation.write(std::move(text), Priority::intent);
  if (quiet) talk_.selection.is_restored();
  co_return quiet;
}

/// RS within a text: complete once the board has started again and takes commands. RS also resets the ring,
/// which cannot show whether it was taken.
Task<Result<>> Vme58Driver::reset_by_text(std::string text) {
  const auto put = co_await talk_.conversation.put(std::move(text), Priority::intent);
  if (!put) co_return fail(put.error());
  if (*put) co_return co_await starts_again("RS was written into its ring.");
  co_return fail(FaultKind::no_answer, "The board accepts no RS now.", "Nothing was sent.",
                 "Use the console's own reset, which bypasses the ring.");
}

/// The console's own reset.
Task<Result<>> Vme58Driver::reset() {
  if (auto may = talk_.commands.may_talk(); !may) co_return may;
  auto mailed = co_await talk_.mailbox.mail("RS");
  if (mailed) mailed = co_await starts_again("RS was written into its mailbox.");
  if (!mailed) co_return fail(when_put(mailed.error()));
  co_return mailed;
}

/// `how`: words for how RS was sent.
Task<Result<>> Vme58Driver::starts_again(std::string_view how) {
  const Instant put_at = talk_.wire.now();
  bool seen = false;
  while (talk_.wire.is_open() && talk_.wire.now() < put_at + (seen ? start_patience : reset_patience)) {
    const auto registers = co_await talk_.readings.read_registers(Priority::intent, false);
    if (!registers) co_return fail(registers.error());
    seen = seen || !registers->started() || registers->mark == 0;
    if (!seen) talk_.readings.take(*registers);
    if (seen && registers->started()) {
      auto reset_handled = co_await found_reset(Doubt::reset);
      if (!reset_handled) co_return reset_handled;
      co_return co_await read_state();
    }
    auto paused = co_await talk_.wire.pause(reset_look);
    if (!paused) co_return paused;
  }
  co_return fail(FaultKind::no_answer,
                 seen ? "The board has not restarted." : "The board does not act on RS.", std::string(how),
                 "Reset the crate, or switch its power off and on.");
}

}  // namespace hw::vme58
