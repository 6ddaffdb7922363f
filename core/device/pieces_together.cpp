#include "core/device/pieces_together.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/device/act_writer.h"
#include "core/motion/profile.h"

namespace hw {

namespace seq = sequence;  // its names are those of commands too

namespace {

constexpr AxisId own_axis{0};
constexpr std::string_view low_speed_param = "LSPD", ramp_param = "ACC";

class TogetherWriter final : public ActWriter {
 public:
  using ActWriter::ActWriter;

  Result<std::vector<Pieces>> run() {
    const auto members = ix(draft_.axis_count());
    parts_.resize(members), open_.resize(members), stood_.resize(members);
    if (auto written = write_all(); !written) return fail(written.error());
    if (parts_.front().all.empty())
      return fail(FaultKind::text, "The sequence has no step that can be carried out.",
                  "Nothing was written.");
    // The output that switches the tool belongs to the first controller.
    parts_.front().tool = tool_off_of(draft_.sequence, static_cast<int>(draft_.catalog.outputs.size()));
    for (Pieces& part : parts_)
      part.remark =
          "Each controller moves on its own and stops at each corner. Their starts differ by the time of one "
          "command on the wire, so lines are not quite straight.";
    return std::move(parts_);
  }

 private:
  Result<> unfit() override {
    return draft_.refuse(
        "together, controllers on a bus can do only moves, arcs as chords, outputs and delays.");
  }
  [[nodiscard]] bool can_move(int) const override { return true; }

  Result<> speeds(const seq::Speeds& given) override {
    for (int a = 0; a < draft_.axis_count(); ++a) {
      auto steps = draft_.speeds(a, given);
      if (!steps) return fail(steps.error());
      if (steps->low != 0) set(a, low_speed_param, steps->low);
      if (steps->ramp_ms != 0) set(a, ramp_param, std::max<std::int64_t>(std::llround(steps->ramp_ms), 1));
    }
    return {};
  }
  /// Chooses the speed of each axis so that all arrive together.
  Result<> go(const seq::OwnSpeeds& own) override {
    std::vector<std::optional<IntentBody>> acts(parts_.size());
    const double length = length_of_way();
    bool any = false;
    for (int a = 0; a < draft_.axis_count(); ++a) {
      const auto to = draft_.at(a), from = stood_[ix(a)];
      const auto speeds = draft_.speeds_of(a, own);
      if (!speeds) return fail(speeds.error());
      if (!emits() || !to || to == from) continue;
      stood_[ix(a)] = to;
      const double share = length > 0 && from ? std::fabs(in_units(a, *to - *from)) / length : 1;
      double pps = static_cast<double>(speeds->high) * share;
      if (pps > 0) pps = std::max(pps, draft_.catalog.jog_speed_min.value);
      acts[ix(a)] = intent::MoveTo({{own_axis, Steps(*to)}}, Pps(std::round(pps)));
      any = true;
    }
    if (any) add(std::move(acts));
    return {};
  }
  void act(IntentBody what) override { add_one(0, std::move(what)); }
  Result<> pause(Duration time) override {
    add(std::vector<std::optional<IntentBody>>(parts_.size()));  // after the acts of all of them
    open_.front().does.back().then = time;
    return {};
  }
  void set(int member, std::string_view parameter, std::int64_t value) {
    if (draft_.catalog.find_param(parameter) >= 0)
      add_one(member, intent::SetParam(std::string(parameter), value, true));
  }
  void end_piece() override {
    if (open_.front().does.empty()) return;
    for (int a = 0; a < draft_.axis_count(); ++a) {
      Piece& piece = open_[ix(a)];
      if (const auto at = draft_.at(a)) piece.ends_at.push_back({own_axis, Steps(*at)});
      parts_[ix(a)].all.push_back(std::exchange(piece, {}));
    }
  }

  void add(std::vector<std::optional<IntentBody>> acts) {
    for (std::size_t m = 0; m < acts.size(); ++m) {
      if (open_[m].does.empty()) open_[m].first_step = place();
      open_[m].does.push_back({std::move(acts[m])});
      open_[m].step_of_act.push_back(place());
    }
  }
  void add_one(int member, IntentBody what) {
    std::vector<std::optional<IntentBody>> acts(parts_.size());
    acts[ix(member)] = std::move(what);
    add(std::move(acts));
  }
  [[nodiscard]] double in_units(int axis, std::int64_t steps) const {
    return static_cast<double>(steps) / draft_.sequence.axes[ix(axis)].per_unit;
  }
  /// 0: not known.
  [[nodiscard]] double length_of_way() const {
    double squares = 0;
    for (int a = 0; a < draft_.axis_count(); ++a) {
      const auto to = draft_.at(a), from = stood_[ix(a)];
      if (to.has_value() != from.has_value()) return 0;
      if (to) squares += std::pow(in_units(a, *to - *from), 2);
    }
    return std::sqrt(squares);
  }

  std::vector<Pieces> parts_;                       ///< of each member
  std::vector<Piece> open_;                         ///< the piece of each that is being written
  std::vector<std::optional<std::int64_t>> stood_;  ///< place of each axis after the acts so far
};

/// One member, while its acts are timed.
class Timed {
 public:
  explicit Timed(const Catalog& catalog)
      : low_(fallback(catalog, low_speed_param)), ramp_ms_(fallback(catalog, ramp_param)) {}
  /// None: not known.
  std::optional<double> seconds(const IntentBody& what) {
    if (const auto* set = std::get_if<intent::SetParam>(&what)) {
      if (set->mnemonic == low_speed_param) low_ = set->value;
      if (set->mnemonic == ramp_param) ramp_ms_ = set->value;
    }
    const auto* move = std::get_if<intent::MoveTo>(&what);
    if (!move) return 0;
    const std::int64_t to = move->targets.front().value.value;
    const auto from = std::exchange(at_, to);
    if (!(move->speed.value > 0)) return std::nullopt;
    if (!from || *from == to) return 0;
    const double low = std::min(static_cast<double>(low_), move->speed.value);
    const double accel =
        std::max(1.0, move->speed.value - low) / std::max(0.001, static_cast<double>(ramp_ms_) / 1000);
    const motion::Ramp ramp(accel, accel, Pps(low));
    const auto way = motion::Profile::index(Instant(), std::abs(to - *from), move->speed, ramp);
    return hw::seconds(way.end() - way.start());
  }

 private:
  static std::int64_t fallback(const Catalog& catalog, std::string_view param) {
    const int place = catalog.find_param(param);
    return place < 0 ? 0 : catalog.params[ix(place)].fallback;
  }
  std::int64_t low_, ramp_ms_;
  std::optional<std::int64_t> at_;
};

}  // namespace

std::vector<double> least_seconds(const std::vector<Pieces>& parts, const Catalog& bus) {
  std::vector<Timed> members(parts.size(), Timed(bus));
  std::vector<double> all;
  for (std::size_t p = 0; p < parts.front().all.size(); ++p) {
    all.push_back(0);
    for (std::size_t i = 0; i < parts.front().all[p].does.size(); ++i) {
      double longest = 0;
      for (std::size_t m = 0; m < parts.size(); ++m) {
        const PieceAct& act = parts[m].all[p].does[i];
        const auto takes = act.what ? members[m].seconds(*act.what) : 0;
        if (!takes) return {};
        longest = std::max(longest, *takes + seconds(act.then));
      }
      all.back() += longest;
    }
  }
  return all;
}

std::optional<Catalog> catalog_together(std::span<const Catalog* const> members) {
  const bool fit = members.size() >= 2 && std::all_of(members.begin(), members.end(), [](const Catalog* c) {
                     return c->axes.size() == 1 && c->addressed();
                   });
  if (!fit) return std::nullopt;
  Catalog bus = *members.front();
  bus.axes.clear();
  for (const Catalog* member : members) {
    bus.axes.push_back(member->axes.front());
    bus.axes.back().name = member->id();
  }
  bus.can.interpolates = true;  // by speeds that let all reach the end of a line together
  return bus;
}

Result<std::vector<Pieces>> pieces_together(const seq::Sequence& sequence, const Catalog& bus,
                                            int from_step) {
  if (auto has = has_step(sequence, from_step); !has) return fail(has.error());
  if (sequence.axes.size() < 2)
    return fail(FaultKind::text, "All axes of the sequence are on one controller: run it on that controller.",
                "Nothing was written.");
  return TogetherWriter(sequence, bus, last_tool_up(sequence.steps, ix(from_step))).run();
}

}  // namespace hw
