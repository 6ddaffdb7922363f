#include "core/devices/arcus/move_stream.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/device/act_writer.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are also command names

constexpr int buffer_axes = 3;

class Streamer final : public ActWriter {
 public:
  using ActWriter::ActWriter;

  Result<std::optional<Pieces>> run() {
    pieces_.tool = tool_off_of(draft_.sequence, static_cast<int>(draft_.catalog.outputs.size()));
    pieces_.remark =
        "The drawing goes through the controller's buffer. Lines too short to send the next line in time are "
        "drawn more slowly.";
    for (std::uint8_t axis = 0; axis < buffer_axes; ++axis)
      pieces_.open_loops.push_back({AxisId{axis}, "SL" + draft_.catalog.axes[axis].name});
    set("IACC", 1);  // ramps between its moves
    auto written = write_all();
    if (unfit_) return std::optional<Pieces>();
    if (!written) return fail(written.error());
    if (pieces_.all.empty()) return std::optional<Pieces>();
    pieces_.all.back().does.push_back({intent::SendText("BF")});
    return std::optional(std::move(pieces_));
  }

 private:
  using Row = std::vector<std::int64_t>;
  static constexpr std::int64_t as_it_is = intent::FeedMoves::as_it_is;

  Result<> unfit() override {
    unfit_ = true;
    return fail(FaultKind::refused, "The buffer cannot do it.");
  }
  [[nodiscard]] bool can_move(int place) const override { return draft_.axis(place).index < buffer_axes; }

  Result<> speeds(const seq::Speeds& sent) override {
    auto steps = draft_.speeds(0, sent);
    if (!steps) return fail(steps.error());
    if (steps->low != 0) set("LS", steps->low);
    if (steps->ramp_ms != 0) set("ACC", std::max<std::int64_t>(std::llround(steps->ramp_ms), 1));
    return {};
  }
  /// Moves the axes of the buffer; an axis without a target stays where it is.
  Result<> go(const seq::OwnSpeeds& own) override {
    const auto speeds = draft_.speeds_of(0, own);
    if (!speeds) return fail(speeds.error());
    if (!emits()) return {};
    Row row(buffer_axes + 1, as_it_is);
    for (const AxisTarget& at : stands())
      if (at.axis.index < buffer_axes) row[ix(at.axis.index)] = at.value.value;
    if (speeds->high != 0) row.back() = speeds->high;
    if (!rows_.empty() && std::equal(row.begin(), row.end() - 1, rows_.back().begin())) return {};
    rows_.push_back(std::move(row));
    steps_.push_back(place());
    return {};
  }
  Result<> pause(Duration time) override {
    if (piece_.does.empty()) return unfit();
    piece_.does.back().then += time;
    return {};
  }
  void flush() override {
    if (rows_.empty()) return;
    if (cuts()) {
      piece_.draws = static_cast<int>(piece_.does.size());
      piece_.step_of_row = steps_;
    }
    if (piece_.does.empty()) piece_.first_step = steps_.front();
    piece_.does.push_back({intent::FeedMoves(std::exchange(rows_, {}))});
    steps_.clear();
  }
  void act(IntentBody what) override {
    if (piece_.does.empty()) piece_.first_step = place();
    piece_.does.push_back({std::move(what)});
  }
  void set(const std::string& parameter, std::int64_t value) {
    flush();
    piece_.does.push_back({intent::SetParam(parameter, value, true)});  // also for pieces that begin later
  }
  void end_piece() override {
    if (piece_.does.empty()) return;
    piece_.ends_at = stands();
    pieces_.all.push_back(std::exchange(piece_, {}));
  }

  Pieces pieces_;
  Piece piece_;
  std::vector<Row> rows_;
  std::vector<int> steps_;  ///< of `rows_`
  bool unfit_ = false;
};

}  // namespace

Result<std::optional<Pieces>> stream_moves(const seq::Sequence& sequence, const Catalog& catalog,
                                           int from_step) {
  return Streamer(sequence, catalog, last_tool_up(sequence.steps, ix(from_step))).run();
}

}  // namespace hw::arcus
