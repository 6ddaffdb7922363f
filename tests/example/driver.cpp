// The console's side of a Twin.
#include "core/device/driver.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/base/split.h"
#include "core/device/axis_tracking.h"
#include "core/device/param_check.h"
#include "core/device/target_check.h"
#include "tests/example/facts.h"
#include "tests/example/twin.h"

namespace hw::twin {
namespace {

/// Of the line at the front; npos: it is not whole yet.
std::size_t line_length(std::string_view bytes) {
  const auto end = bytes.find('\n');
  return end == bytes.npos ? end : end + 1;
}

class TwinDriver final : public Driver {
 public:
  explicit TwinDriver(DriverContext context)
      : context_(std::move(context)), tracking_(context_, Pps(start_speed)) {}

  void attach(Station& station) override {
    station_ = &station;
    station.unsolicited = line_length;  // an answer that came too late
  }
  void wire_lost() override { station_ = nullptr, tracking_.wire_lost(); }
  Task<Result<>> connect() override {
    auto id = co_await ask("ID", Priority::intent, true);
    if (!id) co_return fail(id.error());
    if (*id != name)
      co_return fail(FaultKind::garbled, fmt::format("This is not a Twin. It answered \"{}\".", *id));
    context_.snapshot.identity.firmware = std::string_view(*id).substr(5);
    set_up_read_ = false;
    co_return co_await poll(Round::everything);
  }
  Task<Result<>> poll(Round) override {
    const Instant asked_at = context_.scheduler.now();
    auto text = co_await ask("?", Priority::poll, true);
    if (!text) co_return fail(text.error());
    std::vector<std::int64_t> fields;
    for (const std::string_view part : split(*text, ' '))
      if (const auto field = whole_number<std::int64_t>(part)) fields.push_back(*field);
    if (fields.size() != fields_of_status) co_return fail(FaultKind::garbled, "Its status makes no sense.");
    if (starts_ && *starts_ != fields.front()) tracking_.restarted(), set_up_read_ = false;
    starts_ = fields.front();
    for (int a = 0; a < axes; ++a) {
      const std::int64_t* f = fields.data() + 1 + a * fields_of_axis;
      const bool minus = (f[3] & minus_bit) != 0, plus = (f[3] & plus_bit) != 0;
      const Pps speed(static_cast<double>(f[2]));
      tracking_.read(a, {Steps(f[0]), f[1] != 0, speed, minus, plus, f[4] == ended_by_home}, asked_at);
    }
    if (std::exchange(set_up_read_, true)) co_return Result<>();
    auto read = co_await read_params({}, Priority::poll);
    set_up_read_ = read.has_value();
    co_return read;
  }
  Task<Result<>> perform(const IntentBody& body) override {
    if (const auto* i = std::get_if<intent::MoveTo>(&body)) return move("G", i->targets, pace_of(*i));
    if (const auto* i = std::get_if<intent::MoveBy>(&body)) return move("D", i->distances, pace_of(*i));
    if (const auto* i = std::get_if<intent::JogStart>(&body)) return jog(*i);
    if (const auto* i = std::get_if<intent::Home>(&body)) return home(*i);
    if (const auto* i = std::get_if<intent::SetPosition>(&body)) return set_position(*i);
    if (const auto* i = std::get_if<intent::SetParam>(&body)) return set_param(*i);
    if (const auto* i = std::get_if<intent::ReadParams>(&body)) return read_params(i->only, Priority::intent);
    if (const auto* i = std::get_if<intent::SendText>(&body)) return send_text(i->text);
    if (std::holds_alternative<intent::ReadAgain>(body)) return connect();
    return refused("A Twin cannot do that.");
  }
  Task<Result<std::string>> stop(const StopOrder& order) override {
    using What = StopOrder::What;
    if (order.what == What::words) co_return co_await ask(order.words, Priority::stop);
    if (order.what != What::everything && order.what != What::jog) co_return std::string();
    tracking_.stopping(order.axis, order.at_once);
    auto stopped = co_await command(stop_text(order.axis, order.at_once), Priority::stop);
    if (!stopped) co_return fail(stopped.error());
    co_return std::string();
  }
  StopProgress stop_progress(const StopOrder& order) override { return tracking_.progress(order); }
  [[nodiscard]] LastWill last_will(unsigned) const override {
    return {{Millis(0), fmt::format("\n0 {}\n", stop_text(-1, false))}};
  }
  Task<Result<std::string>> query(std::string text, Duration patience) override {
    co_return co_await ask(std::move(text), Priority::intent, false, patience);
  }
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& request) const override {
    TextMeaning meaning;
    meaning.only_asks = request.text.find_first_of(" =") == std::string::npos;
    if (!request.text.starts_with("S ") && !request.text.starts_with("K ")) return meaning;
    meaning.axis = context_.catalog.find_axis(request.text.substr(2));
    meaning.stops = meaning.axis < 0 ? TextMeaning::Stops::all : TextMeaning::Stops::some;
    if (meaning.axis >= 0) meaning.axes = 1u << meaning.axis;
    return meaning;
  }
  [[nodiscard]] Duration moving_period() const override { return Millis(50); }
  [[nodiscard]] Duration idle_period() const override { return Millis(200); }

 private:
  static Task<Result<>> refused(std::string why) {
    co_return fail(FaultKind::refused, std::move(why), "Nothing was sent.");
  }
  static std::string stop_text(int axis, bool at_once) {
    return fmt::format("{} {}", at_once ? "K" : "S", axis < 0 ? '*' : axis_letters[ix(axis)]);
  }
  [[nodiscard]] Pps known(int param) const {  // 0: not known
    const ParamState& state = context_.snapshot.params[ix(param)];
    return Pps(state.known ? static_cast<double>(state.value) : 0);
  }
  /// A stop begins with a line end, which ends whatever was cut short before it.
  Task<Result<std::string>> ask(std::string text, Priority priority, bool own = false,
                                Duration patience = Millis(200)) {
    if (!station_)
      co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
    const std::string number = fmt::format("{} ", ++lines_);
    Transaction t((priority == Priority::stop ? "\n" : "") + number + text + "\n", ReplyShape::line('\n'),
                  priority);
    t.patience = patience, t.own_question = own;
    t.unsolicited_length = [number](std::string_view received) {
      return received.starts_with(number) ? 0 : line_length(received);
    };
    auto line = co_await station_->transact(std::move(t));
    if (!line) co_return fail(line.error());
    const std::string_view all = *line;
    const auto star = std::min(all.rfind('*'), all.size());
    if (all.substr(star) != fmt::format("*{:04X}\n", check_sum(all.substr(0, star))))
      co_return fail(FaultKind::garbled, "The answer was changed on its way.", "It was not used.");
    co_return std::string(all.substr(number.size(), star - number.size()));
  }
  Task<Result<>> command(std::string text, Priority priority) {
    auto answer = co_await ask(text, priority);
    if (!answer) co_return fail(answer.error());
    if (*answer == "ok") co_return Result<>();
    co_return fail(FaultKind::controller, fmt::format("It answered \"{}\" to {}.", *answer, text));
  }
  Task<Result<>> begin(std::string text, int axis, AxisTracking::Motion motion, intent::Pace requested) {
    const auto pace = check_pace(context_.catalog, {}, requested);
    if (!pace) co_return fail(pace.error());
    if (pace->speed != 0) text += fmt::format(" {}", pace->speed);
    motion.ramp = known(ramp_param + axis).value;
    auto accepted = co_await command(std::move(text), Priority::intent);
    if (accepted) tracking_.begun(axis, motion);
    co_return accepted;
  }
  Task<Result<>> move(std::string verb, std::vector<AxisTarget> all, intent::Pace pace,
                      Activity activity = Activity::moving) {
    const auto base = verb == "D" ? MoveBase::position : MoveBase::zero;
    const auto targets = check_move(context_.catalog, context_.snapshot, all, base);
    if (!targets) co_return fail(targets.error());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const int axis = all[i].axis.index;
      std::string text = fmt::format("{} {} {}", verb, axis_letters[ix(axis)], all[i].value.value);
      auto begun = co_await begin(std::move(text), axis, {activity, (*targets)[i]}, pace);
      if (!begun) co_return begun;
    }
    co_return Result<>();
  }
  Task<Result<>> jog(intent::JogStart request) {
    std::vector<AxisTarget> end(1, {request.axis, request.up_to.value_or(Steps(0))});
    if (request.up_to) co_return co_await move("G", std::move(end), pace_of(request), Activity::jogging);
    const auto possible = check_move(context_.catalog, context_.snapshot, end, MoveBase::zero);
    if (!possible) co_return fail(possible.error());
    std::string text = fmt::format("J {} {}", axis_letters[request.axis.index], letter(request.sign));
    const AxisTracking::Motion motion{Activity::jogging, {}, request.sign};
    co_return co_await begin(std::move(text), request.axis.index, motion, pace_of(request));
  }
  Task<Result<>> home(intent::Home request) {
    if (request.pace.speed.value != 0 || request.pace.acceleration)
      co_return co_await refused("A Twin homes at its own speed.");
    const char way = request.mode == 0 ? 'L' : 'H';
    std::string text = fmt::format("H {} {} {}", axis_letters[request.axis.index], letter(request.sign), way);
    const AxisTracking::Motion motion{Activity::homing, {}, request.sign};
    co_return co_await begin(std::move(text), request.axis.index, motion, {});
  }
  Task<Result<>> set_position(intent::SetPosition request) {
    for (int a = 0; a < axes; ++a) {
      if (request.axis >= 0 && request.axis != a) continue;
      std::string text = fmt::format("P {} {}", axis_letters[ix(a)], request.value.value);
      auto set = co_await command(std::move(text), Priority::intent);
      if (!set) co_return set;
      tracking_.was_set(a);
    }
    co_return co_await poll(Round::usual);
  }

  Task<Result<>> set_param(intent::SetParam request) {
    const auto place = check_param(context_.catalog, request, {"A Twin"});
    if (!place) co_return fail(place.error());
    auto set = co_await command(fmt::format("{}={}", request.mnemonic, request.value), Priority::intent);
    if (!set) co_return set;
    co_return co_await read_params(request.mnemonic, Priority::intent);
  }
  Task<Result<>> read_params(std::string only, Priority priority) {
    for (std::size_t i = 0; i < params.size(); ++i) {
      if (!only.empty() && only != params[i].mnemonic) continue;
      auto text = co_await ask(std::string(params[i].mnemonic), priority, true);
      if (!text) co_return fail(text.error());
      const auto value = whole_number<std::int64_t>(*text);
      if (!value) co_return fail(FaultKind::garbled, "A parameter of the Twin is no number.");
      context_.snapshot.params[i] = {*value, true, true};
    }
    for (int a = 0; a < axes; ++a) context_.snapshot.axes[ix(a)].own_speed = known(speed_param + a);
    co_return Result<>();
  }
  Task<Result<>> send_text(std::string text) {
    auto answer = co_await ask(text, Priority::intent);
    if (!answer) co_return fail(answer.error());
    context_.texts.add(*answer);
    if (text.find('=') != text.npos) co_return co_await read_params({}, Priority::intent);
    co_return Result<>();
  }

  DriverContext context_;
  AxisTracking tracking_;
  Station* station_ = nullptr;
  std::uint64_t lines_ = 0;
  std::optional<std::int64_t> starts_;
  bool set_up_read_ = false;
};

}  // namespace

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<TwinDriver>(std::move(context));
}

}  // namespace hw::twin
