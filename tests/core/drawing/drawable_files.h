#pragma once
// Whole drawings of files/ that each controller can draw.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/drawing/dxf_reader.h"
#include "core/drawing/dxf_scan.h"
#include "core/session/user_files.h"

namespace hw {

/// Of each kind of what files hold; own, of other software, and of each age.
inline constexpr const char* drawable_files[] = {"ezdxf/lines_and_arcs_r2000.dxf",
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

/// In mm, whatever it says; its splines and ellipses within `chord`.
inline drawing::Drawing read_drawable(const std::string& name, double chord) {
  const std::filesystem::path file = std::filesystem::path(HW_TEST_DIR) / "core/drawing/files" / name;
  const auto text = read_file(file, drawing::largest_dxf);
  auto read = drawing::read_dxf(text ? *text : std::string(), name, drawing::Tolerance{chord});
  EXPECT_TRUE(read) << read.error().sentence();
  if (read) read->unit = "mm";
  return read ? *read : drawing::Drawing();
}

}  // namespace hw
