#pragma once
// What must not be lost, in a sentence of its own.
#include <functional>
#include <string>

#include "core/device/snapshot.h"

namespace hw::arcus {

using Tell = std::function<void(Notice::Kind, std::string)>;

}  // namespace hw::arcus
