// SPDX-License-Identifier: GPL-3.0-or-later
// The solid as the schedule sees it, with all that is watched and written on the way.
#pragma once

#include <functional>

#include "bridge/schedule/sides.hpp"
#include "solid/output/frame_log.hpp"
#include "solid/output/history_writer.hpp"
#include "solid/output/summary.hpp"
#include "solid/output/vtk_writer.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

class CoupledSolid final : public schedule::SolidSide {
 public:
  /// Called on the way. `settling` and `solving` are called as steps begin and after each solution of a linear system,
  /// with the number so far of those of the start and of the window at hand; what they throw ends the run.
  struct Progress {
    std::function<void(double time_s, double level_m, double displacement_m)> run;
    std::function<void(long solutions)> settling;
    std::function<void(std::uint64_t window, double time_s, long solutions)> solving;
  };
  CoupledSolid(const scene::Scene& scene, const std::filesystem::path& folder, results::Begin begin, Progress progress);

  void place(wire::Motion& motion) override;
  void predict(double ahead_s, wire::Motion& motion) override;
  void start(const wire::Load& load) override;
  void advance(const wire::Load& load, const wire::Motion& told, double from_s, double to_s) override;
  void record() override;
  [[nodiscard]] bool calm() const override;
  [[nodiscard]] bool finished() const override;
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(solid_, water_, failure_, margins_, edge_tension_, acceleration_, series_, energy_, added_mass_,
            interface_energy_, history_, frame_log_, vtk_, first_, frame_, last_load_, next_history_s_, next_frame_s_,
            recorded_s_, largest_penetration_m_, breached_s_, frames_, step_s_, map_s_, watch_s_, output_s_);
  }

  /// Writes summary.json; `extra` is merged into it. When `stopped` is not empty the run ended early, for that reason.
  void finish(const nlohmann::json& extra, const std::string& stopped, const std::vector<std::string>& more_skips = {});

 private:
  /// Calls step(); one that meets what is not a number leaves repeat.toml behind.
  void solve(double until_s, const std::function<void()>& step);
  /// Throws std::runtime_error where the exchange makes energy, unless that is to be a result.
  void watch_interface(const wire::Load& load, const wire::Motion& told, const AddedMasses& masses, double from_s,
                       double to_s);
  /// What the water presses on, on the blocks where they are.
  void map(const wire::Load& load);
  void observe(const wire::Load& load, double time_s);
  [[nodiscard]] nlohmann::json seconds() const;

  Solid solid_;
  WaterCourse water_;
  FailureWatch failure_;
  Margins margins_;           ///< while nothing has failed
  EdgeTension edge_tension_;  ///< likewise
  AccelerationFit acceleration_;
  expect::TimeSeries series_;
  EnergyWatch energy_;
  AddedMassWatch added_mass_;
  InterfaceEnergy interface_energy_;
  std::filesystem::path folder_;
  output::HistoryWriter history_;
  output::FrameLog frame_log_;
  output::VtkWriter vtk_;
  Progress progress_;
  Frame first_;
  Frame frame_;
  wire::Load last_load_;              ///< under which the blocks have come to where they are
  std::optional<double> unrecorded_;  ///< time that is to be recorded; none where a checkpoint is written
  double next_history_s_ = 0;
  double next_frame_s_ = 0;
  double recorded_s_ = -1;  ///< time of frame_
  double largest_penetration_m_ = 0;
  std::optional<double> breached_s_;
  Frames frames_;
  double step_s_ = 0;    ///< wall time in the solid's steps
  double map_s_ = 0;     ///< wall time between messages and blocks
  double watch_s_ = 0;   ///< wall time in looking for failure, margins, energies
  double output_s_ = 0;  ///< wall time in writing
};

}  // namespace blockweir::solid
