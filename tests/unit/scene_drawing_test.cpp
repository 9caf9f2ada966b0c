// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// A section from a DXF drawing: layers, laws, supports, and drawings that do not serve.
#include <gtest/gtest.h>

#include <array>

#include "bridge/geometry/polygon.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_drawing_test {
using namespace blockweir::scene;
using testing::HasSubstr;
using testing::SizeIs;

namespace {

std::string entity(const std::string& kind, const std::string& layer, const std::string& rest) {
  return "0\n" + kind + "\n8\n" + layer + "\n" + rest;
}
std::string point(double x, double y, int code = 0) {
  return std::to_string(10 + code) + "\n" + std::to_string(x) + "\n" + std::to_string(20 + code) + "\n" +
         std::to_string(y) + "\n";
}
std::string line(const std::string& layer, double x0, double y0, double x1, double y1) {
  return entity("LINE", layer, point(x0, y0) + point(x1, y1, 1));
}
std::string polyline(const std::string& layer, bool closed, const std::vector<Point>& points) {
  std::string text = "90\n" + std::to_string(points.size()) + "\n70\n" + (closed ? "1\n" : "0\n");
  for (const Point& p : points) text += point(p.x(), p.y());
  return entity("LWPOLYLINE", layer, text);
}
/// As of release 12: its points follow, each an entity.
std::string old_polyline(const std::string& layer, const std::string& flags, const std::vector<Point>& points,
                         const std::string& bulge = "") {
  std::string text = entity("POLYLINE", layer, "66\n1\n70\n" + flags + "\n");
  for (const Point& p : points) text += entity("VERTEX", layer, point(p.x(), p.y()) + bulge);
  return text + entity("SEQEND", layer, "");
}
std::string blocks(const std::string& name, const std::string& entities) {
  return "0\nSECTION\n2\nBLOCKS\n" + entity("BLOCK", "0", "2\n" + name + "\n") + entities + entity("ENDBLK", "0", "") +
         "0\nENDSEC\n";
}
std::string drawing(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

const std::string square = polyline("Section", true, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});

class Drawing : public sample::SceneFolder {
 protected:
  [[nodiscard]] std::filesystem::path scene(const std::string& dxf, const std::string& more = "",
                                            const std::string& section = "") const {
    static_cast<void>(write("d.dxf", dxf));
    static_cast<void>(write("scene.toml",
                            "[analysis]\nduration_s = 1\n[material.concrete]\nyoungs_modulus_pa = 30e9\n"
                            "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n[section]\n"
                            "material = \"concrete\"\ndxf = \"d.dxf\"\n" +
                                section + more));
    return folder_;
  }
};

TEST_F(Drawing, GivesOutlineCutsAndSupports) {
  const Scene s =
      read(scene(drawing(square + line("joints crack", 0, 2, 4, 2) + entity("POINT", "supports", point(1, 0))),
                 "[[cut]]\nname = \"crack\"\ncohesion_pa = 7\n"))
          .scene;
  ASSERT_THAT(s.blocks, SizeIs(2));
  ASSERT_THAT(s.joints, SizeIs(1));
  EXPECT_EQ(s.joints[0].name, "crack");
  EXPECT_EQ(s.joints[0].law.cohesion_pa, 7);
  ASSERT_THAT(s.supports, SizeIs(1));
  EXPECT_EQ(s.supports[0].point_m, Point(1, 0));
  // Its text says all by itself: the processes read that.
  const Scene again = read_text(s.text, s.file.string()).scene;
  EXPECT_EQ(again.blocks[1].vertices, s.blocks[1].vertices);
  EXPECT_EQ(again.joints, s.joints);
  EXPECT_EQ(again.supports, s.supports);
}

TEST_F(Drawing, LinesThatMeetCloseTheOutlineAndSmallerRingsAreHoles) {
  const std::string lines = line("section", 0, 0, 4, 0) + line("section", 4, 4, 4, 0) + line("section", 4, 4, 0, 4) +
                            line("section", 0, 0, 0, 4);
  const std::string hole = polyline("section", true, {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const Scene s = read(scene(drawing(lines + hole + polyline("joints", false, {{0, 1.5}, {1, 1.5}}) +
                                     line("joints", 2, 1.5, 4, 1.5) + entity("POINT", "supports", point(0, 0)) +
                                     entity("POINT", "supports", point(0, 4)))))
                      .scene;
  EXPECT_THAT(s.blocks, SizeIs(2));
}

TEST_F(Drawing, OldPolylinesAreReadAsNewOnes) {
  const std::string held = entity("POINT", "supports", point(1, 0)) + entity("POINT", "supports", point(1, 4));
  const std::vector<Point> cut = {{-1, 1}, {2, 2}, {5, 1}};
  const Scene now = read(scene(drawing(square + polyline("joints lift", false, cut) + held))).scene;
  const std::string outline = old_polyline("section", "1", {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Scene old = read(scene(drawing(outline + old_polyline("joints lift", "0", cut) + held))).scene;
  ASSERT_THAT(old.blocks, SizeIs(2));
  EXPECT_EQ(old.blocks[0].vertices, now.blocks[0].vertices);
  EXPECT_EQ(old.blocks[1].vertices, now.blocks[1].vertices);
  EXPECT_EQ(old.joints, now.joints);
}

TEST_F(Drawing, WhatIsNotReadIsRefusedWhereItsLayerIsUsed) {
  const std::vector<Point> cut = {{-1, 1}, {5, 1}};
  const std::string placed = point(0, 2);
  const std::vector<std::array<std::string, 2>> refused = {
      {entity("CIRCLE", "Joints", placed + "40\n1\n"),
       "d.dxf:29: error: found CIRCLE on the layer \"joints\", which is not read; expected LINE, LWPOLYLINE or "
       "POLYLINE"},
      {entity("SPLINE", "joints", "70\n8\n") + entity("SPLINE", "joints", "70\n8\n"),
       "found SPLINE on the layer \"joints\", and 1 more, which is not read"},
      {entity("MLINE", "joints-a", ""), "found MLINE on the layer \"joints-a\""},
      {entity("HATCH", "section", ""), "draw it by lines, or move it to another layer"},
      {polyline("joints", false, cut) + "42\n0.5\n", "found LWPOLYLINE with arcs on the layer \"joints\""},
      {polyline("joints", false, cut) + "230\n-1\n", "found LWPOLYLINE in a turned plane"},
      {old_polyline("joints", "0", cut, "42\n0.5\n"), "found POLYLINE with arcs"},
      {old_polyline("joints", "4", cut), "found POLYLINE with arcs"},
      {old_polyline("joints", "16", cut), "found POLYLINE of a mesh"},
      {line("supports", 0, 0, 4, 0), "found LINE on the layer \"supports\", which is not read; expected POINT; draw a"},
      {entity("POINT", "joints", placed), "found POINT on the layer \"joints\""},
      {entity("INSERT", "joints", "2\nA\n" + placed), "found INSERT that draws on the layer \"joints\""}};
  for (const auto& [entities, told] : refused) {
    EXPECT_THAT(error(scene(drawing(square + entities))), HasSubstr(told)) << entities;
  }
}

TEST_F(Drawing, WhatIsNotReadIsLeftWhereItsLayerIsNotUsed) {
  const std::string held = entity("POINT", "supports", point(1, 0));
  const std::string paper = entity("LINE", "joints", "67\n1\n" + point(0, 2) + point(4, 2, 1));
  EXPECT_THAT(read(scene(drawing(square + held + paper + entity("SPLINE", "axis", "") +
                                 entity("TEXT", "joints", point(1, 1) + "1\nlift 1\n"))))
                  .scene.blocks,
              SizeIs(1));
}

TEST_F(Drawing, PartsOfABlockAreDrawnNowhereAndWhatPlacesThemIsRefused) {
  const std::string entities = drawing(square + entity("POINT", "supports", point(1, 0)));
  const std::string lift = blocks("Lift", line("joints lift", 0, 0, 4, 0));
  const std::string both = lift + blocks("sheet", entity("INSERT", "0", "2\nLIFT\n" + point(0, 2)));
  EXPECT_THAT(read(scene(both + entities)).scene.blocks, SizeIs(1));
  const std::string placed = drawing(square + entity("INSERT", "0", "2\nSheet\n" + point(0, 0)));
  EXPECT_THAT(error(scene(both + placed)),
              HasSubstr("found INSERT that draws on the layer \"joints lift\", which is not read; expected LINE, "
                        "LWPOLYLINE or POLYLINE without arcs; explode it"));
  const std::string frame = blocks("sheet", line("frame", 0, 0, 4, 0));
  EXPECT_THAT(read(scene(frame + drawing(square + entity("POINT", "supports", point(1, 0)) +
                                         entity("INSERT", "0", "2\nsheet\n" + point(0, 0)))))
                  .scene.blocks,
              SizeIs(1));
  EXPECT_THAT(read(scene(blocks("a", entity("INSERT", "0", "2\na\n")) +
                         drawing(square + entity("POINT", "supports", point(1, 0)) + entity("INSERT", "0", "2\na\n"))))
                  .scene.blocks,
              SizeIs(1));
}

TEST_F(Drawing, CapitalsOfACutDoNotCount) {
  const std::string lines = square + line("Joints LIFT a", 0, 2, 4, 2) + entity("POINT", "supports", point(1, 0)) +
                            entity("POINT", "supports", point(1, 4));
  const Scene s = read(scene(drawing(lines), "[[cut]]\nname = \"Lift A\"\ncohesion_pa = 7\n")).scene;
  ASSERT_THAT(s.joints, SizeIs(1));
  EXPECT_EQ(s.joints[0].name, "Lift A");
  EXPECT_EQ(s.joints[0].law.cohesion_pa, 7);
  const std::string told = error(scene(drawing(lines), "[[cut]]\nname = \"lift B\"\ncohesion_pa = 7\n"));
  EXPECT_THAT(told, HasSubstr("scene.toml:10: error: [[cut]] \"lift B\" has no points_m, and no line is on "
                              "the layer \"joints lift b\""));
  EXPECT_THAT(told, HasSubstr("did you mean \"joints lift a\"?"));
  EXPECT_THAT(error(scene(drawing(square), "[[cut]]\nname = \"joint\"\n")),
              HasSubstr("on the layer \"joints\"; expected one of them; draw it on that layer, or add points_m"));
  const std::string twice = "[[cut]]\nname = \"lift A\"\n[[cut]]\nname = \"lift a\"\n";
  EXPECT_THAT(error(scene(drawing(lines), twice)), HasSubstr("[[cut]] \"lift a\" has no \"points_m\""));
}

TEST_F(Drawing, LayersThatAreNotUsedAreTold) {
  const std::string held = entity("POINT", "supports", point(1, 0));
  for (const std::string layer : {"joint lift", "jionts", "Jointslift", "sections", "support"}) {
    const auto warnings = read(scene(drawing(square + held + line(layer, 0, 2, 4, 2)))).warnings;
    ASSERT_THAT(warnings, SizeIs(1)) << layer;
    EXPECT_THAT(warnings[0].text(), HasSubstr("d.dxf:37: warning: the layer \""));
    EXPECT_THAT(warnings[0].text(), HasSubstr("is not used; expected \"section\", \"joints\", \"joints NAME\" or"));
  }
  const ReadScene other = read(scene(drawing(square + held + line("axis", 0, 2, 4, 2) + line("0", 0, 1, 4, 1))));
  EXPECT_TRUE(other.warnings.empty());
  ASSERT_FALSE(other.notes.empty());
  EXPECT_THAT(other.notes[0].text(), HasSubstr("layers that are not used: \"0\", \"axis\""));
}

TEST_F(Drawing, UnitsAreMetresUnlessSaid) {
  const Scene s =
      read(scene(drawing(square + entity("POINT", "supports", point(0, 0))), "", "dxf_unit_m = 0.5\n")).scene;
  EXPECT_EQ(geometry::signed_area(s.blocks[0].vertices), 4);
}

TEST_F(Drawing, KeysBesideItAreChecked) {
  for (const std::string wrong :
       {"dxf_unit_m = -1\n", "dxf_unit_m = \"mm\"\n", "outline_m = [[0, 0], [1, 0], [0, 1]]\n"}) {
    EXPECT_THAT(error(scene(drawing(square), "", wrong)), HasSubstr("is not the path of a drawing alone")) << wrong;
  }
  const auto file = write("n.toml", "[analysis]\nduration_s = 1\n[section]\ndxf = 7\n");
  EXPECT_THAT(error(file), HasSubstr("n.toml:4: error: dxf in [section] is not the path"));
}

TEST_F(Drawing, LinesOfOneLayerShareItsNameAndAddTheirBlocks) {
  const Scene s = read(scene(drawing(square + line("joints", 0, 1, 4, 1) + line("joints", 0, 3, 4, 3) +
                                     entity("POINT", "supports", point(1, 0)))))
                      .scene;
  ASSERT_THAT(s.joints, SizeIs(2));
  EXPECT_EQ(s.joints[0].name, "joint, s1 and s2");
  EXPECT_EQ(s.joints[1].name, "joint, s2 and s3");
}

TEST_F(Drawing, ThatDoesNotServeIsRefused) {
  EXPECT_THAT(error(scene(drawing(line("joints", 0, 0, 1, 1)))), HasSubstr("no closed line on the layer \"section\""));
  EXPECT_THAT(error(scene(drawing(line("section", 0, 0, 1, 1)))), HasSubstr("no closed line on the layer \"section\""));
  EXPECT_THAT(error(scene("not a drawing\n\n")),
              HasSubstr("d.dxf:1: error: found \"not a drawing\" as a group code; expected a whole number"));
  EXPECT_THAT(error(scene(drawing(""))), HasSubstr("scene.toml:9: error: the drawing d.dxf: it holds no line"));
  EXPECT_THAT(error(scene(drawing(square + entity("POINT", "supports", point(9, 9))))),
              HasSubstr("no block of the section has the point (9, 9)"));
  static_cast<void>(scene(drawing(square)));
  std::filesystem::remove(folder_ / "d.dxf");
  EXPECT_THAT(error(folder_), HasSubstr("the drawing d.dxf: it cannot be read; expected a DXF file"));
}

std::string spoiled(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.rfind(from), from.size(), to);
}

TEST_F(Drawing, ThatIsDamagedIsRefusedWithTheLineOfTheDrawing) {
  const std::string sound = drawing(square + line("joints", 0, 2, 4, 2) + entity("POINT", "supports", point(1, 0)));
  const std::vector<std::array<std::string, 3>> faults = {
      {"4.000000", "4x0", "d.dxf:38: error: found \"4x0\" after the group code 11; expected a finite number"},
      {"4.000000", "nan", "found \"nan\" after the group code 11; expected a finite number; export the drawing again"},
      {"4.000000", "1e999", "found \"1e999\" after the group code 11"},
      {"11\n4.000000\n", "", "d.dxf:29: error: found LINE without the group code 11; expected all its coordinates"},
      {"90\n4", "90\n5", "d.dxf:5: error: found LWPOLYLINE of 5 points with 4 x and 4 y"},
      {"90\n4", "90\nfour", "found \"four\" after the group code 90; expected a whole number"},
      {"EOF\n", "", "found the end of the file in or after \"ENDSEC\" at line 49; expected ENDSEC and EOF"},
      {"0\nENDSEC\n", "", "d.dxf:49: error: found EOF after a section that has not ended; expected ENDSEC before it"},
  };
  for (const auto& [from, to, told] : faults) EXPECT_THAT(error(scene(spoiled(sound, from, to))), HasSubstr(told));
  EXPECT_THAT(error(scene("AutoCAD Binary DXF\r\n\x1a")), HasSubstr("found a binary drawing; expected one of text"));
}

}  // namespace
}  // namespace blockweir::scene_drawing_test
