// SPDX-License-Identifier: GPL-3.0-or-later
// How far a structure that stands is from sliding and from overturning, by the forces on the surfaces that run through.
#pragma once

#include <optional>
#include <string>

#include "solid/step/solid.hpp"
#include "solid/watch/surfaces.hpp"

namespace blockweir::solid {

/// The worst that a surface came to.
struct Margin {
  double value = 0;
  double time_s = 0;
  double level_m = 0;   ///< NaN without a pool
  std::string joint;    ///< or joints in one line
  std::string end;      ///< of a resultant: the nearer end, "upstream", "downstream" ("left", "right" without water),
                        ///< "lower", "upper"
  std::string held_by;  ///< of a resultant at an end or beyond it: "tension strength", "an anchor", both, or unknown

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value, time_s, level_m, joint, end, held_by);
  }
};

class Margins {
 public:
  /// Looks at the state at `time_s`, reached under this level of the higher pool.
  void look(const Solid& solid, double time_s, double level_m);

  /// Lowest ratio of shear strength to shear force. None where no surface carries shear, or all that do are buttressed.
  [[nodiscard]] const std::optional<Margin>& sliding() const { return sliding_; }
  /// That of the last look, of any surface. None likewise.
  [[nodiscard]] const std::optional<Margin>& sliding_now() const { return sliding_now_; }
  /// Shortest way of the normal forces' resultant to an end of its surface, over the surface's length: 1/2 in the
  /// middle, 0 where the block overturns. None without surfaces.
  [[nodiscard]] const std::optional<Margin>& overturning() const { return overturning_; }
  /// Some surface that carried shear had a face before it that resisted the slide, as ground before a toe: its own
  /// strength over that shear is no factor of safety.
  [[nodiscard]] bool buttressed() const { return buttressed_; }
  /// Some surface runs through.
  [[nodiscard]] bool any_surface() const { return surfaces_ && !surfaces_->names().empty(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(surfaces_, sliding_, sliding_now_, overturning_, buttressed_);
  }

 private:
  std::optional<Surfaces> surfaces_;  ///< of the first look
  std::optional<Margin> sliding_;
  std::optional<Margin> sliding_now_;
  std::optional<Margin> overturning_;
  bool buttressed_ = false;
};

}  // namespace blockweir::solid
