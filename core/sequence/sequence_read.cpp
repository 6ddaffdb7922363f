#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/base/toml.h"
#include "core/sequence/fields.h"
#include "core/sequence/sequence_file.h"

namespace hw::sequence {
namespace {

constexpr std::string_view version_key = "handwheel_sequence";
constexpr std::int64_t version = 1;
constexpr std::int64_t last_line = 64;  // highest number of an input or output

/// The file being read, and its first fault.
struct File {
  const std::string& name;
  const std::vector<Axis>& axes;
  std::optional<Fault> fault;

  void wrong(const toml::node& node, std::string_view what) {
    if (!fault)
      fault = Fault(FaultKind::text, fmt::format("{}, line {}: {}.", name, node.source().begin.line, what),
                    "Nothing was loaded from the file.", "Correct that line, or choose another file.");
  }
};

std::optional<double> number_in(const toml::node& node) {
  const auto value = node.value<double>();
  return value && std::isfinite(*value) && !node.is_boolean() ? value : std::nullopt;
}

StepList read_steps(const toml::node& node, File& file, int depth);

/// The fields of one step.
class FieldReader {
 public:
  FieldReader(const toml::table& table, File& file, int depth) : table_(table), file_(file), depth_(depth) {}

  void number(std::string_view key, double& value) { (void)take_number(key, value); }
  void needed(std::string_view key, double& value) {
    if (!take_number(key, value)) missing(key);
  }
  void positive(std::string_view key, double& value) {
    number(key, value);
    if (value < 0) file_.wrong(table_, fmt::format("{} must not be negative", key));
  }
  void flag(std::string_view key, bool& value) {
    const toml::node* node = find(key);
    if (!node) return;
    if (const auto read = node->value_exact<bool>())
      value = *read;
    else
      file_.wrong(*node, fmt::format("{} must be true or false", key));
  }
  void text(std::string_view key, std::string& value) {
    const toml::node* node = find(key);
    if (!node) return;
    if (auto read = node->value_exact<std::string>())
      value = std::move(*read);
    else
      file_.wrong(*node, fmt::format("{} must be a text in quotation marks", key));
  }
  void count(std::string_view key, int& value) { whole(key, value, 0, 1'000'000); }
  void line(std::string_view key, int& value) {
    whole(key, value, 0, last_line);
    if (!has_read_) missing(key);
  }
  void line_or_all(std::string_view key, int& value) {
    value = -1;
    whole(key, value, 0, last_line);
    if (!has_read_ && !table_.contains("value")) missing("output, or the value of all");
  }
  void word(std::string_view key, std::uint32_t& value) { whole(key, value, 0, 0xFFFF'FFFF); }
  void axis(std::string_view key, int& value) {
    value = -1;
    axis_or_all(key, value);
    if (value < 0) missing(key);
  }
  void axis_or_all(std::string_view key, int& value) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto name = node->value_exact<std::string>();
    value = name ? place_of(*name) : -1;
    if (value < 0) file_.wrong(*node, fmt::format("{} must be one of the axes of the file", key));
  }
  void sign(std::string_view key, Sign& value) {
    constexpr std::array<std::string_view, 2> signs{"-", "+"};
    bool plus = value == Sign::plus;
    choice(key, plus, signs);
    value = plus ? Sign::plus : Sign::minus;
  }
  template <class Choice>
  void choice(std::string_view key, Choice& value, std::span<const std::string_view> names) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto word = node->value_exact<std::string_view>();
    const auto found = std::find(names.begin(), names.end(), word.value_or(""));
    if (found == names.end()) return file_.wrong(*node, fmt::format("{} has no such value", key));
    value = static_cast<Choice>(found - names.begin());
  }
  void places(std::string_view key, Places& value) {
    const toml::node* node = find(key);
    if (!node || !node->is_table()) return missing(fmt::format("{} = {{ axis = number }}", key));
    for (const auto& [name, place] : *node->as_table()) {
      const int axis = place_of(name.str());
      const auto read = number_in(place);
      if (axis < 0 || !read)
        return file_.wrong(place, fmt::format("{} is not an axis with a number", name.str()));
      value[ix(axis)] = read;
    }
    if (node->as_table()->empty()) file_.wrong(*node, "it moves no axis");
  }
  void plane(std::string_view key, Plane& value) {
    const toml::node* node = find(key);
    if (!node) return;
    std::array<int, 2> places{-1, -1};
    const toml::array* names = node->as_array();
    if (names && names->size() == places.size())
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto name = (*names)[i].value_exact<std::string>();
        if (name && (places[i] = place_of(*name)) < 0)
          return file_.wrong(*node, fmt::format("there is no axis \"{}\" in the file", *name));
      }
    if (places[0] < 0 || places[1] < 0 || places[0] == places[1])
      return file_.wrong(*node, fmt::format("{} must be two different axes, such as [\"X\", \"Z\"]", key));
    value = {places[0], places[1]};
  }
  void stairs(std::string_view key, std::vector<SpeedStairs::Stair>& value) {
    const toml::node* node = find(key);
    if (!node || !node->is_array()) return missing(fmt::format("{} in [ ]", key));
    for (const toml::node& each : *node->as_array()) {
      const toml::table* table = each.as_table();
      if (!table) return file_.wrong(each, "a stair must be in { }");
      FieldReader reader(*table, file_, depth_);
      fields(reader, value.emplace_back());
      reader.end();
    }
  }
  void own(OwnSpeeds& value) {
    Speeds speeds;
    const std::size_t before = used_.size();
    fields(*this, speeds);
    if (used_.size() != before) value = speeds;
  }
  void steps(std::string_view key, StepList& value) {
    const toml::node* node = find(key);
    if (!node) return missing(key);
    value = read_steps(*node, file_, depth_ + 1);
  }

  /// Reports fields that were not read.
  void end() {
    for (const auto& [key, node] : table_)
      if (std::find(used_.begin(), used_.end(), key.str()) == used_.end())
        file_.wrong(node, fmt::format("{} is not known", key.str()));
  }
  const toml::node* find(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (node) used_.push_back(key);
    return node;
  }

 private:
  void missing(std::string_view what) { file_.wrong(table_, fmt::format("it needs {}", what)); }
  bool take_number(std::string_view key, double& value) {
    const toml::node* node = find(key);
    if (!node) return false;
    if (const auto read = number_in(*node))
      value = *read;
    else
      file_.wrong(*node, fmt::format("{} must be a number", key));
    return true;
  }
  template <class Whole>
  void whole(std::string_view key, Whole& value, std::int64_t low, std::int64_t high) {
    const toml::node* node = find(key);
    has_read_ = node != nullptr;
    if (!node) return;
    const auto read = node->value_exact<std::int64_t>();
    if (!read || *read < low || *read > high)
      return file_.wrong(*node, fmt::format("{} must be a whole number from {} to {}", key, low, high));
    value = static_cast<Whole>(*read);
  }
  [[nodiscard]] int place_of(std::string_view name) const {
    for (std::size_t i = 0; i < file_.axes.size(); ++i)
      if (file_.axes[i].name == name) return static_cast<int>(i);
    return -1;
  }

  const toml::table& table_;
  File& file_;
  int depth_;
  bool has_read_ = false;
  std::vector<std::string_view> used_;
};

template <std::size_t... Is>
Step::Body body_of(std::size_t kind, std::index_sequence<Is...>) {
  Step::Body body;
  static_cast<void>(((kind == Is && (body.emplace<Is>(), true)) || ...));
  return body;
}

Step read_step(const toml::table& table, File& file, int depth) {
  FieldReader reader(table, file, depth);
  std::string kind;
  reader.text("do", kind);
  const auto found = std::find(kind_names.begin(), kind_names.end(), kind);
  Step step;
  if (found == kind_names.end()) {
    file.wrong(table, kind.empty() ? "the step does not say what to do"
                                   : fmt::format("there is no step \"{}\"", kind));
    return step;
  }
  step.body = body_of(static_cast<std::size_t>(found - kind_names.begin()),
                      std::make_index_sequence<std::variant_size_v<Step::Any>>());
  std::visit([&reader](auto& body) { fields(reader, body); }, step.body);
  reader.flag("skip", step.skipped);
  reader.end();
  return step;
}

StepList read_steps(const toml::node& node, File& file, int depth) {
  StepList steps;
  const toml::array* array = node.as_array();
  if (!array) return file.wrong(node, "steps must be in [ ]"), steps;
  if (depth > deepest_loop)
    return file.wrong(node, fmt::format("loops are nested more than {} deep", deepest_loop)), steps;
  steps.reserve(array->size());
  for (const toml::node& step : *array) {
    if (file.fault) break;
    if (const toml::table* table = step.as_table())
      steps.push_back(read_step(*table, file, depth));
    else
      file.wrong(step, "a step must be in { }");
  }
  return steps;
}

void read_axes(const toml::node& node, std::vector<Axis>& axes, File& file) {
  const toml::array* array = node.as_array();
  if (!array) return file.wrong(node, "axes must be in [ ]");
  for (const toml::node& each : *array) {
    const toml::table* table = each.as_table();
    if (!table) return file.wrong(each, "an axis must be in { }");
    Axis axis;
    FieldReader reader(*table, file, 0);
    reader.text("name", axis.name);
    reader.number("per_unit", axis.per_unit);
    reader.end();
    if (!(axis.per_unit > 0)) file.wrong(each, "per_unit must be more than 0");
    const bool twice =
        std::any_of(axes.begin(), axes.end(), [&](const Axis& a) { return a.name == axis.name; });
    if (axis.name.empty() || twice) file.wrong(each, "each axis needs its own name");
    axes.push_back(std::move(axis));
  }
  if (axes.empty() || axes.size() > max_axes)
    file.wrong(node, fmt::format("the file must have 1 to {} axes", max_axes));
}

}  // namespace

bool looks_like_sequence(std::string_view text) {
  for (std::size_t at = 0; (at = text.find(version_key, at)) != text.npos; ++at)
    if (at == 0 || text[at - 1] == '\n') return true;
  return false;
}

Result<Sequence> read_sequence(std::string_view text, const std::string& name) {
  Sequence sequence;
  File file{name, sequence.axes, {}};
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const auto& error = parsed.error();
    return fail(FaultKind::text,
                fmt::format("{}, line {}: {}.", name, error.source().begin.line, error.description()),
                "Nothing was loaded from the file.", "Correct that line, or choose another file.");
  }
  FieldReader reader(parsed.table(), file, 0);
  const toml::node* written_as = reader.find(version_key);
  if (!written_as || written_as->value_exact<std::int64_t>() != version)
    return fail(
        FaultKind::text,
        fmt::format("{} is not a sequence of version {} ({} = {}).", name, version, version_key, version),
        "Nothing was loaded from the file.", "Choose a file that was saved here.");
  reader.text("unit", sequence.unit);
  reader.positive("tolerance", sequence.tolerance);
  if (const toml::node* axes = reader.find("axes")) read_axes(*axes, sequence.axes, file);
  if (const toml::node* up = reader.find("pen_up")) sequence.pen_up = read_steps(*up, file, 1);
  if (const toml::node* down = reader.find("pen_down")) sequence.pen_down = read_steps(*down, file, 1);
  reader.steps("steps", sequence.steps);
  reader.end();
  if (file.fault) return fail(std::move(*file.fault));
  if (sequence.axes.empty())
    return fail(FaultKind::text, fmt::format("{} does not list its axes.", name),
                "Nothing was loaded from the file.", "Add axes = [ { name = \"X\" } ].");
  return sequence;
}

}  // namespace hw::sequence
