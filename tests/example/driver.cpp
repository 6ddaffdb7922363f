// The console's side of a Twin.
#include "core/device/driver.h"

#include <charconv>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_tracking.h"
#include "core/device/nothing_known.h"
#include "core/device/param_check.h"
#include "tests/example/facts.h"
#include "tests/example/twin.h"

namespace hw::twin {
namespace {

/// The answer without its number and check sum; none: it is garbled.
std::optional<std::string> text_of(std::string_view line, std::string_view number) {
  const auto star = line.rfind('*');
  if (star == line.npos || line.substr(star + 1) != fmt::format("{:04X}\n", check_sum(line.substr(0, star))))
    return std::nullopt;
  return std::string(line.substr(number.size(), star - number.size()));
}

std::optional<std::vector<std::int64_t>> numbers(std::string_view text, std::size_t count) {
  std::vector<std::int64_t> all;
  for (const char *at = text.data(), *const end = at + text.size(); at < end; ++at) {
    const auto [stopped, wrong] = std::from_chars(at, end, all.emplace_back());
    if (wrong != std::errc()) return std::nullopt;
    if ((at = stopped) == end) break;
  }
  return all.size() == count ? std::optional(std::move(all)) : std::nullopt;
}

class TwinDriver final : public Driver {
 public:
  explicit TwinDriver(DriverContext context)
      : context_(std::move(context)), tracking_(context_.draft, context_.scheduler) {
    tracking_.may_lose_steps = [this](int axis) { return may_lose_steps(axis); };
  }

  void attach(Station& station) override {
    station_ = &station;
    station.unsolicited = [](std::string_view bytes) {  // an answer that came too late
      const auto end = bytes.find('\n');
      return end == bytes.npos ? bytes.npos : end + 1;
    };
  }
  void wire_lost() override {
    station_ = nullptr;
    tracking_.wire_lost();
    nothing_is_known(context_.draft);
  }
  Task<Result<>> connect() override {
    auto id = co_await ask("ID", Priority::intent, true);
    if (!id) co_return fail(id.error());
    if (*id != name)
      co_return fail(FaultKind::garbled,
                     fmt::format("What answers is no Twin: it calls itself \"{}\".", *id));
    context_.draft.identity.firmware = std::string_view(*id).substr(5);
    set_up_read_ = false;
    co_return co_await poll(Round::everything);
  }
  Task<Result<>> poll(Round) override {
    const Instant asked_at = context_.scheduler.now();
    auto text = co_await ask("?", Priority::poll, true);
    if (!text) co_return fail(text.error());
    const auto fields = numbers(*text, fields_of_status);
    if (!fields) co_return fail(FaultKind::garbled, "The status of the Twin makes no sense.");
    if (starts_ && *starts_ != fields->front()) restarted();
    starts_ = fields->front();
    for (int a = 0; a < axes; ++a) {
      const std::int64_t* f = fields->data() + 1 + a * fields_of_axis;
      tracking_.read(a,
                     {Steps(f[0]), f[1] != 0, Pps(static_cast<double>(f[2])), (f[3] & minus_bit) != 0,
                      (f[3] & plus_bit) != 0, f[4] == ended_by_home},
                     asked_at);
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
    const std::string& text = request.text;
    TextMeaning meaning;
    meaning.only_asks = text.find_first_of(" =") == text.npos;
    if (!text.starts_with("S ") && !text.starts_with("K ")) return meaning;
    meaning.axis = context_.catalog.find_axis(text.substr(2));
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
  static std::string no_axis(AxisId axis) { return fmt::format("There is no axis {}.", axis.index + 1); }
  static std::string stop_text(int axis, bool at_once) {
    return fmt::format("{} {}", at_once ? "K" : "S", axis < 0 ? '*' : axis_letters[ix(axis)]);
  }
  [[nodiscard]] std::optional<std::int64_t> known(int param) const {
    const ParamState& state = context_.draft.params[ix(param)];
    return state.known ? std::optional(state.value) : std::nullopt;
  }

  // ---- one line and its answer

  /// A stop begins with a line end, which ends whatever was cut short before it.
  Task<Result<std::string>> ask(std::string text, Priority priority, bool own = false,
                                Duration patience = Millis(200)) {
    if (!station_)
      co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
    const std::string number = fmt::format("{} ", ++lines_);
    Transaction t((priority == Priority::stop ? "\n" : "") + number + text + "\n", ReplyShape::line('\n'),
                  priority);
    t.patience = patience;
    t.own_question = own;
    t.unsolicited_length = [number](std::string_view received) -> std::size_t {
      if (received.starts_with(number)) return 0;
      const auto end = received.find('\n');
      return end == received.npos ? received.npos : end + 1;
    };
    auto line = co_await station_->transact(std::move(t));
    if (!line) co_return fail(line.error());
    auto answer = text_of(*line, number);
    if (!answer) co_return fail(FaultKind::garbled, "The answer was changed on its way.", "It was not used.");
    co_return std::move(*answer);
  }
  Task<Result<>> command(std::string text, Priority priority) {
    auto answer = co_await ask(text, priority);
    if (!answer) co_return fail(answer.error());
    if (*answer == "ok") co_return Result<>();
    co_return fail(FaultKind::controller,
                   fmt::format("The controller answered \"{}\" to {}.", *answer, text));
  }

  // ---- motion

  /// " 1000"; empty: the controller's own speed.
  static Result<std::string> speed_text(const intent::Pace& pace) {
    if (pace.acceleration)
      return fail(FaultKind::refused, "A Twin has one ramp for all motions.", "Nothing was sent.");
    const auto speed = static_cast<std::int64_t>(pace.speed.value);
    if (speed == 0) return std::string();
    if (speed >= 1 && speed <= top_speed) return fmt::format(" {}", speed);
    return fail(FaultKind::refused, fmt::format("{} is not a speed: it goes from 1 to {}.", speed, top_speed),
                "Nothing was sent.");
  }
  Task<Result<>> begin(int axis, std::string text, AxisTracking::Motion motion) {
    auto accepted = co_await command(std::move(text), Priority::intent);
    motion.ramp = static_cast<double>(known(ramp_param + axis).value_or(0));
    if (accepted) tracking_.begun(axis, motion);
    co_return accepted;
  }
  Task<Result<>> move(std::string verb, std::vector<AxisTarget> all, intent::Pace pace,
                      Activity activity = Activity::moving) {
    const auto speed = speed_text(pace);
    if (!speed) co_return fail(speed.error());
    for (AxisTarget& to : all) {
      if (to.axis.index >= axes) co_return co_await refused(no_axis(to.axis));
      const Steps target = verb == "D" ? context_.draft.axes[to.axis.index].position + to.value : to.value;
      if (std::abs(target.value) > position_max)
        co_return co_await refused(fmt::format("{} lies beyond ±{}.", target.value, position_max));
    }
    for (const AxisTarget& to : all) {
      const AxisState& axis = context_.draft.axes[to.axis.index];
      AxisTracking::Motion motion{activity, verb == "D" ? axis.position + to.value : to.value};
      std::string text = fmt::format("{} {} {}{}", verb, axis_letters[to.axis.index], to.value.value, *speed);
      auto begun = co_await begin(to.axis.index, std::move(text), motion);
      if (!begun) co_return begun;
    }
    co_return Result<>();
  }
  Task<Result<>> jog(intent::JogStart request) {
    if (request.axis.index >= axes) co_return co_await refused(no_axis(request.axis));
    if (request.up_to) {
      if (request.speed.value == 0)
        request.speed = Pps(static_cast<double>(known(jog_param + request.axis.index).value_or(0)));
      std::vector<AxisTarget> end(1, AxisTarget{request.axis, *request.up_to});
      co_return co_await move("G", std::move(end), pace_of(request), Activity::jogging);
    }
    const auto speed = speed_text(pace_of(request));
    if (!speed) co_return fail(speed.error());
    std::string text =
        fmt::format("J {} {}{}", axis_letters[request.axis.index], letter(request.sign), *speed);
    AxisTracking::Motion motion{Activity::jogging, {}, request.sign};
    co_return co_await begin(request.axis.index, std::move(text), motion);
  }
  Task<Result<>> home(intent::Home request) {
    if (request.pace.speed.value != 0 || request.pace.acceleration)
      co_return co_await refused("A Twin homes at its own speed.");
    std::string text = fmt::format("H {} {} {}", axis_letters[request.axis.index], letter(request.sign),
                                   request.mode == 0 ? 'L' : 'H');
    AxisTracking::Motion motion{Activity::homing, {}, request.sign};
    co_return co_await begin(request.axis.index, std::move(text), motion);
  }
  Task<Result<>> set_position(intent::SetPosition request) {
    for (int a = 0; a < axes; ++a) {
      if (request.axis >= 0 && request.axis != a) continue;
      auto set = co_await command(fmt::format("P {} {}", axis_letters[ix(a)], request.value.value),
                                  Priority::intent);
      if (!set) co_return set;
      context_.draft.axes[ix(a)].trust.settle(Trust::set, context_.scheduler.now());
    }
    co_return co_await poll(Round::usual);
  }
  /// A motor that runs faster than it can start overshoots when it is stopped at once.
  bool may_lose_steps(int a) {
    if (context_.draft.axes[ix(a)].speed.value <= start_speed) return false;
    warn(fmt::format(
        "Axis {} was stopped at speed without a ramp and may have lost steps. Home it, or set its position.",
        axis_letters[ix(a)]));
    return true;
  }
  void restarted() {
    ++context_.draft.restarts;
    set_up_is_unknown(context_.draft);
    set_up_read_ = false;
    tracking_.restarted();
    warn("The controller was switched off and on. Home the axes before the next move to a place.");
  }
  void warn(std::string sentence) {
    context_.notify(Notice(Notice::Kind::warning, context_.scheduler.now(), std::move(sentence)));
  }

  // ---- set-up and the user's own text

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
      const auto value = numbers(*text, 1);
      if (!value)
        co_return fail(FaultKind::garbled, fmt::format("{} of the Twin is no number.", params[i].mnemonic));
      context_.draft.params[i] = {value->front(), true, true};
      if (params[i].mnemonic[0] == 'F')
        context_.draft.axes[ix(params[i].axis)].own_speed = Pps(static_cast<double>(value->front()));
    }
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
