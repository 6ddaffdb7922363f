#pragma once
// What a run keeps for its script, and tells at its end.
#include <map>
#include <string>

#include "core/script/axis_units.h"

namespace hw::script {

/// The files that it has written, each once.
class Written {
 public:
  /// `what`: "12 rows"; empty: nothing more is to be said of it.
  void note(const std::string& path, std::string what) { files_[path] = std::move(what); }
  /// "Wrote a.csv (12 rows), b.png."; empty: nothing was written.
  [[nodiscard]] std::string sentence() const;

 private:
  std::map<std::string, std::string> files_;
};

struct Notes {
  AxisUnits units;
  Written written;
  bool words_are_wrong = false;  ///< those behind the script's name: see hw.arguments
};

}  // namespace hw::script
