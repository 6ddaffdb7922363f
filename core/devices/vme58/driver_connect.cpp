// The parts put together; connecting; what is left after a reset or a lost window.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/device/nothing_known.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration start_patience = std::chrono::seconds(3);
constexpr Duration reset_patience = Millis(250);  // as of other text
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
      draft_(context.draft),
      texts_heard_(context.texts),
      changed_(std::move(context.changed)),
      wire_(context.scheduler, std::move(context.notify)),
      selection_(catalog_),
      readings_(wire_, catalog_, draft_, *this),
      conversation_(wire_, readings_, selection_, texts_heard_),
      mailbox_(wire_, conversation_),
      commands_(wire_, readings_, conversation_, selection_, catalog_, draft_),
      next_(draft_),
      queues_(catalog_, selection_, conversation_, draft_),
      values_(catalog_, variant_of(catalog_), readings_, draft_),
      limits_(draft_),
      loops_(wire_, catalog_, values_, next_, draft_),
      motions_(wire_, catalog_, readings_, selection_, limits_, loops_, next_, draft_),
      speeds_(readings_, selection_, commands_, queues_, motions_, catalog_, draft_),
      questions_(wire_, readings_, conversation_, selection_, queues_, limits_, loops_, motions_, speeds_,
                 next_, catalog_, draft_),
      lines_(wire_, readings_, selection_, commands_, catalog_, draft_),
      drive_(wire_, readings_, selection_, commands_, values_, loops_, motions_, next_, catalog_, draft_),
      moves_(wire_, readings_, selection_, conversation_, commands_, loops_, motions_, speeds_, catalog_,
             draft_),
      actions_(selection_, commands_, loops_, drive_, motions_, moves_, speeds_, next_, catalog_, draft_),
      setup_(wire_, readings_, selection_, commands_, values_, drive_, motions_, speeds_, catalog_, draft_),
      stop_effect_(wire_, readings_, motions_, catalog_),
      all_stop_(wire_, selection_, conversation_, mailbox_, queues_, motions_, stop_effect_, catalog_,
                draft_),
      effects_(selection_, conversation_, lines_, loops_, values_, motions_, speeds_, catalog_),
      feed_(readings_, selection_, conversation_, commands_, motions_, effects_, draft_),
      programs_(wire_, readings_, conversation_, commands_, motions_, speeds_, questions_, all_stop_, feed_,
                draft_),
      stops_(wire_, readings_, selection_, conversation_, motions_, speeds_, programs_, effects_,
             stop_effect_, all_stop_, next_, catalog_, draft_),
      texts_(readings_, selection_, conversation_, commands_, motions_, speeds_, feed_, programs_, effects_,
             next_, catalog_, draft_),
      samples_(wire_, readings_, values_, catalog_, draft_, std::move(context.sample)),
      finding_(wire_, readings_, selection_, conversation_, values_, lines_, catalog_, variant_of(catalog_),
               draft_) {
  commands_.rejected_late = [this](std::string& words) {
    motions_.queued_was_rejected();
    programs_.queued_was_rejected(words);
  };
  queues_.were_read = [this](const Queues::Room& room) {
    speeds_.take_queues(room.all_free);
    motions_.take_queues(room.all_free, room.were_empty, room.empty);
  };
  texts_.reset = [this](std::string text) { return reset_by_text(std::move(text)); };
  draft_.axis_count = axes();
  draft_.identity.model = catalog_.name;
  draft_.slot_bytes_used.fill(0);
  for (int i = 0; i < axes(); ++i) draft_.axes[i].has_encoder = variant_of(catalog_).fitting(i).encoder;
  speeds_.forget();
  forget();
}

// ---- what is not known any more

void Vme58Driver::forget() {
  next_.forget();
  readings_.forget();
  conversation_.echoes(false);
  draft_.window.rings_known = false;
  queues_.forget();
  limits_.forget();
  loops_.forget();
  motions_.forget();
  questions_.forget();
  programs_.forget();
  all_stop_.forget();
  stops_.forget();
}

/// Nobody has seen how they ended, or they will not.
void Vme58Driver::lose_motions() {
  motions_.lose(programs_.is_running());
  programs_.lose();
}

void Vme58Driver::wire_lost() {
  // Whoever connects anew selects an axis, which ends a recording on the board too.
  if (selection_.end_recording())
    wire_.tell(Notice::Kind::warning,
               "The contour that was being recorded is gone with the connection. Record it from its CD on.");
  lose_motions();
  speeds_.wire_lost();
  forget();
  set_up_is_unknown(draft_);
  nothing_is_known(draft_);
  conversation_.lose();
  samples_.end();
  wire_.detach();
}

// ---- connecting

void Vme58Driver::attach(Station& station) {
  wire_.attach(station);
  conversation_.lose();
  station.interrupted = [this](std::uint8_t) {
    if (changed_) changed_();
  };
}

Task<Result<>> Vme58Driver::connect() {
  auto found = co_await finding_.find();
  if (!found) co_return found;
  auto taken = co_await conversation_.take_over();
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
  if (*marked) motions_.others_may_move_all();  // by whoever spoke before
  co_return co_await read_state();
}

Task<Result<>> Vme58Driver::read_state() {
  next_.asks_flags();
  next_.asks_loops();
  next_.awaits_queues();  // another program may have left something there
  auto all = co_await readings_.read_all(Priority::intent);
  if (!all) co_return all;
  co_return co_await poll(Round::usual);
}

// ---- resets

// Everything that was set is as from the factory again. The mark is left before this is told, and not far
// behind: a stop in between finds the board unmarked as before, or all told.
Task<Result<>> Vme58Driver::found_reset(Doubt why) {
  auto taken = co_await conversation_.take_over();
  if (!taken) co_return taken;
  values_.gains_are_whole(true);
  auto marked = co_await finding_.leave_mark();
  if (!marked) co_return marked;
  wire_.tell(Notice::Kind::warning,
             "The board has been reset, or switched off and on, since the console last read it. Positions, "
             "set-up and queues are as from the factory; home the axes again.");
  ++draft_.restarts;
  lose_motions();
  speeds_.forget();
  forget();
  selection_.forget();
  selection_.lose();  // connecting anew has selected what the user's text had, before this was known
  values_.as_from_factory();
  lines_.as_from_factory();
  for (int i = 0; i < axes(); ++i) draft_.axes[i].trust.doubt(why, wire_.now());
  std::string text = fmt::format("EF {}\n", selection_.selector());
  auto quiet = co_await conversation_.write(std::move(text), Priority::intent);
  if (quiet) selection_.is_said();
  co_return quiet;
}

/// RS among a text: it is over when the board has started again, and takes what comes next. It leaves no ring
/// that could tell whether it was taken.
Task<Result<>> Vme58Driver::reset_by_text(std::string text) {
  const auto put = co_await conversation_.put(std::move(text), Priority::intent);
  if (!put) co_return fail(put.error());
  if (*put) co_return co_await starts_again("RS was put into its ring.");
  co_return fail(FaultKind::no_answer, "The board takes no RS now.", "Nothing was sent.",
                 "The console's own reset goes past the ring.");
}

/// The console's own.
Task<Result<>> Vme58Driver::reset() {
  if (auto may = commands_.may_talk(); !may) co_return may;
  auto mailed = co_await mailbox_.mail("RS");
  if (mailed) mailed = co_await starts_again("RS was put into its mailbox.");
  if (!mailed) co_return fail(when_put(mailed.error()));
  co_return mailed;
}

/// `how` it was told to.
Task<Result<>> Vme58Driver::starts_again(std::string_view how) {
  const Instant put_at = wire_.now();
  bool seen = false;
  while (wire_.is_open() && wire_.now() < put_at + (seen ? start_patience : reset_patience)) {
    const auto registers = co_await readings_.read_registers(Priority::intent, false);
    if (!registers) co_return fail(registers.error());
    seen = seen || !registers->started() || registers->mark == 0;
    if (!seen) readings_.take(*registers);
    if (seen && registers->started()) {
      auto told = co_await found_reset(Doubt::reset);
      if (!told) co_return told;
      co_return co_await read_state();
    }
    auto paused = co_await wire_.pause(reset_look);
    if (!paused) co_return paused;
  }
  co_return fail(FaultKind::no_answer,
                 seen ? "The board does not start again." : "The board does not act on RS.", std::string(how),
                 "Reset the crate, or switch its power off and on.");
}

}  // namespace hw::vme58
