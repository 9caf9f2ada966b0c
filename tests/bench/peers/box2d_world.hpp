// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in Box2D 2.4.
#pragma once

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::peers {

constexpr int iterations = 16;  ///< of velocities and of positions

inline b2Vec2 vec(const scene::Point& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

struct Box2dWorld {
  std::unique_ptr<b2World> world;
  std::vector<b2Body*> bodies;         ///< of the scene's blocks
  std::vector<scene::Point> centroid;  ///< of them, in the scene [m]
};

inline double cross(const scene::Point& a, const scene::Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Area [m2] and centroid [m] of a convex outline.
inline std::pair<double, scene::Point> area_and_centroid(const std::vector<scene::Point>& outline) {
  double area = 0;
  scene::Point moment = scene::Point::Zero();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const double part = cross(outline[i] - outline[0], outline[i + 1] - outline[0]) / 2;
    area += part;
    moment += part * (outline[0] + outline[i] + outline[i + 1]) / 3;
  }
  return {area, moment / area};
}

/// Box2D keeps shapes a skin apart: each side is moved in by it, so that skins touch where the scene's blocks do, and
/// the density is raised.
inline std::vector<scene::Point> without_skin(const std::vector<scene::Point>& outline) {
  const std::size_t n = outline.size();
  const double skin = static_cast<double>(b2_polygonRadius);
  std::vector<scene::Point> shrunk;
  for (std::size_t i = 0; i < n; ++i) {
    const scene::Point before = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const scene::Point after = (outline[(i + 1) % n] - outline[i]).normalized();
    // Where both sides, moved in by the skin, meet: inward normals are the directions turned to the left.
    shrunk.push_back(outline[i] + skin / cross(before, after) * (after - before));
  }
  return shrunk;
}

inline Box2dWorld box2d_world(const scene::Scene& scene, bool sleep) {
  Box2dWorld made{std::make_unique<b2World>(vec(scene.analysis.gravity())), {}, {}};
  made.world->SetAllowSleeping(sleep);
  const double friction = std::tan(scene.default_joint.friction_angle_deg * std::numbers::pi / 180);
  for (const scene::Block& block : scene.blocks) {
    const auto [area, centroid] = area_and_centroid(block.vertices);
    const std::vector<scene::Point> shrunk = without_skin(block.vertices);
    b2BodyDef body;
    body.type = block.fixed ? b2_staticBody : b2_dynamicBody;
    body.position = vec(centroid);
    std::vector<b2Vec2> corners;
    for (const scene::Point& p : shrunk) corners.push_back(vec(p - centroid));
    b2PolygonShape shape;
    shape.Set(corners.data(), static_cast<int>(corners.size()));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    const double density = scene.materials[static_cast<std::size_t>(block.material)].density_kg_per_m3;
    fixture.density = static_cast<float>(density * area / area_and_centroid(shrunk).first);
    fixture.friction = static_cast<float>(friction);
    made.bodies.push_back(made.world->CreateBody(&body));
    made.bodies.back()->CreateFixture(&fixture);
    made.centroid.push_back(centroid);
  }
  return made;
}

}  // namespace blockweir::peers
