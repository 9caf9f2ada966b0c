// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// Stresses of the gravity method on one face by its formulas, and on faces beside galleries by equilibrium.
#include "solid/watch/linear_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace blockweir::solid::linear_stress_test {
namespace {

constexpr double normal = 1e6;

TEST(LinearStress, OfOneFaceIsThatOfTheFormula) {
  const std::vector<FaceStretch> face{{0, 12}};
  const LinearStress inside = linear_stress(face, normal, 12 * 0.6);  // r = 0.4 from the downstream end
  EXPECT_NEAR(inside.upstream_pa, normal / 12 * (1 - 0.6), 1e-6);
  EXPECT_NEAR(inside.downstream_pa, normal / 12 * (1 + 0.6), 1e-6);
  EXPECT_EQ(inside.open_m, 0);
  const LinearStress beyond = linear_stress(face, normal, 12 * 0.8);  // presses on 3 r L = 7.2 m
  EXPECT_EQ(beyond.upstream_pa, 0);
  EXPECT_NEAR(beyond.downstream_pa, 2 * normal / 7.2, 1e-6);
  EXPECT_NEAR(beyond.open_m, 4.8, 1e-9);
  const LinearStress upstream = linear_stress(face, normal, 12 * 0.2);
  EXPECT_NEAR(upstream.upstream_pa, 2 * normal / 7.2, 1e-6);
  EXPECT_NEAR(upstream.open_m, 4.8, 1e-9);
}

TEST(LinearStress, OfAForceBeyondTheEndLeavesAllOpen) {
  const LinearStress none = linear_stress({{0, 3}, {5, 12}}, normal, 12.5);
  EXPECT_EQ(none.downstream_pa, 0);
  EXPECT_NEAR(none.open_m, 10, 1e-12);
}

/// Force and lever of the line between its ends, without tension, on the faces alone.
TEST(LinearStress, BesideGalleriesBalancesTheForceAndItsPlace) {
  std::mt19937 random(5);
  const auto between = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
  for (int n = 0; n < 300; ++n) {
    std::vector<FaceStretch> faces;
    double end = 0;
    for (int i = 0; i < 2 + n % 3; ++i) {
      const double from = end + (i == 0 ? 0 : between(0.1, 3));
      end = from + between(0.5, 20);
      faces.push_back({from, end});
    }
    const double place = end * between(0.02, 0.98);
    const LinearStress found = linear_stress(faces, normal, place);
    const bool opens_upstream = found.upstream_pa == 0;
    const bool opens_downstream = found.downstream_pa == 0;
    // Where its zero is follows from what is open.
    double zero = opens_upstream ? 0 : end;
    double open = found.open_m;
    if (opens_upstream) {
      for (const FaceStretch& face : faces) {
        if (open <= 0) break;
        zero = face.from_m + std::min(open, face.to_m - face.from_m);
        open -= face.to_m - face.from_m;
      }
    } else {
      for (auto face = faces.rbegin(); face != faces.rend() && open > 0; ++face) {
        zero = face->to_m - std::min(open, face->to_m - face->from_m);
        open -= face->to_m - face->from_m;
      }
    }
    const auto stress = [&](double x) {
      if (opens_upstream) return std::max(0.0, found.downstream_pa * (x - zero) / (end - zero));
      if (opens_downstream) return std::max(0.0, found.upstream_pa * (zero - x) / zero);
      return found.upstream_pa + (found.downstream_pa - found.upstream_pa) * x / end;
    };
    double force = 0;
    double moment = 0;
    for (const FaceStretch& face : faces) {  // Simpson's rule, exact for stress times place
      const double from = opens_upstream ? std::max(face.from_m, zero) : face.from_m;
      const double to = opens_downstream ? std::min(face.to_m, zero) : face.to_m;
      if (from >= to) continue;
      for (const auto& [x, weight] : {std::pair(from, 1.0), std::pair((from + to) / 2, 4.0), std::pair(to, 1.0)}) {
        force += stress(x) * weight / 6 * (to - from);
        moment += stress(x) * x * weight / 6 * (to - from);
      }
    }
    const bool ends_at_a_void =
        found.open_m > 0 && std::any_of(faces.begin(), faces.end(), [&](const FaceStretch& face) {
          return std::min(std::abs(zero - face.from_m), std::abs(zero - face.to_m)) < 1e-6;
        });
    if (ends_at_a_void) continue;  // the zero is somewhere in the void then
    EXPECT_NEAR(force / normal, 1, 1e-6) << n;
    EXPECT_NEAR(moment / force / end, place / end, 1e-6) << n;
  }
}

TEST(LinearStress, StretchesThatTouchAreOne) {
  const std::vector<FaceStretch> faces = joined({{5, 9}, {0, 1.5}, {1.5, 3}, {8, 30}}, 1e-4);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].to_m, 3);
  EXPECT_EQ(faces[1].from_m, 5);
  EXPECT_EQ(faces[1].to_m, 30);
}

}  // namespace
}  // namespace blockweir::solid::linear_stress_test
