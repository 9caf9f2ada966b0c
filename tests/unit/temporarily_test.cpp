// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Values that are others until a scope ends.
#include "solid/step/temporarily.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace blockweir::solid::temporarily_test {
namespace {

TEST(Temporarily, AValueIsWhatItWasOnceTheScopeEnds) {
  double ratio = 1e4;
  {
    const Temporarily softer(ratio, 1e2);
    EXPECT_EQ(ratio, 1e2);
    const Temporarily softest(ratio, 1.0);
    EXPECT_EQ(ratio, 1.0);
  }
  EXPECT_EQ(ratio, 1e4);
}

TEST(Temporarily, AnExceptionPutsItBackAsWell) {
  bool lags = false;
  const auto fail = [&] {
    const Temporarily on(lags, true);
    throw std::runtime_error("no states");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_FALSE(lags);
}

TEST(Temporarily, TwoThatTradePlacesKeepWhatHappensToThemMeanwhile) {
  auto own = std::make_unique<int>(1);
  auto substitute = std::make_unique<int>(2);
  {
    const TradePlaces stands_in(own, substitute);
    EXPECT_EQ(*own, 2);
    *own = 3;
  }
  EXPECT_EQ(*own, 1);
  EXPECT_EQ(*substitute, 3);
}

}  // namespace
}  // namespace blockweir::solid::temporarily_test
