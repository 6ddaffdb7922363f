#pragma once
// Reads a program text named on the command line, with the language of its controller.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/device/registry.h"
#include "gui/app/cli.h"

namespace hw::app {

struct ProgramFile {
  std::string path, text;
  const Language* language = nullptr;
  Catalog catalog;
};

/// The controller as configured by --variant, --jumpers and --motors. A fault: it has no such option.
Result<Catalog> catalog_for(const DeviceType& type, const Given& given);
/// The controller named by --for, with its language.
struct TargetController {
  const Language* language = nullptr;
  Catalog catalog;
};
Result<TargetController> read_for(const Given& given);
/// Reads FILE and --for. A sequence is first written in the controller's language. FaultKind::text means
/// wrong usage, any other kind an error in the file.
Result<ProgramFile> read_program(const Given& given);
/// The problems of the text, one in a line. If there are too many, errors come before warnings, and the last
/// line counts the rest.
std::vector<std::string> problem_lines(const ProgramFile& program, const ProgramReport& report);

}  // namespace hw::app
