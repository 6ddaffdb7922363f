#pragma once
// Set-up and programs of one controller as a TOML file for people to read and edit:
//   model = "vxm"
//   [parameters]
//   j1M = 100      # First jog speed of motor 1, steps/s
//   [variables]
//   50 = -12
//   [programs]
//   0 = """..."""
// A set-up file has no programs.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"

namespace hw {

struct ParameterEntry {
  std::string mnemonic;
  std::int64_t value = 0;
  int line = 0;  ///< in the file, from 1; 0: not from a file
};

struct Backup {
  std::string model;     ///< Catalog::model
  std::string name;      ///< the user's name for the controller
  std::string firmware;  ///< empty: unknown
  std::string saved_at;  ///< "2026-05-04 14:02:04"
  std::vector<ParameterEntry> parameters;
  std::map<int, std::int64_t> variables;  ///< stored variables
  std::map<int, std::string> programs;    ///< by slot; one command a line
};

std::string write_backup(const Backup& backup, const Catalog& catalog);
/// Faults name the line. Values that are not whole numbers, and unknown tables, are faults too.
Result<Backup> parse_backup(std::string_view toml, const std::string& file_name);

Result<> save_backup(const std::filesystem::path& path, const Backup& backup, const Catalog& catalog);
Result<Backup> load_backup(const std::filesystem::path& path);

/// The part of a file that suits a controller. Each problem is a sentence that names the line and what was
/// left out.
struct CheckedBackup {
  std::vector<ParameterEntry> parameters;
  std::map<int, std::int64_t> variables;
  std::map<int, std::string> programs;
  std::vector<std::string> problems;
};
/// A file of another model is a fault.
Result<CheckedBackup> check_backup(const Backup& backup, const Catalog& catalog,
                                   const std::string& file_name);

/// "1 to 6000", "0 or 10 to 6000", "0, 2, 4".
std::string range_of(const ParamInfo& param);

}  // namespace hw
