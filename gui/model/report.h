#pragma once
// What a job has to say to the user: shown as a toast, once.
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
