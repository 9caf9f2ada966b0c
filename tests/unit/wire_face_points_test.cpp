// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Points of meshes on faces, in a message of the solid.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/wire_sample.hpp"

namespace blockweir::wire::wire_face_points_test {
namespace {

Motion sample_motion() {
  Motion motion;
  motion.window = 3;
  motion.displacement = {{1, 2, 3, 4, 5, 6}};
  motion.velocity = {{6, 5, 4, 3, 2, 1}};
  motion.face_velocity = {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}};
  motion.face_s = {0, 0.25, 1};
  motion.face_edge = {{0, 0}, {0, 0}, {0, 3}};
  return motion;
}

std::string refusal(const Motion& motion) {
  Motion into;
  try {
    decode(Sent(motion).frame(), into);
  } catch (const BadMessage& bad) {
    return bad.what();
  }
  return "";
}

TEST(FacePoints, ArriveWhereThereAreAny) {
  Motion got;
  decode(Sent(sample_motion()).frame(), got);
  EXPECT_EQ(got.velocity, sample_motion().velocity);
  EXPECT_EQ(got.face_velocity, sample_motion().face_velocity);
  EXPECT_EQ(got.face_s, sample_motion().face_s);
  EXPECT_EQ(got.face_edge, sample_motion().face_edge);
  Motion without = sample_motion();
  without.face_velocity.clear();
  decode(Sent(without).frame(), got);
  EXPECT_TRUE(got.face_velocity.empty() && got.face_s.empty() && got.face_edge.empty());
}

TEST(FacePoints, ThatCannotBeAreRefused) {
  Motion motion = sample_motion();
  motion.face_s = {0, 0.25};
  EXPECT_EQ(refusal(motion), "3 velocities, 2 fractions and 3 edges of points of faces in window 3");
  motion.face_s = {0, 0.25, 1.5};
  EXPECT_EQ(refusal(motion),
            "a velocity that is not finite, or a fraction outside 0 to 1, of a point of a face in window 3");
  motion = sample_motion();
  motion.face_velocity.own()[1][1] = std::nan("");
  EXPECT_EQ(refusal(motion),
            "a velocity that is not finite, or a fraction outside 0 to 1, of a point of a face in window 3");
}

}  // namespace
}  // namespace blockweir::wire::wire_face_points_test
