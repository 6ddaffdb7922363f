#pragma once
// The drawings of files/ and what a reader has to find in them (files/README.md).
#include <filesystem>
#include <string>
#include <vector>

namespace hw::drawing {

struct ExpectedDrawing {
  std::filesystem::path file;
  std::string refused;  ///< part of the sentence; empty: it is read
  std::size_t paths = 0;
  double length = 0, left = 0, bottom = 0, right = 0, top = 0;
  bool exact = false;                 ///< lines and arcs only
  std::string unit;                   ///< "none"
  std::vector<std::string> left_out;  ///< "3 TEXT 24: it is a text", or without the reason
};

/// Of all folders of files/.
std::vector<ExpectedDrawing> expected_drawings();
std::string text_of(const std::filesystem::path& file);
/// For the name of a test.
std::string name_of(const ExpectedDrawing& expected);

}  // namespace hw::drawing
