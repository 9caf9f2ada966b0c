// SPDX-License-Identifier: GPL-3.0-or-later
// The highest Reynolds number of the flow in joints: the cubic law holds while the flow is laminar.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::joints {

class Turbulence {
 public:
  /// Not after a breach: what has fallen leaves wide gaps, and the pressures of still water no longer apply.
  void look(const wire::Load& load, double time_s, double reynolds_number, const std::string& joint);
  /// Where the number is too high, with the level of that moment; with its time where the level stands still. Empty:
  /// nowhere.
  [[nodiscard]] std::string warning(const scene::Scene& scene) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(highest_, joint_, time_s_, level_m_, breached_);
  }

 private:
  double highest_ = 0;
  std::string joint_;
  double time_s_ = 0;
  double level_m_ = 0;
  bool breached_ = false;
};

}  // namespace blockweir::joints
