#include "core/devices/vme58/finding.h"

#include <algorithm>

#include <fmt/core.h>

namespace hw::vme58 {
namespace {

constexpr std::uint16_t whole_gains_mark = 0x4857, broken_gains_mark = 0x4846;
constexpr Duration finding_patience = std::chrono::seconds(3);
constexpr std::uint16_t probe_step = 0x100;

}  // namespace

Task<Result<>> Finding::find() {
  const Instant give_up = wire_.now() + finding_patience;
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
      co_return fail(FaultKind::no_answer, "No board answers there: every byte of the window reads FF.",
                     "Nothing was written.",
                     "Check that the board is in the crate with power on, and that its address jumpers match "
                     "the address that you opened.");
    const std::uint32_t status = cycles.back().value;
    if ((status & status::initialized) != 0) {
      readings_.forget_command_error();
      co_return Result<>();
    }
    if (wire_.now() > give_up)
      co_return fail(FaultKind::no_answer,
                     fmt::format("The device at this address does not report that it has started: its status "
                                 "register reads {:02X}, with bit 1 off.",
                                 status),
                     "Nothing was written.", "Check the board's address. If it is right, reset the crate.");
    auto paused = co_await wire_.pause(Millis(50));
    if (!paused) co_return paused;
  }
}

Task<Result<>> Finding::identify() {
  std::string text = "EF\n";
  auto quiet = co_await conversation_.write(std::move(text), Priority::intent);
  if (!quiet) co_return quiet;
  auto let = co_await conversation_.let_go();  // text echoed for another program is not a reply
  if (!let) co_return let;
  auto asked = co_await ask_variant();
  if (!asked) co_return asked;
  const ReplyForm hex{ReplyForm::Of::hex};
  text = "RB\n";
  auto directions = co_await conversation_.ask(std::move(text), Priority::intent, hex);
  if (!directions) co_return fail(directions.error());
  lines_.take_directions(decode_hex(*directions).value_or(factory_outputs));
  co_return Result<>();
}

Task<Result<>> Finding::ask_variant() {
  std::string text = "WY\n";
  auto name = co_await conversation_.ask(std::move(text), Priority::intent);
  if (!name) co_return fail(name.error());
  const auto greeting = decode_greeting(*name);
  if (!greeting)
    co_return fail(FaultKind::garbled,
                   fmt::format("The device that answers WY is not a VME58: \"{}\".", *name),
                   "Nothing more was sent.", "Check the address.");
  snapshot_.identity.model =
      greeting->variant.empty() ? greeting->model : greeting->model + "-" + greeting->variant;
  snapshot_.identity.firmware = greeting->version;
  co_return co_await ask_axes(greeting->variant);
}

Task<Result<>> Finding::ask_axes(std::string_view reported_variant) {
  const ReplyForm numbers{ReplyForm::Of::numbers};
  std::string text = fmt::format("AA RP {}\n", selection_.selector());  // ends with the user's selection
  auto positions = co_await conversation_.ask(std::move(text), Priority::intent, numbers);
  if (!positions) co_return fail(positions.error());
  const auto fields = decode_numbers(*positions);
  const int axes = fields ? static_cast<int>(fields->size()) : 0;
  const bool is_named = !reported_variant.empty();
  if (axes != variant_.axes() || (is_named && find_variant(reported_variant) != &variant_)) {
    const std::string own = is_named ? fmt::format("variant={}", reported_variant) : "its own variant";
    wire_.report(Notice::Kind::warning,
                 fmt::format("Open the board with {3} in its address: it reports that it is a {0} "
                             "with {1} axes, and it was opened as an {2}.",
                             snapshot_.identity.model.view(), axes, catalog_.name, own));
  }
  co_return Result<>();
}

Task<Result<>> Finding::forget_others_units() {
  std::string text;
  for (const AxisInfo& axis : catalog_.axes) text += fmt::format("A{} UF ", axis.name);
  text += selection_.selector() + "\n";
  co_return co_await conversation_.write(std::move(text), Priority::intent);
}

// Whether the cell holds a mark; another program's mark counts too.
Task<Result<bool>> Finding::is_marked() {
  std::vector<BusCycle>& cycles = wire_.burst();
  cycles.push_back(BusCycle::read(2, at::reserved1));
  auto looked = co_await wire_.run(cycles, Priority::intent);
  if (!looked) co_return fail(looked.error());
  const std::uint32_t found = cycles[0].value;
  values_.gains_are_whole(found == 0 || found == whole_gains_mark);
  co_return found != 0;
}

Task<Result<>> Finding::leave_mark() {
  values_.mark_was_left();
  std::vector<BusCycle>& cycles = wire_.burst();
  const std::uint16_t ours = values_.gains_are_whole() ? whole_gains_mark : broken_gains_mark;
  cycles.push_back(BusCycle::store(2, at::reserved1, ours));
  co_return co_await wire_.run(cycles, Priority::intent);
}

}  // namespace hw::vme58
