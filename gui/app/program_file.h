#pragma once
// A program text named on the command line, with the language of its controller.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "gui/app/cli.h"

namespace hw::app {

struct ProgramFile {
  std::string path, text;
  const Language* language = nullptr;
  Catalog catalog;
};

/// The controller named by --for, with its language.
struct MeantFor {
  const Language* language = nullptr;
  Catalog catalog;
};
Result<MeantFor> read_for(const Given& given);
/// Reads FILE and --for; a sequence is first written in the controller's language. FaultKind::text: wrong
/// usage; any other: an error in the file.
Result<ProgramFile> read_program(const Given& given);
/// The problems of its text, a line for each of the first ones, errors before warnings where there are too
/// many, and a line that counts the rest.
std::vector<std::string> problem_lines(const ProgramFile& program, const ProgramReport& report);

}  // namespace hw::app
