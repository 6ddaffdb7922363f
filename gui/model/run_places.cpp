#include "gui/model/run_places.h"

#include <bit>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"
#include "core/device/sequence_travel.h"
#include "core/device/travel_check.h"
#include "gui/model/tab.h"

namespace hw::gui {

static constexpr std::string_view not_started = "The program was not started.";  // loaded or not

std::vector<AxisTarget> places_of_held(Desk& desk, int slot, const Catalog& catalog, const Snapshot& now) {
  if (slot < 0 || slot >= desk.programs.texts.count() || !desk.programs.texts.held(slot).known) return {};
  const WrittenSequence* source = desk.programs.source.of(desk.programs.texts.held(slot).text, desk.blocks,
                                                          desk.programs.language(), catalog);
  return source ? places_of_run(*source->sequence, catalog, now) : std::vector<AxisTarget>();
}

std::string why_not_run_there(const Tab& tab, const sequence::Sequence& sequence) {
  const Catalog& catalog = tab.catalog();
  const intent::RunProgram run(0, places_of_run(sequence, catalog, tab.now()));
  if (const auto past = past_travel(catalog, tab.now(), run))
    return describe_past(catalog, *past, [&tab](AxisId axis, Steps place) {
      return std::string(format_with_unit(place, tab.settings.unit(axis)).view());
    });
  const std::uint32_t doubtful = doubtful_axes(catalog, tab.now(), run);
  if (doubtful == 0) return {};
  const int axis = std::countr_zero(doubtful);
  return fmt::format(
      "The position of {} cannot be trusted: {}. Nothing was sent. Home it, or set its position, then run "
      "this again.",
      spoken_name(catalog, axis), words_of(tab.now().axes[ix(axis)].trust.cause));
}

std::string why_not_run_there(Tab& tab, const std::string& text) {
  Desk& desk = tab.desk();
  const WrittenSequence* source =
      desk.programs.source.of(text, desk.blocks, desk.programs.language(), tab.catalog());
  return source ? why_not_run_there(tab, *source->sequence) : std::string();
}

AgreedDoubts doubts_of(const Snapshot& now) {
  AgreedDoubts all;
  for (std::size_t a = 0; a < all.size(); ++a)
    if (now.axes[a].trust.doubtful()) all[a] = now.axes[a].trust;
  return all;
}

std::string why_not_begin_any_more(const Tab& tab, const sequence::Sequence& sequence,
                                   const AgreedDoubts& agreed) {
  const Catalog& catalog = tab.catalog();
  const intent::RunProgram run(0, places_of_run(sequence, catalog, tab.now()));
  if (past_travel(catalog, tab.now(), run))
    return fmt::format("{} It goes past a limit set meanwhile. Press Run to see which.", not_started);
  return why_doubted_meanwhile(tab, sequence, agreed);
}

std::string why_doubted_meanwhile(const Tab& tab, const sequence::Sequence& sequence,
                                  const AgreedDoubts& agreed) {
  const Catalog& catalog = tab.catalog();
  const intent::RunProgram run(0, places_of_run(sequence, catalog, tab.now()));
  const std::uint32_t doubtful = doubtful_axes(catalog, tab.now(), run);
  for (int axis = 0; axis < static_cast<int>(agreed.size()); ++axis) {
    const PositionTrust& trust = tab.now().axes[ix(axis)].trust;
    if ((doubtful >> axis & 1u) == 0 || trust == agreed[ix(axis)]) continue;
    return fmt::format(
        "{} Meanwhile the position of {} has become doubtful: {}. Press Run to see the choices.", not_started,
        spoken_name(catalog, axis), words_of(trust.cause));
  }
  return {};
}

std::optional<sequence::Sequence> read_sequence(Tab& tab, const std::string& text) {
  const Language* language = tab.desk().programs.language();
  if (!language) return std::nullopt;
  sequence::Sequence frame;
  for (const AxisInfo& axis : tab.catalog().axes) frame.axes.push_back({axis.name, 1});
  auto read = language->read(text, frame, tab.catalog());
  if (!read) return std::nullopt;
  return std::move(read->sequence);
}

std::string_view why_no_pieces(Tab& tab) {
  if (!tab.now().link.connected()) return no_link_to_run;
  if (tab.desk().programs.job.busy()) return program_in_transfer;
  const ProgramState& p = tab.now().program;
  if (p.owned && p.run != RunState::idle && p.run != RunState::error) return another_runs;
  return tab.why_not_move();
}

}  // namespace hw::gui
