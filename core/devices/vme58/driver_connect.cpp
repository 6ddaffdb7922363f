// Finding the board and saying why not; what is left after a reset or a lost window.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

// In a cell that only a reset clears.
constexpr std::uint16_t whole_gains_mark = 0x4857, broken_gains_mark = 0x4846;
constexpr Duration start_patience = std::chrono::seconds(3);
constexpr Duration reset_patience = Millis(250);  // as of other text
constexpr Duration reset_look = Millis(1);
constexpr std::uint16_t probe_step = 0x100;

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
      texts_(context.texts),
      changed_(std::move(context.changed)),
      sample_(std::move(context.sample)),
      variant_(variant_of(catalog_)),
      parameters_(parameters_of(variant_)),
      wire_(context.scheduler, std::move(context.notify)),
      selection_(catalog_),
      readings_(wire_, catalog_, draft_, *this),
      conversation_(wire_, readings_, selection_, texts_),
      mailbox_(wire_, conversation_),
      commands_(wire_, readings_, conversation_, selection_, catalog_, draft_) {
  commands_.rejected_late = [this](std::string& words) { queued_was_rejected(words); };
  draft_.axis_count = axis_count();
  draft_.identity.model = catalog_.name;
  draft_.slot_bytes_used.fill(0);
  forget();
}

void Vme58Driver::forget() {
  minds_ = {};
  readings_.forget();
  to_feed_.clear();
  feeding_.clear();
  limits_ = homes_ = slips_ = 0;
  flags_wanted_ = true;
  queues_due_ = queues_empty_ = draft_.working = false;
  conversation_.echoes(false);
  widened_ = false;
  draft_.queue_known = 0;
  draft_.window.rings_known = false;
  draft_.program.run = RunState::idle;
  draft_.program.owned = draft_.feed.running = false;
  for (int i = 0; i < axis_count(); ++i) {
    AxisState& axis = draft_.axes[i];
    axis.limits_known = false;
    axis.has_encoder = variant_.fitting(i).encoder;
    know_loop(i, std::nullopt);
    axis.activity = Activity::unknown;
    axis.speed = axis.own_speed = {};
    axis.direction = 0;
  }
}

/// Nobody has seen how it ended, or it will not.
void Vme58Driver::lose_motions() {
  const bool runs = draft_.program.run == RunState::running;
  for (int i = 0; i < axis_count(); ++i) {
    const AxisMind& mind = minds_[ix(i)];
    const bool waits = mind.by_text && (draft_.working || runs);
    if (moving(i) || mind.ours || waits) draft_.axes[i].ended_by = EndedBy::lost;
  }
  if (runs) draft_.program.ended_by = EndedBy::lost;
}

void Vme58Driver::wire_lost() {
  // Whoever connects anew selects an axis, which ends a recording on the board too.
  if (selection_.end_recording())
    tell(Notice::Kind::warning,
         "The contour that was being recorded is gone with the connection. Record it from its CD on.");
  lose_motions();
  for (int i = 0; i < axis_count(); ++i) draft_.axes[i].position_known = false;
  std::array<std::optional<Borrowed>, max_axes> borrowed;
  for (int i = 0; i < axis_count(); ++i) borrowed[ix(i)] = minds_[ix(i)].velocity;
  forget();
  for (int i = 0; i < axis_count(); ++i) {
    minds_[ix(i)].velocity = borrowed[ix(i)];
    if (minds_[ix(i)].velocity) minds_[ix(i)].velocity->left_alone = true;
  }
  for (ParamState& p : draft_.params) p.known = false;
  draft_.inputs_known = draft_.outputs_known = 0;
  draft_.window.known = false;
  conversation_.lose();
  sampled_axis_ = -1;
  wire_.detach();
}

void Vme58Driver::attach(Station& station) {
  wire_.attach(station);
  conversation_.lose();
  station.interrupted = [this](std::uint8_t) {
    if (changed_) changed_();
  };
}

Task<Result<>> Vme58Driver::connect() {
  auto found = co_await find_board();
  if (!found) co_return found;
  auto taken = co_await conversation_.take_over();
  if (!taken) co_return taken;
  auto identified = co_await identify();
  if (!identified) co_return identified;
  std::vector<BusCycle>& cycles = wire_.burst();
  cycles.push_back(BusCycle::read(2, at::reserved1));
  auto looked = co_await wire_.run(cycles, Priority::intent);
  if (!looked) co_return looked;
  const std::uint32_t mark = cycles[0].value;
  const bool unmarked = mark == 0;  // another program's mark serves as well
  gains_are_whole_ = unmarked || mark == whole_gains_mark;
  const bool was_reset = connected_before_ && unmarked;
  const bool others_were_here = !connected_before_ && !unmarked;
  Result<> known;
  if (was_reset)
    known = co_await found_reset(Doubt::restarted);
  else if (unmarked)
    known = co_await leave_mark();
  else if (others_were_here)
    known = co_await forget_others_units();
  if (!known) co_return known;
  connected_before_ = true;
  if (!unmarked)
    for (AxisMind& mind : minds_) mind.in_group = mind.listed = true;  // by whoever spoke before
  co_return co_await read_state();
}

// Only reads, and none that a board would answer by doing something but clear its flags.
Task<Result<>> Vme58Driver::find_board() {
  const Instant give_up = now() + start_patience;
  for (;;) {
    std::vector<BusCycle>& cycles = wire_.burst();
    for (std::uint16_t offset = 0; offset < reg::control; offset += probe_step)
      cycles.push_back(BusCycle::read(2, offset));
    cycles.push_back(BusCycle::read(1, reg::status));
    auto read = co_await wire_.run(cycles, Priority::intent);
    if (!read) co_return read;
    const bool ones = std::all_of(cycles.begin(), cycles.end(), [](const BusCycle& c) {
      return c.value == (c.width == 1 ? 0xFFu : 0xFFFFu);
    });
    if (ones)
      co_return fail(
          FaultKind::no_answer, "No board answers there: every byte of the window reads FF.",
          "Nothing was written.",
          "Check that the board stands in the crate with power on, and that its address jumpers and "
          "the address that was opened agree.");
    const std::uint32_t status = cycles.back().value;
    if ((status & status::initialized) != 0) {
      readings_.forget_command_error();
      co_return Result<>();
    }
    if (now() > give_up)
      co_return fail(
          FaultKind::no_answer,
          fmt::format("What is there does not report that it has started: its status register reads "
                      "{:02X}, with bit 1 off.",
                      status),
          "Nothing was written.", "Check the board's address. If it is right, reset the crate.");
    auto paused = co_await wire_.pause(Millis(50));
    if (!paused) co_return paused;
  }
}

Task<Result<>> Vme58Driver::identify() {
  auto quiet = co_await conversation_.write("EF\n", Priority::intent);
  if (!quiet) co_return quiet;
  // Echoed by a board that another program has left so: no reply to anything.
  auto let = co_await conversation_.let_go();
  if (!let) co_return let;
  auto name = co_await conversation_.ask("WY\n", Priority::intent);
  if (!name) co_return fail(name.error());
  const auto greeting = decode_greeting(*name);
  if (!greeting)
    co_return fail(FaultKind::garbled, fmt::format("What answers to WY is no VME58: \"{}\".", *name),
                   "Nothing more was sent.", "Check the address.");
  draft_.identity.model =
      greeting->variant.empty() ? greeting->model : greeting->model + "-" + greeting->variant;
  draft_.identity.firmware = greeting->version;
  std::string axes_question = fmt::format("AA RP {}\n", selection_.selector());  // where the user's text stands
  auto positions = co_await conversation_.ask(std::move(axes_question), Priority::intent, {ReplyForm::Of::numbers});
  if (!positions) co_return fail(positions.error());
  const auto fields = decode_numbers(*positions);
  const int axes = fields ? static_cast<int>(fields->size()) : 0;
  if (axes == 0)
    co_return fail(
        FaultKind::garbled,
        fmt::format("The board answered \"{}\" to RP for all axes, which means nothing.", *positions),
        "Nothing was changed.", "Connect again.");
  if (axes != variant_.axes() || (!greeting->variant.empty() && find_variant(greeting->variant) != &variant_))
    tell(Notice::Kind::warning,
         fmt::format(
             "The board says that it is a {} with {} axes; it was opened as an {}. Open it with variant={} "
             "in its address.",
             draft_.identity.model.view(), axes, catalog_.name, greeting->variant));
  auto directions = co_await conversation_.ask("RB\n", Priority::intent, {ReplyForm::Of::hex});
  if (!directions) co_return fail(directions.error());
  outputs_direction_ = static_cast<int>(decode_hex(*directions).value_or(factory_outputs));
  tell_other_jumpers();
  co_return Result<>();
}

/// The lines are shown in the directions that the address tells. Another board says so.
void Vme58Driver::tell_other_jumpers() {
  const auto is_output = [this](int line) { return bit(static_cast<unsigned>(outputs_direction_), line); };
  const bool same = std::all_of(catalog_.inputs.begin(), catalog_.inputs.end(), [&](const InputInfo& line) {
    return line.of_output == is_output(line.number);
  });
  if (same) return;
  std::string jumpers;
  for (int line = 0; line < first_fixed_output; line += lines_of_a_group)
    jumpers += is_output(line) ? 'O' : 'I';
  tell(Notice::Kind::warning,
       fmt::format("The general lines of the board do not go the ways that are shown here. Open it with "
                   "jumpers={} in its address.",
                   jumpers));
}

// User units that another program has left on would scale all that this one sends.
Task<Result<>> Vme58Driver::forget_others_units() {
  std::string text;
  for (int i = 0; i < axis_count(); ++i) text += fmt::format("A{} UF ", axis_name(i));
  text += selection_.selector() + "\n";
  co_return co_await conversation_.write(std::move(text), Priority::intent);
}

/// A later session reads in it whether the whole numbers that the data area shows of the gains are all of
/// them.
Task<Result<>> Vme58Driver::leave_mark() {
  std::vector<BusCycle>& cycles = wire_.burst();
  mark_due_ = false;
  const std::uint16_t ours = gains_are_whole_ ? whole_gains_mark : broken_gains_mark;
  cycles.push_back(BusCycle::store(2, at::reserved1, ours));
  co_return co_await wire_.run(cycles, Priority::intent);
}

// Everything that was set is as from the factory again. The mark is left before this is told, and not far
// behind: a stop in between finds the board unmarked as before, or all told.
Task<Result<>> Vme58Driver::found_reset(Doubt why) {
  auto taken = co_await conversation_.take_over();
  if (!taken) co_return taken;
  gains_are_whole_ = true;
  auto marked = co_await leave_mark();
  if (!marked) co_return marked;
  tell(Notice::Kind::warning,
       "The board has been reset, or switched off and on, since the console last read it. Positions, set-up "
       "and "
       "queues are as from the factory; home the axes again.");
  ++draft_.restarts;
  lose_motions();
  forget();
  selection_.forget();
  selection_.lose();  // connecting anew has selected what the user's text had, before this was known
  factory_params();
  for (int i = 0; i < axis_count(); ++i) draft_.axes[i].trust.doubt(why, now());
  std::string quiet_text = fmt::format("EF {}\n", selection_.selector());
  auto quiet = co_await conversation_.write(std::move(quiet_text), Priority::intent);
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

/// The console's own reset.
Task<Result<>> Vme58Driver::reset() {
  if (auto may = commands_.may_talk(); !may) co_return may;
  auto mailed = co_await mailbox_.mail("RS");
  if (mailed) mailed = co_await starts_again("RS was put into its mailbox.");
  if (!mailed) co_return fail(when_put(mailed.error()));
  co_return mailed;
}

/// `how` it was told to.
Task<Result<>> Vme58Driver::starts_again(std::string_view how) {
  const Instant put_at = now();
  bool seen = false;
  while (wire_.is_open() && now() < put_at + (seen ? start_patience : reset_patience)) {
    const auto registers = co_await readings_.read_registers(Priority::intent, false);
    if (!registers) co_return fail(registers.error());
    const bool started = (registers->status & status::initialized) != 0;
    seen = seen || !started || registers->mark == 0;
    if (!seen) readings_.take(*registers);
    if (seen && started) {
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

Task<Result<>> Vme58Driver::read_state() {
  flags_wanted_ = loops_wanted_ = true;
  draft_.working = queues_due_ = true;  // another program may have left something in the queues
  auto all = co_await readings_.read_all(Priority::intent);
  if (!all) co_return all;
  co_return co_await poll(Round::usual);
}

}  // namespace hw::vme58
