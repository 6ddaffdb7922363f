#include "core/emulation/bench_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/base/toml.h"

namespace hw {
namespace {

constexpr std::int64_t furthest = 1'000'000'000'000;
constexpr double latest_s = 1e7;

// One reading of one file. The first mistake ends it; the rest of the file is not looked at.
class Reader {
 public:
  Reader(const Catalog& catalog, std::string_view name) : catalog_(catalog), name_(name) {}

  Result<BenchFile> read(const toml::table& root) {
    for (auto&& [key, node] : root) {
      const std::string_view what = key.str();
      if (what == "quirks")
        quirks(node);
      else if (what == "axis")
        each(node, "axis", [&](auto name_of_axis, auto& n) { axis(name_of_axis, n); });
      else if (what == "input")
        each(node, "input", [&](auto number, auto& n) { input(number, n); });
      else if (what == "analog")
        each(node, "analog", [&](auto number, auto& n) { analog(number, n); });
      else if (what == "at")
        timed(node);
      else
        wrong(node, fmt::format("a bench has no \"{}\"", what),
              "Known here: quirks, [axis.NAME], [input], [analog], [[at]].");
    }
    if (fault_) return fail(*fault_);
    std::stable_sort(file_.later.begin(), file_.later.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    return std::move(file_);
  }

 private:
  void wrong(const toml::node& node, std::string_view what, std::string advice = {}) {
    if (fault_) return;
    const auto at = node.source().begin;
    fault_ = Fault(FaultKind::text, fmt::format("{}:{}:{}: {}.", name_, at.line, at.column, what),
                   "The file was not used.", std::move(advice));
  }

  template <class Each>
  void each(const toml::node& node, std::string_view what, Each&& take) {
    const auto* table = node.as_table();
    if (!table) return wrong(node, fmt::format("{} is not a table", what));
    for (auto&& [key, inner] : *table) take(key.str(), inner);
  }

  std::optional<std::int64_t> whole(const toml::node& node, std::string_view what,
                                    std::int64_t low = -furthest, std::int64_t high = furthest) {
    const auto value = node.value_exact<std::int64_t>();
    if (value && *value >= low && *value <= high) return value;
    wrong(node, fmt::format("{} must be a whole number from {} to {}", what, low, high));
    return {};
  }
  std::optional<double> number(const toml::node& node, std::string_view what, double low, double high) {
    const auto value = node.value<double>();
    if (value && node.is_number() && *value >= low && *value <= high) return value;
    wrong(node, fmt::format("{} must be a number from {} to {}", what, low, high));
    return {};
  }
  std::optional<bool> on_off(const toml::node& node, std::string_view what) {
    const auto value = node.value_exact<bool>();
    if (!value) wrong(node, fmt::format("{} must be true or false", what));
    return value;
  }
  std::optional<AxisId> axis_named(const toml::node& at, std::string_view axis_name) {
    const int index = catalog_.find_axis(axis_name);
    if (index >= 0) return AxisId{static_cast<std::uint8_t>(index)};
    std::string known;
    for (const AxisInfo& a : catalog_.axes) known += (known.empty() ? "" : ", ") + a.name;
    wrong(at, fmt::format("there is no axis \"{}\"", axis_name),
          fmt::format("This controller has: {}.", known));
    return {};
  }
  // Axes are written as text ("1") or, where the maker numbers them, as a number.
  std::optional<AxisId> axis_of(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return axis_named(node, *text);
    if (const auto digit = node.value_exact<std::int64_t>()) return axis_named(node, std::to_string(*digit));
    wrong(node, "the axis must be its name, for example \"1\"");
    return {};
  }
  std::optional<int> numbered(const toml::node& at, std::string_view key, std::string_view what,
                              std::size_t count, int first = 1) {
    int n = 0;
    for (const char c : key) n = c >= '0' && c <= '9' && n < 1000 ? n * 10 + (c - '0') : 10'000;
    const int last = first + static_cast<int>(count) - 1;
    if (!key.empty() && n >= first && n <= last) return n;
    wrong(at, fmt::format("there is no {} \"{}\"", what, key),
          count > 0 ? fmt::format("This controller has {} {} to {}.", what, first, last) : std::string());
    return {};
  }
  /// From the maker's number, which may begin at 0, to the bench's, from 1.
  std::optional<int> input_place(const toml::node& at, std::string_view key) {
    const int first = catalog_.inputs.empty() ? 1 : catalog_.input_number(0);
    const auto n = numbered(at, key, "input", catalog_.inputs.size(), first);
    return n ? std::optional(catalog_.find_input(*n) + 1) : std::nullopt;
  }

  void quirks(const toml::node& node) {
    const auto* list = node.as_array();
    if (!list) return wrong(node, "quirks must be a list of names");
    for (const auto& item : *list) {
      const auto quirk = item.value_exact<std::string>();
      if (!quirk) return wrong(item, "the name of a quirk must be in quotes");
      file_.quirks.push_back(*quirk);
    }
  }

  void axis(std::string_view axis_name, const toml::node& node) {
    const auto id = axis_named(node, axis_name);
    if (!id) return;
    AxisPlace place;
    each(node, "axis", [&](std::string_view key, const toml::node& n) { place_key(key, n, place); });
    if (const auto problem = problem_of(place); !problem.empty()) wrong(node, problem);
    file_.at_start.emplace_back(bench::Place(*id, place));
  }
  void place_key(std::string_view key, const toml::node& node, AxisPlace& place) {
    const auto steps = [&](std::optional<Steps>& into) {
      if (const auto value = whole(node, key)) into = Steps(*value);
    };
    if (key == "minus") return steps(place.minus);
    if (key == "plus") return steps(place.plus);
    if (key == "index_every") return steps(place.index_every);
    if (key == "backlash") return steps(place.backlash);
    if (key == "scatter") return steps(place.scatter);
    if (key == "seed") {
      place.seed = whole(node, key);
      return;
    }
    if (key == "counts_per_step") {
      place.counts_per_step = number(node, key, -1e6, 1e6);
      return;
    }
    if (key == "motor") return motor(node, place);
    if (key != "home")
      return wrong(
          node, fmt::format("an axis has no \"{}\"", key),
          "Known here: minus, plus, home, index_every, counts_per_step, backlash, scatter, seed, motor.");
    const auto* zone = node.as_array();
    if (!zone || zone->size() != 2) return wrong(node, "home must be [from, to]");
    const auto from = whole(*zone->get(0), "home"), to = whole(*zone->get(1), "home");
    if (from && to) place.home_from = Steps(*from), place.home_to = Steps(*to);
  }

  void motor(const toml::node& node, AxisPlace& place) {
    place.motor.emplace();
    if (!node.is_table()) {
      place.motor->present = on_off(node, "motor, unless it is a table,").value_or(false);
      return;
    }
    each(node, "motor", [&](std::string_view key, const toml::node& n) {
      const auto known = std::find_if(motor_keys.begin(), motor_keys.end(),
                                      [&](const MotorKey& k) { return k.name == key; });
      if (known == motor_keys.end())
        return wrong(
            n, fmt::format("a motor has no \"{}\"", key),
            "Known here: inertia, viscous, friction, torque_per_volt, torque_limit, counts_per_turn.");
      if (const auto value = number(n, key, known->low, known->high)) *place.motor.*known->value = *value;
    });
  }

  void input(std::string_view key, const toml::node& node) {
    const auto n = input_place(node, key);
    const auto on = on_off(node, "an input");
    if (n && on) file_.at_start.emplace_back(bench::Input(*n, *on));
  }
  void analog(std::string_view key, const toml::node& node) {
    const auto n = numbered(node, key, "analog input", catalog_.analog.size());
    if (!n) return;
    if (const auto value = analog_value(node, *n)) file_.at_start.emplace_back(bench::Analog(*n, *value));
  }
  std::optional<std::int32_t> analog_value(const toml::node& node, int n) {
    const AnalogInfo& info = catalog_.analog[static_cast<std::size_t>(n - 1)];
    const auto value = whole(node, info.name, info.minimum, info.maximum);
    return value ? std::optional(static_cast<std::int32_t>(*value)) : std::nullopt;
  }

  void timed(const toml::node& node) {
    const auto* list = node.as_array();
    if (!list) return wrong(node, "write [[at]] with double brackets");
    for (const auto& item : *list) {
      const auto* table = item.as_table();
      const toml::node* t = table ? table->get("t") : nullptr;
      if (!t) return wrong(item, "an [[at]] needs t, its time in seconds");
      const auto when = number(*t, "t", 0, latest_s);
      if (!when) return;
      for (auto&& [key, inner] : *table) {
        if (key.str() == "t") continue;
        if (auto command = timed_command(key.str(), inner))
          file_.later.push_back(TimedBenchCommand{from_seconds(*when), std::move(*command)});
      }
    }
  }

  // Arguments as a list; a lone value stands for a list of one.
  std::vector<const toml::node*> arguments(const toml::node& node) {
    std::vector<const toml::node*> all;
    if (const auto* list = node.as_array())
      for (const auto& item : *list) all.push_back(&item);
    else
      all.push_back(&node);
    return all;
  }
  std::optional<BenchCommand> timed_command(std::string_view verb, const toml::node& node) {
    const auto args = arguments(node);
    const auto takes = [&](std::size_t n, const char* form) {
      if (args.size() == n) return true;
      wrong(node, fmt::format("write {}", form));
      return false;
    };
    if (verb == "input") return takes(2, "input = [1, true]") ? timed_input(args) : std::nullopt;
    if (verb == "analog") return takes(2, "analog = [1, 300]") ? timed_analog(args) : std::nullopt;
    if (verb == "limit") return takes(3, "limit = [\"1\", \"+\", true]") ? timed_limit(args) : std::nullopt;
    if (verb == "button") return takes(2, "button = [\"Run\", true]") ? timed_button(args) : std::nullopt;
    if (verb == "home")
      return takes(2, "home = [\"1\", true]") ? on_axis<bench::HomeSwitch>(args, "home") : std::nullopt;
    if (verb == "jam")
      return takes(2, "jam = [\"1\", true]") ? on_axis<bench::Jam>(args, "jam") : std::nullopt;
    if (verb == "alarm")
      return takes(2, "alarm = [\"X\", true]") ? on_axis<bench::Alarm>(args, "alarm") : std::nullopt;
    if (verb == "slip") return takes(2, "slip = [\"1\", 40]") ? timed_slip(args) : std::nullopt;
    if (verb == "power_cycle") return BenchCommand(bench::PowerCycle{});
    wrong(node, fmt::format("a bench has no event \"{}\"", verb),
          "Known here: input, analog, limit, home, button, jam, alarm, slip, power_cycle.");
    return {};
  }
  using Arguments = std::vector<const toml::node*>;
  std::optional<BenchCommand> timed_input(const Arguments& args) {
    const auto number_text = args[0]->value<std::int64_t>();
    const auto n = input_place(*args[0], std::to_string(number_text.value_or(-1)));
    const auto on = on_off(*args[1], "an input");
    if (!n || !on) return {};
    return bench::Input(*n, *on);
  }
  std::optional<BenchCommand> timed_analog(const Arguments& args) {
    const auto number_text = args[0]->value<std::int64_t>();
    const auto n =
        numbered(*args[0], std::to_string(number_text.value_or(0)), "analog input", catalog_.analog.size());
    if (!n) return {};
    const auto value = analog_value(*args[1], *n);
    if (!value) return {};
    return bench::Analog(*n, *value);
  }
  std::optional<BenchCommand> timed_limit(const Arguments& args) {
    const auto id = axis_of(*args[0]);
    const auto sign = args[1]->value_exact<std::string>();
    const auto on = on_off(*args[2], "a limit switch");
    if (!id || !on) return {};
    if (sign == "+") return bench::Limit(*id, Sign::plus, *on);
    if (sign == "-") return bench::Limit(*id, Sign::minus, *on);
    wrong(*args[1], "the side of a limit switch is \"+\" or \"-\"");
    return {};
  }
  std::optional<BenchCommand> timed_button(const Arguments& args) {
    const auto button = args[0]->value_exact<std::string>();
    const auto pressed = on_off(*args[1], "a button");
    if (!button) wrong(*args[0], "the name of a button must be in quotes");
    if (!button || !pressed) return {};
    for (const BenchButton& b : catalog_.bench.buttons)
      if (b.name == *button) return bench::Button(*button, *pressed);
    wrong(*args[0], fmt::format("there is no button \"{}\"", *button));
    return {};
  }
  std::optional<BenchCommand> timed_slip(const Arguments& args) {
    const auto id = axis_of(*args[0]);
    const auto by = whole(*args[1], "slip");
    if (!id || !by) return {};
    return bench::Slip(*id, Steps(*by));
  }
  template <class Command>
  std::optional<BenchCommand> on_axis(const Arguments& args, std::string_view what) {
    const auto id = axis_of(*args[0]);
    const auto on = on_off(*args[1], what);
    if (!id || !on) return {};
    return Command(*id, *on);
  }

  const Catalog& catalog_;
  std::string_view name_;
  BenchFile file_;
  std::optional<Fault> fault_;
};

}  // namespace

std::string_view problem_of(const AxisPlace& place) {
  for (const auto& steps : {place.minus, place.plus, place.home_from, place.home_to, place.index_every,
                            place.backlash, place.scatter})
    if (steps && (steps->value > furthest || steps->value < -furthest)) return "a distance is too long";
  if (place.minus && place.plus && *place.minus >= *place.plus) return "minus must be below plus";
  if (place.home_from && place.home_to && *place.home_from > *place.home_to)
    return "home must be [from, to], the lower first";
  if (place.index_every && place.index_every->value <= 0) return "index_every must be above 0";
  if (place.backlash && place.backlash->value < 0) return "backlash must not be negative";
  if (place.scatter && place.scatter->value < 0) return "scatter must not be negative";
  if (place.counts_per_step && (!std::isfinite(*place.counts_per_step) || *place.counts_per_step == 0))
    return "counts_per_step must be a number other than 0";
  for (const MotorKey& key : motor_keys)
    if (place.motor && !(*place.motor.*key.value >= key.low && *place.motor.*key.value <= key.high))
      return "a value of the motor is out of its range";
  return {};
}

Result<BenchFile> parse_bench_file(std::string_view text, const Catalog& catalog, std::string_view name) {
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const auto at = parsed.error().source().begin;
    return fail(FaultKind::text,
                fmt::format("{}:{}:{}: {}.", name, at.line, at.column, parsed.error().description()),
                "The file was not used.", "A bench file is TOML: [axis.1], then lines like plus = 90000.");
  }
  return Reader(catalog, name).read(parsed.table());
}

}  // namespace hw
