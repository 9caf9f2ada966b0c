// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of the coming window's end, so that blocks and water with sound make the window as one step.
//
// a_n is the blocks' acceleration at the end of window n; its mean in the window is (1 - gamma) a_n-1 + gamma a_n. From
// rest, a unit of it for one window causes P at the window's end; q is the pressure there without any, by the past
// alone. So the pressure after the next window is
//
//     p_n+1 = q + P ((1 - gamma) a_n + gamma a_n+1)
//
// The solid knows a_n+1, the water does not. In the solid's balance (scene::NewmarkWeights) pressures l_n+1 and a mass
// M replace it: (1 - alpha_f) l_n+1 + alpha_f l_n + M ((1 - alpha_m) a_n+1 + alpha_m a_n) is to be the same as (1 -
// alpha_f) p_n+1 + alpha_f p_n. Hence
//
//     M = inertia P,   l_n+1 = q + start P a_n + past (p_n - l_n)
//
// The load is l_n+1 + M a_n, as the added-mass guard takes M a_n away again.
#pragma once

#include "bridge/scene/newmark_weights.hpp"

namespace blockweir::reservoir {

struct WindowAhead {
  double gamma = 1;
  double inertia = 1;
  double start = 0;
  double past = 0;
};

inline WindowAhead window_ahead(const scene::NewmarkWeights& w) {
  return {w.gamma, w.gamma * (1 - w.alpha_f) / (1 - w.alpha_m), 1 - w.gamma - w.gamma * w.alpha_m / (1 - w.alpha_m),
          w.alpha_f / (1 - w.alpha_f)};
}

}  // namespace blockweir::reservoir
