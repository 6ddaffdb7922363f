#include "dxf_table.h"

#include <fstream>
#include <sstream>

namespace hw::drawing {

static void take_row(const std::string& row, ExpectedDrawing& e) {
  std::istringstream words(row.substr(0, row.find(" #")));
  std::string what, more;
  words >> what;
  if (what == "paths") words >> e.paths;
  if (what == "length") words >> e.length;
  if (what == "box") words >> e.left >> e.bottom >> e.right >> e.top;
  if (what == "unit") words >> e.unit;
  if (what == "exact") e.exact = true;
  if (what == "refused:") std::getline(words >> std::ws, e.refused);
  if (what != "left") return;
  words >> what;  // "out"
  std::getline(words >> std::ws, more);
  e.left_out.push_back(more);
}

std::vector<ExpectedDrawing> expected_drawings() {
  std::vector<ExpectedDrawing> all;
  const std::filesystem::path files = std::filesystem::path(HW_TEST_DIR) / "core/drawing/files";
  for (const char* folder : {"ezdxf", "other", "own"}) {
    std::ifstream in(files / folder / "expected.txt");
    for (std::string row; std::getline(in, row);) {
      if (row.starts_with('#') || row.empty()) continue;
      if (row.starts_with("  "))
        take_row(row, all.back());
      else
        all.push_back({files / folder / row, {}, 0, 0, 0, 0, 0, 0, false, {}, {}});
    }
  }
  return all;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string name_of(const ExpectedDrawing& expected) {
  return expected.file.parent_path().filename().string() + "_" + expected.file.stem().string();
}

}  // namespace hw::drawing
