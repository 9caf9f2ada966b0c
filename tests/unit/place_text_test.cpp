// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_geometry
// Places and figures in texts.
#include "bridge/geometry/place_text.hpp"

#include <gtest/gtest.h>

namespace blockweir::geometry::place_text_test {
namespace {

TEST(PlaceText, RoundOffIsZero) {
  EXPECT_EQ(place_text({17, -1.03e-05}, 20), "(17, 0)");
  EXPECT_EQ(place_text({3.137e-16, -0.0}, 20), "(0, 0)");
  EXPECT_EQ(place_text({-0.0123, 1234.56}, 20), "(-0.0123, 1234.56)") << "what is seen is told";
  EXPECT_EQ(place_text({512361.25, 1523.7}, 16), "(512361.25, 1523.7)") << "also in national coordinates";
  EXPECT_EQ(place_text({12.3456, 0}, 20), "(12.35, 0)");
}

TEST(PlaceText, AZeroHasNoSign) {
  EXPECT_EQ(without_signed_zero("-0.0"), "0.0");
  EXPECT_EQ(without_signed_zero("-0"), "0");
  EXPECT_EQ(without_signed_zero("-0.1"), "-0.1");
  EXPECT_EQ(without_signed_zero("-"), "-");
}

}  // namespace
}  // namespace blockweir::geometry::place_text_test
