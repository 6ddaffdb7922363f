#include <algorithm>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "core/device/registry.h"
#include "core/session/address.h"
#include "core/session/parameter_file.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"

namespace hw::app {
namespace {

using ParamJson = nlohmann::ordered_json;

Result<Catalog> catalog_of(const Given& given) {
  const DeviceType* type = find_device_type(given.words[0]);
  if (!type) return fail(unknown_model(given.words[0]));
  return catalog_for(*type, given);
}

/// A value in the maker's notation: 0.8, "4EX07".
std::string written(const ParamInfo& info, std::int64_t value) {
  if (!info.prefix.empty()) return fmt::format("{}{:0{}}", info.prefix, value, info.digits);
  if (info.decimals == 0) return fmt::format("{}", value);
  double unit = 1;
  for (int i = 0; i < info.decimals; ++i) unit *= 10;
  return fmt::format("{:.{}f}", static_cast<double>(value) / unit, info.decimals);
}

std::string written_range(const ParamInfo& info) {
  if (!info.choices.empty() || (info.decimals == 0 && info.prefix.empty())) return range_of(info);
  return fmt::format("{} to {}", written(info, info.minimum), written(info, info.maximum));
}

void print_parameters(const Catalog& catalog, const AccelerationUnit& acceleration) {
  std::size_t widest = 0;
  for (const ParamInfo& info : catalog.params) widest = std::max(widest, info.mnemonic.size());
  for (const ParamInfo& info : catalog.params)
    print_result("{:<{}}  {}{}: {} (default {})\n", info.mnemonic, widest, info.label,
                 info.unit.empty() ? "" : fmt::format(" [{}]", info.unit), written_range(info),
                 written(info, info.fallback));
  if (acceleration.maximum == 0) return;  // the controller has no such setting
  print_result("acceleration= of one motion of a script: {} to {} {}; {}\n", acceleration.minimum,
               acceleration.maximum, acceleration.unit, acceleration.meaning);
}

/// A value as a number, or as a name if the maker uses one.
ParamJson as_json(const ParamInfo& info, std::int64_t value) {
  const std::string text = written(info, value);
  return info.prefix.empty() ? ParamJson::parse(text) : ParamJson(text);
}

void print_parameters_json(const Catalog& catalog, const AccelerationUnit& acceleration) {
  ParamJson all = ParamJson::array();
  for (const ParamInfo& info : catalog.params) {
    ParamJson one;
    one["name"] = info.mnemonic;
    one["label"] = info.label;
    one["unit"] = info.unit.empty() ? ParamJson(nullptr) : ParamJson(info.unit);
    one["min"] = as_json(info, info.minimum);
    one["max"] = as_json(info, info.maximum);
    one["default"] = as_json(info, info.fallback);
    for (const ParamChoice& choice : info.choices)
      one["choices"].push_back({{"value", as_json(info, choice.value)}, {"label", choice.label}});
    all.push_back(std::move(one));
  }
  ParamJson out{{"model", catalog.model}, {"parameters", std::move(all)}};
  out["acceleration"] = {
      {"unit", std::string(acceleration.unit)}, {"min", acceleration.minimum}, {"max", acceleration.maximum}};
  print_result("{}\n", out.dump(-1, ' ', true, ParamJson::error_handler_t::replace));
}

}  // namespace

static int params(const Given& given) {
  const auto catalog = catalog_of(given);
  if (!catalog) return complain(catalog.error(), usage);
  const AccelerationUnit& acceleration = find_device_type(given.words[0])->acceleration;
  if (given.has("json"))
    print_parameters_json(*catalog, acceleration);
  else
    print_parameters(*catalog, acceleration);
  return done;
}

const Subcommand params_subcommand{
    "params",
    "the parameters of a model: name, label, unit, range, default",
    {{"MODEL", "the model", 1, 1}},
    {json_option, {"motors", "N", "number of motors (vxm): 2 or 4"}, variant_option},
    params,
};

}  // namespace hw::app
