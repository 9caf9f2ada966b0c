// SPDX-License-Identifier: GPL-3.0-or-later
// Where a crack ends on another, both have the same water. Uplift laws, which know a crack's own ends alone, may differ
// there.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/cracks.hpp"
#include "fluid/joints/uplift.hpp"

namespace blockweir::hydrostatic {

class CrackMeetings {
 public:
  /// `cracks` as drawn in the scene.
  CrackMeetings(const scene::Scene& scene, const std::vector<scene::Crack>& cracks);

  /// Records the largest difference so far. `profiles`: pressures along each crack.
  void look(const std::vector<joints::Profile>& profiles);
  /// Empty where pressures differ by less than a tenth of the highest in the two.
  [[nodiscard]] std::string warning() const;

 private:
  struct Meeting {
    std::size_t crack = 0;
    double end_m = 0;  ///< from its mouth
    std::size_t other = 0;
    double on_other_m = 0;  ///< from the other's mouth
    Point place = Point::Zero();
    double pressure_pa = 0;
    double pressure_of_other_pa = 0;
    double highest_pa = 0;  ///< along both

    [[nodiscard]] double share() const;
  };

  void add(const std::vector<scene::Crack>& cracks, std::size_t k, bool mouth);

  const scene::Scene& scene_;
  std::vector<std::string> names_;
  std::vector<Meeting> all_;
};

}  // namespace blockweir::hydrostatic
