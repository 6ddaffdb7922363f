#pragma once
// Data that a run keeps for its script and reports at its end.
#include <map>
#include <string>

#include "core/script/axis_units.h"
#include "core/script/lua_advice.h"

namespace hw::script {

/// The files that the script has written, each once.
class Written {
 public:
  /// `what`: "12 rows"; empty: no detail.
  void note(const std::string& path, std::string what) { files_[path] = std::move(what); }
  /// "Wrote a.csv (12 rows), b.png."; empty: no files.
  [[nodiscard]] std::string sentence() const;

 private:
  std::map<std::string, std::string> files_;
};

struct Notes {
  AxisUnits units;
  Written written;
  LuaAdvice advice;
  bool words_are_wrong = false;  ///< the script's arguments are wrong: see hw.arguments
};

}  // namespace hw::script
