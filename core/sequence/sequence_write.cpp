#include <span>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/base/toml.h"
#include "core/sequence/fields.h"
#include "core/sequence/sequence_file.h"

namespace hw::sequence {
namespace {

void write_steps(std::string& out, const StepList& steps, const Sequence& of, int depth);

/// The fields of one step.
class FieldWriter {
 public:
  FieldWriter(std::string& out, const Sequence& of, int depth) : out_(out), of_(of), depth_(depth) {}

  void number(std::string_view key, double value) { put(key, fmt::format("{}", value)); }
  void needed(std::string_view key, double value) { number(key, value); }
  void positive(std::string_view key, double value) {
    if (value != 0) number(key, value);
  }
  void flag(std::string_view key, bool value) { put(key, value ? "true" : "false"); }
  void text(std::string_view key, const std::string& value) { put(key, toml_quoted(value)); }
  void count(std::string_view key, int value) { put(key, fmt::format("{}", value)); }
  void line(std::string_view key, int value) { count(key, value); }
  void line_or_all(std::string_view key, int value) {
    all_lines_ = value < 0;
    if (!all_lines_) line(key, value);
  }
  void word(std::string_view key, std::uint32_t value) {
    if (all_lines_ || value != 0) put(key, fmt::format("{}", value));
  }
  void axis(std::string_view key, int value) { put(key, toml_quoted(of_.axes[ix(value)].name)); }
  void axis_or_all(std::string_view key, int value) {
    if (value >= 0) axis(key, value);
  }
  void sign(std::string_view key, Sign value) { put(key, value == Sign::plus ? "\"+\"" : "\"-\""); }
  template <class Choice>
  void choice(std::string_view key, Choice value, std::span<const std::string_view> names) {
    put(key, toml_quoted(names[static_cast<std::size_t>(value)]));
  }
  void places(std::string_view key, const Places& value) {
    std::string all;
    for (std::size_t i = 0; i < of_.axes.size(); ++i)
      if (value[i])
        all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", toml_key(of_.axes[i].name), *value[i]);
    put(key, "{ " + all + " }");
  }
  /// The first two axes are not written.
  void plane(std::string_view key, const Plane& value) {
    if (value == Plane()) return;
    const auto name = [this](int axis) { return toml_quoted(of_.axes[ix(axis)].name); };
    put(key, fmt::format("[{}, {}]", name(value.right), name(value.up)));
  }
  void stairs(std::string_view key, const std::vector<SpeedStairs::Stair>& value) {
    std::string all;
    for (const auto& [until, speed] : value)
      all += fmt::format("{}{{ until = {}, speed = {} }}", all.empty() ? "" : ", ", until, speed);
    put(key, fmt::format("[{}]", all));
  }
  void own(const OwnSpeeds& value) {
    if (!value) return;
    const std::size_t before = out_.size();
    fields(*this, *value);
    if (out_.size() == before) number("high", 0);  // own speeds, all the controller's
  }
  void steps(std::string_view key, const StepList& value) {
    put(key, "");
    write_steps(out_, value, of_, depth_ + 1);
  }

 private:
  void put(std::string_view key, std::string_view value) { out_ += fmt::format(", {} = {}", key, value); }

  std::string& out_;
  const Sequence& of_;
  int depth_;
  bool all_lines_ = false;
};

void write_steps(std::string& out, const StepList& steps, const Sequence& of, int depth) {
  const std::string margin(2 * static_cast<std::size_t>(depth), ' ');
  out += "[\n";
  for (const Step& step : steps) {
    out += fmt::format("{}{{ do = \"{}\"", margin, kind_names[step.body.index()]);
    FieldWriter writer(out, of, depth);
    std::visit([&writer](const auto& body) { fields(writer, body); }, step.body);
    out += step.skipped ? ", skip = true },\n" : " },\n";
  }
  out += margin.substr(2) + "]";
}

}  // namespace

std::string write_sequence(const Sequence& sequence) {
  std::string out = "handwheel_sequence = 1\n";
  out += fmt::format("unit = {}\naxes = [\n", toml_quoted(sequence.unit));
  for (const Axis& axis : sequence.axes)
    out += fmt::format("  {{ name = {}, per_unit = {} }},\n", toml_quoted(axis.name), axis.per_unit);
  out += "]\n";
  if (sequence.tolerance != 0) out += fmt::format("tolerance = {}\n", sequence.tolerance);
  const auto list = [&](const char* name, const StepList& steps) {
    out += fmt::format("{} = ", name);
    write_steps(out, steps, sequence, 1);
    out += "\n";
  };
  if (!sequence.pen_up.empty()) list("pen_up", sequence.pen_up);
  if (!sequence.pen_down.empty()) list("pen_down", sequence.pen_down);
  list("steps", sequence.steps);
  return out;
}

}  // namespace hw::sequence
