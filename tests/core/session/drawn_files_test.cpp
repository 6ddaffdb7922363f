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

/// Of each kind of what files hold; own, of other software, and of each age.
constexpr const char* files[] = {"ezdxf/lines_and_arcs_r2000.dxf",
                                 "ezdxf/lines_and_arcs_r2018.dxf",
                                 "ezdxf/seen_from_below_r12.dxf",
                                 "ezdxf/seen_from_below_r2018.dxf",
                                 "ezdxf/blocks_r2018.dxf",
                                 "ezdxf/light_polylines_r2000.dxf",
                                 "ezdxf/stretched_r12.dxf",
                                 "ezdxf/stretched_r2007.dxf",
                                 "ezdxf/ellipses_r2007.dxf",
                                 "ezdxf/splines_r2000.dxf",
                                 "other/inkscape_r14.dxf",
                                 "other/librecad_drawn.dxf",
                                 "other/librecad_saved.dxf",
                                 "own/arcs.dxf",
                                 "own/arcs_below.dxf",
                                 "own/arcs_new.dxf",
                                 "own/behind_the_end.dxf",
                                 "own/blanks.dxf",
                                 "own/bulges.dxf",
                                 "own/bulges_as_good_as_none.dxf",
                                 "own/byte_order_mark.dxf",
                                 "own/circles.dxf",
                                 "own/comments.dxf",
                                 "own/dimensions.dxf",
                                 "own/ellipse_parts.dxf",
                                 "own/ellipses_below.dxf",
                                 "own/ends_of_lines.dxf",
                                 "own/filled.dxf",
                                 "own/in_space.dxf",
                                 "own/inserts.dxf",
                                 "own/inserts_below.dxf",
                                 "own/inserts_in_rows.dxf",
                                 "own/inserts_mirrored.dxf",
                                 "own/inserts_nested.dxf",
                                 "own/inserts_sheared.dxf",
                                 "own/inserts_stretched.dxf",
                                 "own/layers.dxf",
                                 "own/lines.dxf",
                                 "own/old_polylines.dxf",
                                 "own/on_the_sheet.dxf",
                                 "own/only_entities.dxf",
                                 "own/passed_over.dxf",
                                 "own/points.dxf",
                                 "own/polylines.dxf",
                                 "own/polylines_in_space.dxf",
                                 "own/polylines_of_programs.dxf",
                                 "own/splines.dxf",
                                 "own/splines_closed.dxf",
                                 "own/splines_through_points.dxf",
                                 "own/splines_weighted.dxf",
                                 "own/texts.dxf"};

std::vector<Drawn> drawn_files() {
  std::vector<Drawn> all;
  for (const char* model : {"vxm", "pmx-4ex-sa", "vme58"})
    for (const char* file : files) all.push_back({model, file});
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
