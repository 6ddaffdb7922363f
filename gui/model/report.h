#pragma once
// A job's message to the user: shown once, as a toast.
#include <string>
#include <utility>
#include <vector>

#include "gui/model/severity.h"

namespace hw::gui {

struct Report {
  Severity severity = Severity::plain;
  std::string sentence;
};

}  // namespace hw::gui
