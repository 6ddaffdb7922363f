// Whole drawings of files/, from the text of a file to the emulated tool: it goes through every vertex, and
// stays on the drawing while it is down.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "../drawing/drawable_files.h"
#include "emulator_drawing.h"

namespace hw {
namespace {

struct Drawn {
  const char* model;
  const char* file;
};
void PrintTo(const Drawn& d, std::ostream* out) { *out << d.model << " " << d.file; }

struct DrawnFile : testing::TestWithParam<Drawn>, EmulatorDrawing {
  DrawnFile() : EmulatorDrawing(GetParam().model) { o.placing.origin = drawing::Placing::Origin::lower_left; }
};

TEST_P(DrawnFile, IsDrawnThroughEveryVertexAndNowhereElse) {
  ASSERT_NO_FATAL_FAILURE(draw(read_drawable(GetParam().file, *o.tolerance)));
  expect_every_vertex();
  expect_nothing_beside();
}

std::vector<Drawn> drawn_files() {
  std::vector<Drawn> all;
  for (const char* model : {"vxm", "pmx-4ex-sa", "vme58"})
    for (const char* file : drawable_files) all.push_back({model, file});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Each, DrawnFile, testing::ValuesIn(drawn_files()), [](const auto& info) {
  std::string name = fmt::format("{}_{}", info.param.model, info.param.file);
  name.resize(name.find('.'));
  for (char& c : name)
    if (c == '-' || c == '/') c = '_';
  return name;
});

}  // namespace
}  // namespace hw
