#pragma once
// Drivers that lie, so that the suite can show that it notices. Each lie is one small change that a driver
// could have by mistake, put around the real driver of any listed controller. `contract_tests --lie=NAME`
// runs the suite with it, and must fail; `--lies` lists them, with the controllers on which each can be told.
#include <string_view>
#include <vector>

#include "core/device/registry.h"

namespace hw {

/// From now on every type of types_under_test() tells it. False: there is none of this name.
bool choose_lie(std::string_view name);
/// The listed controllers that can be emulated; their drivers tell the chosen lie, if there is one.
std::vector<const DeviceType*> types_under_test();
/// Those of them with a language.
std::vector<const DeviceType*> types_with_a_language();
/// A line for each: NAME MODEL...
void print_lies();

}  // namespace hw
