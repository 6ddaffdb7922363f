// Whole drawings of files/, from the text of a file to the emulated tool: it goes through every vertex, and
// stays on the drawing while it is down.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "../drawing/dxf_table.h"
#include "core/drawing/dxf_reader.h"
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
  drawing::Drawing read() const {
    const std::string name = GetParam().file;
    const std::filesystem::path file = std::filesystem::path(HW_TEST_DIR) / "core/drawing/files" / name;
    auto read = drawing::read_dxf(drawing::text_of(file), name, drawing::Tolerance{*o.tolerance});
    EXPECT_TRUE(read) << read.error().sentence();
    if (read) read->unit = "mm";
    return read ? *read : drawing::Drawing();
  }
};

TEST_P(DrawnFile, IsDrawnThroughEveryVertexAndNowhereElse) {
  ASSERT_NO_FATAL_FAILURE(draw(read()));
  expect_every_vertex();
  expect_nothing_beside();
}

// A VXM has 256 bytes for a program; a line that is neither across nor along is a staircase.
constexpr Drawn drawn_files[] = {{"vxm", "own/polylines_in_space.dxf"},
                                 {"vxm", "own/passed_over.dxf"},
                                 {"vxm", "own/on_the_sheet.dxf"},
                                 {"pmx-4ex-sa", "ezdxf/lines_and_arcs_r2000.dxf"},
                                 {"pmx-4ex-sa", "ezdxf/seen_from_below_r12.dxf"},
                                 {"pmx-4ex-sa", "ezdxf/blocks_r2018.dxf"},
                                 {"pmx-4ex-sa", "ezdxf/ellipses_r2007.dxf"},
                                 {"pmx-4ex-sa", "ezdxf/splines_r2000.dxf"},
                                 {"pmx-4ex-sa", "own/bulges.dxf"},
                                 {"pmx-4ex-sa", "own/inserts_mirrored.dxf"},
                                 {"pmx-4ex-sa", "own/old_polylines.dxf"},
                                 {"pmx-4ex-sa", "other/inkscape_r14.dxf"},
                                 {"pmx-4ex-sa", "other/librecad_saved.dxf"},
                                 {"vme58", "ezdxf/lines_and_arcs_r2000.dxf"},
                                 {"vme58", "ezdxf/seen_from_below_r12.dxf"},
                                 {"vme58", "ezdxf/blocks_r2018.dxf"},
                                 {"vme58", "ezdxf/ellipses_r2007.dxf"},
                                 {"vme58", "ezdxf/splines_r2000.dxf"},
                                 {"vme58", "own/bulges.dxf"},
                                 {"vme58", "own/inserts_mirrored.dxf"},
                                 {"vme58", "own/old_polylines.dxf"},
                                 {"vme58", "other/inkscape_r14.dxf"},
                                 {"vme58", "other/librecad_saved.dxf"}};

INSTANTIATE_TEST_SUITE_P(Each, DrawnFile, testing::ValuesIn(drawn_files), [](const auto& info) {
  std::string name = fmt::format("{}_{}", info.param.model, info.param.file);
  name.resize(name.find('.'));
  for (char& c : name)
    if (c == '-' || c == '/') c = '_';
  return name;
});

}  // namespace
}  // namespace hw
