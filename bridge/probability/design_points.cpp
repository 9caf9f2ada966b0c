// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/probability/design_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <openturns/AbdoRackwitz.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/Exception.hxx>
#include <openturns/FORM.hxx>
#include <openturns/Less.hxx>
#include <openturns/Normal.hxx>

namespace blockweir::probability {
namespace {

constexpr double nearest_ring = 8;       // in deviations: what is beyond has P < 1e-15
constexpr double farthest_ring = 38;     // and beyond this no number
constexpr double worst_residual = 0.01;  // in units of the value, m of a level

OT::AbdoRackwitz nearest_point() {
  constexpr unsigned most_iterations = 100;
  OT::AbdoRackwitz algorithm;
  algorithm.setMaximumIterationNumber(most_iterations);
  algorithm.setMaximumAbsoluteError(1e-8);
  algorithm.setMaximumRelativeError(1e-8);
  algorithm.setMaximumResidualError(1e-8);
  algorithm.setMaximumConstraintError(1e-8);
  return algorithm;
}

bool ends_on_level_ground(const OT::Exception& error) {
  return std::string(error.what()).find("gradient of the level function is zero") != std::string::npos;
}

class Search {
 public:
  explicit Search(const StandardState& state)
      : state_(state), event_(state.event(OT::Less())), origin_(state.dimension()) {
    const double at_means = state.value(origin_);
    if (std::isnan(at_means)) throw Unanswered(state.physical(origin_));
    means_fail_ = at_means < state.threshold();
  }

  DesignPoints find() {
    from(origin_);
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds && reach_ < farthest_ring; ++round) {
      bool more = false;
      for (const OT::Point& start : starts()) more = from(start) || more;
      if (more) continue;
      if (!found_.empty() && radius() < reach_) break;
      reach_ *= 2;
    }
    if (found_.empty()) {
      state_.value(origin_);  // the last that was asked for is where the trouble is
      std::rethrow_exception(trouble_);
    }
    return {.all = likeliest(), .means_fail = means_fail_};
  }

 private:
  /// Does the search find a point that is new?
  bool from(const OT::Point& start) {
    try {
      OT::FORM analysis(nearest_point(), event_, start);
      analysis.run();
      const OT::FORMResult result = analysis.getResult();
      const OT::Point point = result.getStandardSpaceDesignPoint();
      const double residual = state_.value(point) - state_.threshold();
      if (!(std::abs(residual) <= worst_residual)) {
        throw std::runtime_error(fmt::format(
            "the search for the design point ended at a level {:.2g} m off that which is asked for; expected one "
            "within {} m; state methods = [\"subset\"], which needs no such point",
            std::abs(residual), worst_residual));
      }
      return is_new({.standard = point,
                     .index = (means_fail_ ? -1 : 1) * point.norm(),
                     .residual = residual,
                     .iterations = static_cast<unsigned>(result.getOptimizationResult().getIterationNumber())});
    } catch (const OT::Exception& error) {
      const bool level = ends_on_level_ground(error);
      note(level ? std::make_exception_ptr(std::runtime_error(
                       "the search for the design point reached a point at which no variable changes the level; "
                       "expected one at which they do; state methods = [\"subset\"], which needs no such point"))
                 : std::current_exception());
    } catch (const std::runtime_error&) {
      note(std::current_exception());
    }
    return false;
  }
  /// The reason that is told is that of the search from the means, the first.
  void note(const std::exception_ptr& trouble) {
    if (!trouble_) trouble_ = trouble;
  }

  bool is_new(DesignPoint point) {
    constexpr double same = 0.1;
    for (DesignPoint& known : found_) {
      if ((known.standard - point.standard).norm() > same) continue;
      if (point.standard.norm() < known.standard.norm()) known = std::move(point);
      return false;
    }
    found_.push_back(std::move(point));
    std::sort(found_.begin(), found_.end(),
              [](const auto& a, const auto& b) { return a.standard.norm() < b.standard.norm(); });
    return true;
  }

  /// On the other side of the threshold than the means; a point without value is not.
  [[nodiscard]] bool across(double value) const {
    return means_fail_ ? value >= state_.threshold() : value < state_.threshold();
  }

  /// Behind the plane of a design point, more or less?
  [[nodiscard]] bool explained(const OT::Point& at) const {
    constexpr double nearly = 0.98;
    return std::any_of(found_.begin(), found_.end(),
                       [&](const DesignPoint& d) { return at.dot(d.standard) > nearly * d.standard.normSquare(); });
  }

  /// Both ways along each axis and along each diagonal of two, as a joint's friction and cohesion, and all ways.
  [[nodiscard]] OT::Sample directions() const {
    constexpr unsigned of_all = 64;
    OT::Sample all = OT::Normal(state_.dimension()).getSample(of_all);
    for (OT::UnsignedInteger axis = 0; axis < state_.dimension(); ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        OT::Point at(state_.dimension());
        at[axis] = sign;
        all.add(at);
        for (OT::UnsignedInteger other = 0; other < axis; ++other) {
          for (at[other] = -1; at[other] < 2; at[other] += 2) all.add(at);
          at[other] = 0;
        }
      }
    }
    for (OT::UnsignedInteger i = 0; i < all.getSize(); ++i) all[i] = OT::Point(all[i]).normalize();
    return all;
  }

  /// A bit beyond the nearest design point, as far as looked so far.
  [[nodiscard]] double radius() const {
    constexpr double beyond = 1;
    return found_.empty() ? reach_ : std::min(reach_, found_.front().standard.norm() + beyond);
  }

  /// At this radius in all directions; less far where the function has no value.
  void look_around(OT::Sample& points, OT::Sample& values) const {
    constexpr double nearer_by = 0.75;
    constexpr int most_shortenings = 8;
    points = directions();
    points *= radius();
    values = state_.values(points);
    for (int i = 0; i < most_shortenings; ++i) {
      OT::Sample nearer(0, state_.dimension());
      std::vector<OT::UnsignedInteger> which;
      for (OT::UnsignedInteger k = 0; k < points.getSize(); ++k) {
        if (!std::isnan(values(k, 0))) continue;
        which.push_back(k);
        points[k] = OT::Point(points[k]) * nearer_by;
        nearer.add(points[k]);
      }
      if (which.empty()) return;
      const OT::Sample again = state_.values(nearer);
      for (std::size_t k = 0; k < which.size(); ++k) values(which[k], 0) = again(k, 0);
    }
  }

  /// Points at the threshold towards what fails and has no explanation; few, and far from each other.
  [[nodiscard]] std::vector<OT::Point> starts() const {
    constexpr std::size_t most = 4;
    constexpr double apart = 0.7;  // cosine
    OT::Sample points(0, state_.dimension());
    OT::Sample values(0, 1);
    look_around(points, values);
    std::vector<OT::UnsignedInteger> order;
    for (OT::UnsignedInteger k = 0; k < points.getSize(); ++k) {
      if (across(values(k, 0)) && !explained(points[k])) order.push_back(k);
    }
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      return std::abs(values(a, 0) - state_.threshold()) > std::abs(values(b, 0) - state_.threshold());
    });
    std::vector<OT::Point> chosen;
    for (const OT::UnsignedInteger k : order) {
      const OT::Point at = points[k];
      const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const OT::Point& other) {
        return at.dot(other) > apart * at.norm() * other.norm();
      });
      if (!near && chosen.size() < most) chosen.push_back(at);
    }
    for (OT::Point& start : chosen) start = at_threshold(start);
    return chosen;
  }

  /// Where the way from the means to a point crosses the threshold.
  [[nodiscard]] OT::Point at_threshold(const OT::Point& beyond) const {
    constexpr int bisections = 8;
    double inside = 0;
    double outside = 1;
    for (int i = 0; i < bisections; ++i) {
      const double middle = (inside + outside) / 2;
      (across(state_.value(middle * beyond)) ? outside : inside) = middle;
    }
    return outside * beyond;
  }

  [[nodiscard]] std::vector<DesignPoint> likeliest() const {
    constexpr double too_rare = 1e-3;
    std::vector<DesignPoint> all;
    const double least = OT::DistFunc::pNormal(found_.front().standard.norm(), true);
    for (const DesignPoint& point : found_) {
      if (all.empty() || OT::DistFunc::pNormal(point.standard.norm(), true) > too_rare * least) all.push_back(point);
    }
    return all;
  }

  const StandardState& state_;
  OT::ThresholdEvent event_;
  OT::Point origin_;
  bool means_fail_ = false;
  double reach_ = nearest_ring;
  std::vector<DesignPoint> found_;  ///< the nearest first
  std::exception_ptr trouble_;
};

}  // namespace

DesignPoints design_points(const StandardState& state) {
  return Search(state).find();
}

}  // namespace blockweir::probability
