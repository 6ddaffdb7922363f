// The parameters as the console shows them.
#include <fmt/core.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/parameters.h"

namespace hw::vme58 {
namespace {

std::string fill(std::string text, std::string_view letter) {
  for (auto at = text.find("{}"); at != text.npos; at = text.find("{}", at + letter.size()))
    text.replace(at, 2, letter);
  return text;
}

void add_ramp_forms(ParamInfo& p) {
  p.choices.push_back({ramp_linear, "PF: straight"});
  for (int n = 1; n <= parabolic_max; ++n)
    p.choices.push_back({n, fmt::format("PN{}: parabola, down to {} % of the rate", n,
                                        n == parabolic_max ? 5 : 100 - 10 * n)});
  p.choices.push_back({ramp_cosine, "CN: half cosine"});
}

}  // namespace

std::vector<ParamInfo> param_infos(const Variant& variant) {
  std::vector<ParamInfo> all;
  for (const Parameter& parameter : parameters_of(variant)) {
    const ParameterFact& fact = *parameter.fact;
    const std::string_view letter = parameter.axis >= 0
                                        ? axis_letters.substr(static_cast<std::size_t>(parameter.axis), 1)
                                        : std::string_view();
    ParamInfo p;
    p.mnemonic = parameter.mnemonic;
    p.axis = parameter.axis;
    p.group = fact.group;
    p.label = fill(fact.label, letter);
    p.explanation = fill(fact.explanation, letter);
    p.unit = fact.unit;
    p.minimum = fact.minimum, p.maximum = fact.maximum, p.fallback = fact.factory;
    p.decimals = fact.decimals;
    p.drives = fact.drives;
    p.stored = false;
    p.readable = fact.shown.has_value();
    if (!fact.on.empty()) p.choices = {{0, fact.off_words}, {1, fact.on_words}};
    if (fact.letters == "PN") add_ramp_forms(p);
    if (fact.letters == "LN") {
      p.warning = fmt::format(
          "Be ready to stop {}: without its limit switches it runs into the end of its travel.", letter);
      p.harmless = p.fallback;
    }
    all.push_back(std::move(p));
  }
  return all;
}

}  // namespace hw::vme58
