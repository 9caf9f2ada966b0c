// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/static_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <limits>

#include "solid/capacity/fresh_level.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/watch/slipped_body.hpp"

namespace blockweir::solid {
namespace {

class LevelSearch {
 public:
  LevelSearch(const scene::Scene& scene, StillWater& water, double width, const LevelClues& clues)
      : scene_(scene),
        water_(water),
        full_m_(water.range().full_m),
        range_m_(full_m_ - water.range().empty_m),
        width_m_(width * range_m_),
        rests_m_(water.range().empty_m),
        clues_(clues),
        blocks_(scene, &water, effort_) {}

  StaticLevel found() {
    tell("nothing known yet");
    if (!rests_empty()) return {.level_m = rests_m_};
    StaticLevel found = after_a_rise();
    if (found.stopped.empty()) look_without_history(found);
    return found;
  }

 private:
  void tell(const std::string& known) {
    effort_.knows(known + (clues_.limit_m ? fmt::format("; limit analysis fails at {:.9g} m", *clues_.limit_m) : ""));
  }

  bool rests_empty() {
    effort_.allow(clues_.falls_as_drawn ? most_systems : LONG_MAX);
    try {
      const bool rests = blocks_.begin(rests_m_);
      effort_.allow(LONG_MAX);
      if (rests || clues_.falls_as_drawn || blocks_.went_far()) return rests;
    } catch (const Undecided&) {
      return false;
    }
    throw std::runtime_error(
        "level by the blocks: no equilibrium was found under the empty reservoir, and no block had gone as far as "
        "a failure; expected one of both; run the scene and look at its motion");
  }

  StaticLevel after_a_rise() {
    resting_ = blocks_.state();
    StaticLevel found;
    try {
      do {
        narrow();
      } while (has_bracket() && stands_beyond(found));
      blocks_.restore(resting_);
      found.warnings = blocks_.warnings(rests_m_);
    } catch (const TookTooLong& stopped) {
      if (!has_bracket() && rests_m_ < full_m_) throw;
      if (fails_m_ - rests_m_ > width_m_) found.stopped = stopped.what();
    }
    found.settles_m = settles_m_;
    found.outcome = has_bracket() ? limit::Filled::fails : limit::Filled::stands_full;
    found.level_m = has_bracket() ? (rests_m_ + fails_m_) / 2 : full_m_;
    found.width_m = has_bracket() ? fails_m_ - rests_m_ : 0;
    return found;
  }

  /// Just below the levels, so that a level which does not depend on the history costs an analysis.
  void look_without_history(StaticLevel& found) {
    constexpr double below = 1e-3;
    const double empty_m = water_.range().empty_m;
    const auto just_below = [&](double level_m) { return level_m - below * (level_m - empty_m); };
    const bool fails = found.outcome == limit::Filled::fails;
    std::vector<double> levels = {fails ? std::min(rests_m_, just_below(found.level_m)) : full_m_};
    if (clues_.suspect_m && *clues_.suspect_m < found.level_m) levels.push_back(just_below(*clues_.suspect_m));
    std::optional<FreshLevel> fresh;
    try {
      fresh = fresh_level(scene_, water_, effort_, empty_m, levels);
    } catch (const TookTooLong& stopped) {
      found.stopped = stopped.what();
    }
    if (!fresh) return;
    found.slow_rise = {found.outcome, found.level_m};
    found.outcome = limit::Filled::fails;
    found.level_m = (fresh->stands_m + fresh->fails_m) / 2;
    found.width_m = fresh->fails_m - fresh->stands_m;
    found.failure = fresh->failure;
    found.stopped = fresh->stopped;
    found.warnings = fresh->warnings;
  }

  [[nodiscard]] bool has_bracket() const { return fails_m_ <= full_m_; }

  /// No top of a structure is passed: above it stands in water on both sides, which may hold it up.
  [[nodiscard]] double next_rise() const {
    constexpr int rises = 20;
    const std::vector<double>& tops_m = water_.range().lower_tops_m;
    const auto top = std::upper_bound(tops_m.begin(), tops_m.end(), rests_m_);
    return std::min(top == tops_m.end() ? full_m_ : *top, rests_m_ + range_m_ / rises);
  }

  void narrow() {
    while (rests_m_ < full_m_ && fails_m_ - rests_m_ > width_m_) {
      tell(fmt::format("rests at {:.9g} m", rests_m_) +
           (has_bracket() ? fmt::format(", fails at {:.9g} m", fails_m_) : ""));
      const double next_m = has_bracket() ? (rests_m_ + fails_m_) / 2 : next_rise();
      if (next_m <= rests_m_ || next_m >= fails_m_) break;
      // Pure strain moves less under a small rise, and slip need not be followed as far.
      const double share = std::min(1.0, followed_ * std::max(1e-6, (next_m - rests_m_) / range_m_));
      if (!blocks_.must_move(next_m) && blocks_.rests_at(next_m, share)) {
        rest_at(next_m);
      } else {
        fails_m_ = next_m;
        blocks_.restore(resting_);
      }
    }
  }

  void rest_at(double level_m) {
    rests_m_ = level_m;
    resting_ = blocks_.state();
  }

  /// Follows the blocks all the way: a small slip that comes to rest is no failure, and the search continues from there
  /// with a wider bracket. Otherwise reports how they fail.
  bool stands_beyond(StaticLevel& found) {
    constexpr double seen = 1e-4;  // beyond the level, so that how the blocks fail is seen
    const double beyond_m = fails_m_ + seen * range_m_;
    blocks_.restore(resting_);
    FailureWatch watch(blocks_.solid());
    watch.look(0, blocks_.levels(rests_m_));
    const bool must_move = blocks_.must_move(beyond_m);
    if (comes_to_rest(beyond_m, must_move)) {
      if (!settles_m_) settles_m_ = rests_m_;
      rest_at(beyond_m);
      fails_m_ = unknown;
      followed_ *= 100;
      width_m_ = std::max(width_m_, settled_width * range_m_);
      return true;
    }
    watch.look(1, blocks_.levels(beyond_m));
    if (!watch.failures().empty()) found.failure = watch.failures().front();
    if (found.failure) return false;
    found.slips_add_up = blocks_.slipped_away();
    if (blocks_.went_far()) {
      found.failure = slipped_body(blocks_.solid(), beyond_m);
    } else if (!must_move) {
      throw std::runtime_error(fmt::format(
          "level by the blocks: they rest up to {:.9g} m; at {:.9g} m no equilibrium was found, and no block "
          "had gone as far as a failure; expected one of both; run the scene at that level and look at its motion",
          rests_m_, beyond_m));
    }
    return false;
  }

  /// What must move may do so for minutes: its level is known then, and only its mode is not.
  bool comes_to_rest(double level_m, bool must_move) {
    if (!must_move) return blocks_.rests_at(level_m, 1);
    try {
      effort_.allow(most_systems);
      const bool rests = blocks_.rests_at(level_m, 1);
      effort_.allow(LONG_MAX);
      return rests;
    } catch (const Undecided&) {
      effort_.allow(LONG_MAX);
      return false;
    }
  }

  static constexpr double unknown = std::numeric_limits<double>::infinity();
  /// Of blocks that no forces hold, by limit analysis under the empty reservoir or by Farkas' lemma: at rest by then,
  /// they have moved until faces touch, or wedge each other. The others creep for minutes.
  static constexpr long most_systems = 2000;
  static constexpr double settled_width = 1e-6;  // each level past the bracket takes a slip of the whole way

  const scene::Scene& scene_;
  StillWater& water_;
  double full_m_;
  double range_m_;
  double width_m_;
  double rests_m_;
  double fails_m_ = unknown;
  std::string resting_;  ///< the blocks at rests_m_
  LevelClues clues_;
  SearchBudget effort_{clues_.whose};
  StaticBlocks blocks_;
  std::optional<double> settles_m_;
  double followed_ = 10;  ///< displacement within which blocks may come to rest, over failure's, for each share of the
                          ///< range
};

}  // namespace

StaticLevel static_level(const scene::Scene& scene, StillWater& water, double width, const LevelClues& clues) {
  return LevelSearch(scene, water, width, clues).found();
}

}  // namespace blockweir::solid
