// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// An outline that reaches beyond a picture is cut off at the picture's edge, not bent to it.
#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "bridge/picture/gnuplot.hpp"

namespace blockweir::picture::gnuplot_polygon_test {
namespace {

using Point = Eigen::Vector2d;

std::vector<Point> points_in(const std::string& script) {
  std::vector<Point> points;
  const std::regex point("(?:from|to) ([^, ]+),([^ ]+)");
  for (std::sregex_iterator p(script.begin(), script.end(), point), end; p != end; ++p) {
    points.emplace_back(std::stod((*p)[1]), std::stod((*p)[2]));
  }
  return points;
}

/// How far it lies to the right of an edge of a counter-clockwise outline; negative inside.
double outside(const std::vector<Point>& outline, const Point& p) {
  double most = -1e300;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point edge = (outline[(i + 1) % outline.size()] - outline[i]).normalized();
    most = std::max(most, edge.y() * (p - outline[i]).x() - edge.x() * (p - outline[i]).y());
  }
  return most;
}

TEST(GnuplotPolygon, OfAnyTriangleShowsNothingThatLiesOutsideOfIt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-30, 30);
  const View view{-4, 13, -6, 16};
  const std::vector<Point> window{{-4, -6}, {13, -6}, {13, 16}, {-4, 16}};
  int number = 0;
  int shown = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Point> triangle;
    for (int i = 0; i < 3; ++i) triangle.emplace_back(place(random), place(random));
    const Point a = triangle[1] - triangle[0];
    const Point b = triangle[2] - triangle[0];
    if (a.x() * b.y() - a.y() * b.x() < 0) std::swap(triangle[1], triangle[2]);
    const std::vector<Point> drawn = points_in(gnuplot_polygon(number, triangle, view, "fs empty"));
    shown += drawn.empty() ? 0 : 1;
    for (const Point& p : drawn) {
      EXPECT_LE(outside(triangle, p), 1e-4) << "trial " << trial << ": " << p.transpose();
      EXPECT_LE(outside(window, p), 1e-4) << "trial " << trial << ": " << p.transpose();
    }
  }
  EXPECT_EQ(number, shown);  // each is one piece
  EXPECT_GT(shown, 300);
}

TEST(GnuplotPolygon, InViewIsDrawnAsItIs) {
  int number = 6;
  EXPECT_EQ(gnuplot_polygon(number, {{0, 0}, {1, 0}, {0, 2}}, {-1, 2, -1, 2}, "fs empty"),
            "set object 7 polygon from 0,0 to 1,0 to 0,2 to 0,0 fs empty\n");
  EXPECT_EQ(number, 7);
}

}  // namespace
}  // namespace blockweir::picture::gnuplot_polygon_test
