// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/dxf.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace blockweir::scene {
namespace {

class Listener : public DL_CreationAdapter {
 public:
  explicit Listener(DxfDrawing& drawing) : drawing_(drawing) {}

  void addLine(const DL_LineData& line) override {
    finish();
    if (is_drawn()) drawing_.lines.push_back({layer(), {Point(line.x1, line.y1), Point(line.x2, line.y2)}});
  }
  void addPoint(const DL_PointData& point) override {
    finish();
    if (is_drawn()) drawing_.marks.push_back({layer(), Point(point.x, point.y)});
  }
  void addPolyline(const DL_PolylineData& polyline) override {
    finish();
    if (!is_drawn()) return;
    drawing_.lines.push_back({layer(), {}});
    open_ = true;
    closed_ = (polyline.flags & 1) != 0;
  }
  void addVertex(const DL_VertexData& vertex) override {
    if (open_) drawing_.lines.back().points.emplace_back(vertex.x, vertex.y);
  }
  void addBlock(const DL_BlockData& /*block*/) override { in_block_ = true; }
  void endBlock() override {
    finish();
    in_block_ = false;
  }

  /// Closes the present polyline, if any. Old ones end where the next entity begins: their points come one by one, and
  /// dxflib calls endSection() after each.
  void finish() {
    if (!open_) return;
    open_ = false;
    auto& points = drawing_.lines.back().points;
    if (closed_ && !points.empty()) points.push_back(points.front());
    if (points.size() < 2) drawing_.lines.pop_back();
  }

 private:
  /// What is part of a BLOCK draws nothing by itself, and a sheet of paper has other lengths.
  [[nodiscard]] bool is_drawn() const { return !in_block_ && !attributes.isInPaperSpace(); }
  [[nodiscard]] std::string layer() const {
    std::string name = attributes.getLayer();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name;
  }

  DxfDrawing& drawing_;
  bool open_ = false;
  bool closed_ = false;
  bool in_block_ = false;
};

}  // namespace

DxfDrawing read_dxf(const std::filesystem::path& file) {
  DxfDrawing drawing;
  Listener listener(drawing);
  DL_Dxf reader;
  if (!std::filesystem::is_regular_file(file) || !reader.in(file.string(), &listener)) {
    throw std::runtime_error("it cannot be read");
  }
  listener.finish();
  if (drawing.lines.empty() && drawing.marks.empty()) throw std::runtime_error("it holds no line, polyline or point");
  return drawing;
}

}  // namespace blockweir::scene
