// SPDX-License-Identifier: GPL-3.0-or-later
// Where contact forces are unknowns of the system: what they fulfil.
#pragma once

#include <span>

#include "solid/contact/contact_point.hpp"
#include "solid/contact/interaction.hpp"
#include "solid/contact/support.hpp"

namespace blockweir::solid {

class ForceConstraints {
 public:
  virtual ~ForceConstraints() = default;

  /// As the formulation has evaluated the contact or support last.
  [[nodiscard]] virtual std::span<const Constraint> of_contact(int index) const = 0;
  [[nodiscard]] virtual std::span<const Constraint> of_support(int index) const = 0;
  /// By what has been solved for.
  virtual void correct(ContactPoint& point, const Eigen::Vector2d& force) const = 0;
  virtual void correct(Support& point, const Eigen::Vector2d& force) const = 0;
};

}  // namespace blockweir::solid
