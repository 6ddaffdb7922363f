#include "panels/doubt_remedies.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/core.h>

#include "core/device/homing.h"
#include "core/device/refusals.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/console.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float field_label = 80, field_width = 144, bar_label = 20, bar_field = 108;

/// Words in the units and the clock of the console.
DoubtWords words_shown(const Frame& f) {
  return {[&f](AxisId axis, Steps place) {
            return std::string(format_with_unit(place, f.tab.settings.unit(axis)).view());
          },
          [&f](Instant when) { return f.console.time_of_day(when); }};
}

std::uint32_t still_doubtful(const Snapshot& now, std::uint32_t axes) {
  for (std::size_t i = 0; i < now.axes.size(); ++i)
    if (!now.axes[i].trust.doubtful()) axes &= ~(1u << i);
  return axes;
}

}  // namespace

IntentId DoubtRemedies::send(Frame& f, IntentBody body) {
  close();
  sent_ = body;
  return f.send_and_watch(std::move(body));
}

bool DoubtRemedies::take_refusal(const Frame& f, const IntentOutcome& outcome) {
  if (outcome.doubtful != 0 && sent_)
    describe(f, outcome.doubtful);
  else if (open())
    words_ = outcome.sentence.view();  // a position to set was refused
  return open();
}

bool DoubtRemedies::take_refusal(const Frame& f, IntentBody sent, const IntentOutcome& outcome) {
  if (outcome.doubtful != 0) sent_ = std::move(sent);
  return take_refusal(f, outcome);
}

void DoubtRemedies::describe(const Frame& f, std::uint32_t doubtful) {
  doubtful_ = doubtful;
  axis_ = AxisId{static_cast<std::uint8_t>(std::countr_zero(doubtful))};
  words_ = describe_doubtful(f.catalog, f.now, *sent_, doubtful, words_shown(f));
  field_.reset();
  filled_.clear(), counted_.reset();
  offered_ = 0;
}

void DoubtRemedies::name_remedies(const Frame& f, std::string_view prefix) {
  const std::string& name = f.catalog.axes[axis_.index].name;
  const auto path = [&](std::string_view way) { return fmt::format("{}/{}/{}", prefix, name, way); };
  refused_id_ = path("refused");
  field_id_ = path("stands_at");
  const auto offer = [&](Remedy way, std::string_view id, std::string label, std::string brief) {
    offers_[offered_++] = {way, path(id), std::move(label), std::move(brief)};
  };
  offer(set, "set", "Set", "Set");
  const auto homes = [&](Sign sign) { return f.catalog.can.homes && homing_that_sets(f.catalog, -1, sign); };
  if (homes(Sign::minus)) offer(home_minus, "home/-", fmt::format("Home {} \u2212", name), "Home \u2212");
  if (homes(Sign::plus)) offer(home_plus, "home/+", fmt::format("Home {} +", name), "Home +");
  offer(once, "once", "Go on this once", "Go on once");
}

IntentId DoubtRemedies::draw(Frame& f, std::string_view prefix, std::string_view about, const Rect& row,
                             int mode) {
  const std::uint32_t left = still_doubtful(f.now, doubtful_);
  if (left == 0) return close(), IntentId{0};
  if (left != doubtful_) describe(f, left);
  if (offered_ == 0) name_remedies(f, prefix);
  std::array<Action, 4> actions;
  for (std::size_t i = 0; i < offered_; ++i)
    actions[i] = {.id = offers_[i].id,
                  .label = offers_[i].label,
                  .brief = offers_[i].brief,
                  .disabled = why_not(f, offers_[i].way),
                  .moving = offers_[i].way != set};
  Refusal refusal{.id = refused_id_, .about = about, .words = words_, .actions = {actions.data(), offered_}};
  refusal.slot_width = field_label + field_width;
  refusal.slot_in_bar = bar_label + bar_field;
  card_.begin(f, refusal, row);
  const bool entered = draw_field(f);
  const RefusalTouch touched = card_.end();
  if (touched.closed) close();
  if (entered && why_not(f, set).empty()) return go(f, set, mode);
  return touched.action < 0 ? 0 : go(f, offers_[static_cast<std::size_t>(touched.action)].way, mode);
}

/// Draws "It stands at [      mm]"; the field holds the count until the user types.
bool DoubtRemedies::draw_field(Frame& f) {
  const DisplayUnit& unit = f.tab.settings.unit(axis_);
  const Steps counts = f.now.axes[axis_.index].position;
  if (field_.text == filled_ && counts != counted_) {
    field_.set(from_steps(counts, unit), unit.real ? unit.decimals : 0);
    filled_ = field_.text;
    counted_ = counts;
  }
  const bool several = !std::has_single_bit(doubtful_), bar = card_.is_bar();
  const Path label("{} stands at", f.catalog.axes[axis_.index].name);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float begin = f.ui.px(bar ? bar_label : field_label);
  NumberOptions o;
  if (bar) o.height = 28;
  draw_text_line(f.ui, at.x, at.x + begin, at.y + f.ui.px(o.height / 2), Face::body, f.ui[Tone::ink],
                 bar       ? "at"
                 : several ? label.view()
                           : "It stands at");
  ImGui::SetCursorScreenPos(ImVec2(at.x + begin, at.y));
  o.range.decimals = unit.real ? unit.decimals : 0;
  o.range.unit = unit.name;
  o.width = bar ? bar_field : field_width;
  o.tip = "Position of the axis: as counted, or as you read it at the machine.";
  o.disabled = f.no_link();
  o.sentence_below = false;
  return number_field(f.ui, field_id_, "It stands at", std::nullopt, field_, o).entered;
}

std::optional<Steps> DoubtRemedies::place(const Frame& f) const {
  if (field_.text == filled_) return f.now.axes[axis_.index].position;
  const auto typed = parse_position(field_.text, f.tab.settings.unit(axis_));
  return typed ? std::optional(*typed) : std::nullopt;
}

std::string_view DoubtRemedies::why_not(const Frame& f, Remedy way) const {
  if (way != set) return f.tab.why_not_move(axis_);
  if (!f.connected()) return f.no_link();
  if (f.now.axis_moves(axis_.index)) return "It moves.";
  return place(f) ? "" : "Type its position first.";
}

IntentId DoubtRemedies::go(Frame& f, Remedy way, int mode) {
  if (way == set) return f.send_and_watch(stands_at(f.now, axis_, *place(f)));
  close();
  if (way == once) {
    go_despite_doubt(*sent_);
    return f.send_and_watch(*std::exchange(sent_, std::nullopt));
  }
  const Sign sign = way == home_plus ? Sign::plus : Sign::minus;
  const int homing =
      homing_that_sets(f.catalog, mode, sign).value_or(0);  // always present: homing was offered
  if (homing != mode && mode >= 0)
    f.toast(Severity::plain, fmt::format("Homing {}: the chosen mode does not set the count.",
                                         f.catalog.homing_modes[static_cast<std::size_t>(homing)].label));
  f.send(intent::Home(axis_, sign, homing));
  return 0;
}

}  // namespace hw::panels
