// SPDX-License-Identifier: GPL-3.0-or-later
// Margins of a standing structure against sliding and overturning, from the forces on surfaces that run through it.
#pragma once

#include <optional>
#include <string>

#include "solid/step/solid.hpp"
#include "solid/watch/surfaces.hpp"
#include "solid/watch/uplift_in_tension.hpp"

namespace blockweir::solid {

/// The worst value of a surface.
struct Margin {
  double value = 0;
  double time_s = 0;
  double level_m = 0;   ///< NaN without a pool
  std::string joint;    ///< or joints in one line
  std::string end;      ///< of a resultant: the nearer end, "upstream", "downstream" ("left", "right" without water),
                        ///< "lower", "upper"
  std::string held_by;  ///< for a resultant at or beyond an end: "tension strength", "an anchor", both, or unknown

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value, time_s, level_m, joint, end, held_by);
  }
};

class Margins {
 public:
  /// Evaluates the state at `time_s`, reached under these levels.
  void look(const Solid& solid, double time_s, const Levels& levels);

  /// Lowest ratio of shear strength to shear force. None if no surface carries shear, or all that do are buttressed.
  [[nodiscard]] const std::optional<Margin>& sliding() const { return sliding_; }
  /// The same for the last evaluation, of any surface.
  [[nodiscard]] const std::optional<Margin>& sliding_now() const { return sliding_now_; }
  /// Shortest distance of the normal forces' resultant from an end of its surface, over the surface's length: 1/2 in
  /// the middle, 0 if the block overturns. None without surfaces.
  [[nodiscard]] const std::optional<Margin>& overturning() const { return overturning_; }
  /// Whether a surface with shear had a face in front that resisted the slide, such as ground at a toe: its own
  /// strength over that shear is not a factor of safety.
  [[nodiscard]] bool buttressed() const { return buttressed_; }
  /// Whether some surface runs through the structure.
  [[nodiscard]] bool any_surface() const { return surfaces_ && !surfaces_->names().empty(); }

  /// Joints in tension whose uplift takes them to be closed.
  [[nodiscard]] const OpenedJoints& opened() const { return opened_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(surfaces_, opened_, sliding_, sliding_now_, overturning_, buttressed_);
  }

 private:
  std::optional<Surfaces> surfaces_;  ///< of the first evaluation
  OpenedJoints opened_;
  std::optional<Margin> sliding_;
  std::optional<Margin> sliding_now_;
  std::optional<Margin> overturning_;
  bool buttressed_ = false;
};

}  // namespace blockweir::solid
