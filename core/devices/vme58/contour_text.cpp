#include "core/devices/vme58/contour_text.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {
namespace {

/// A list by places: Z and T are ",,1000,0;".
std::string places(AxisId a, std::int64_t at_a, AxisId b, std::int64_t at_b) {
  std::string text;
  for (int place = 0; place <= std::max(a.index, b.index); ++place) {
    if (place > 0) text += ',';
    if (place == a.index) text += std::to_string(at_a);
    if (place == b.index) text += std::to_string(at_b);
  }
  return text + ';';
}

}  // namespace

// Inside a contour the operands belong to its axes in their order (decision M68), outside to places. The
// first axis of the contour is the one with the lower letter, so a plan that turns them round is written
// mirrored.
Result<std::string> contour_text(const ContourPlan& plan, const Catalog& catalog) {
  const auto shape = draw_contour(plan, catalog);
  if (!shape) return fail(shape.error());
  const bool turned = plan.first > plan.second;
  const auto pair = [&](std::int64_t x, std::int64_t y) {
    return turned ? fmt::format("{},{}", y, x) : fmt::format("{},{}", x, y);
  };
  std::string text = fmt::format("AA\nCV{};\nCD{}\n", std::llround(plan.speed.value),
                                 places(plan.first, plan.x.value, plan.second, plan.y.value));
  int entries = 1;
  for (const ContourPiece& p : plan.pieces) {
    ++entries;
    if (p.kind == ContourPiece::Kind::line) text += fmt::format("MT{};\n", pair(p.x.value, p.y.value));
    if (p.kind == ContourPiece::Kind::arc) {
      const double radians = p.degrees / 180 * std::numbers::pi * (turned ? -1 : 1);
      text += fmt::format("CR{},{:.9f};\n", pair(p.x.value, p.y.value), radians);
    }
    if (p.kind == ContourPiece::Kind::output) {
      const int port = catalog.output_number(static_cast<std::size_t>(p.output)) - first_auxiliary;
      if (port < 0)
        return fail(FaultKind::text,
                    fmt::format("{} cannot be switched within a contour: only the auxiliary outputs can.",
                                catalog.outputs[static_cast<std::size_t>(p.output)].name),
                    "Nothing was sent.");
      text += fmt::format("{}{};\n", p.on ? "AN" : "AF", port);
    }
  }
  if (entries > catalog.contour_size)
    return fail(
        FaultKind::text,
        fmt::format("The contour has {} entries, and the board keeps {}.", entries, catalog.contour_size),
        "Nothing was sent.");
  text += plan.ramp ? "CE\n" : "CK\n";
  text += fmt::format("MT{} GO\nCX\n", places(plan.first, std::llround(shape->park.x), plan.second,
                                              std::llround(shape->park.y)));
  return text;
}

// MP and MM say which way, MV runs at a speed up to a position, SP comes to rest (decision M84).
Result<std::string> staircase_text(const StaircasePlan& plan, const Catalog& catalog) {
  if (auto fine = check_staircase(plan, catalog); !fine) return fail(fine.error());
  std::string text =
      fmt::format("A{}\n{}\n", axis_letters[plan.axis.index], plan.stop_at > plan.from ? "MP" : "MM");
  for (const StaircaseStep& s : plan.steps)
    text += fmt::format("MV{},{};\n", s.until.value, std::llround(s.speed.value));
  return text + fmt::format("SP{};\n", plan.stop_at.value);
}

std::vector<int> contour_outputs(const Catalog& catalog) {
  std::vector<int> all;
  for (std::size_t i = 0; i < catalog.outputs.size(); ++i)
    if (catalog.output_number(i) >= first_auxiliary) all.push_back(static_cast<int>(i));
  return all;
}

}  // namespace hw::vme58
