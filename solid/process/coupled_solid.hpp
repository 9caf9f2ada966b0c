// SPDX-License-Identifier: GPL-3.0-or-later
// The solid side of a coupled run: it steps, watches for failure and writes results.
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
  /// Callbacks for progress. `settling` and `solving` are called at the start of steps and after each linear solution,
  /// with the number of solutions of the initial state or of the window so far. If they throw, the run ends.
  struct Progress {
    std::function<void(double time_s, double level_m, double displacement_m)> run;
    std::function<void(long solutions)> settling;
    std::function<void(std::uint64_t window, double time_s, long solutions)> solving;
  };
  CoupledSolid(const scene::Scene& scene, const std::filesystem::path& folder, results::Begin begin, Progress progress);

  void place(wire::Motion& motion) override;
  void predict(double ahead_s, wire::Motion& motion) override;
  void start(const wire::Load& load) override;
  void advance(const wire::Load& load, const wire::Motion& sent, double from_s, double to_s) override;
  void record() override;
  void prepare() override;
  [[nodiscard]] bool at_rest() const override;
  [[nodiscard]] bool finished() const override;
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(solid_, water_, failure_, margins_, edge_tension_, strain_, acceleration_, series_, energy_, added_mass_,
            interface_energy_, history_, frame_log_, vtk_, first_, frame_, last_load_, next_history_s_, next_frame_s_,
            recorded_s_, largest_penetration_m_, breach_, frames_, step_s_, map_s_, watch_s_, output_s_);
  }

  /// Writes summary.json; `extra` is merged into it. `stopped`: reason if the run ended early, otherwise empty.
  void finish(const nlohmann::json& extra, const std::string& stopped, const std::vector<std::string>& more_skips = {});

 private:
  /// Calls step(); if a value is not a number, writes repeat.toml for reproduction.
  void solve(double until_s, const std::function<void()>& step);
  /// Throws std::runtime_error if the exchange produces energy, unless the scene asks for that as a result.
  void watch_interface(const wire::Load& load, const wire::Motion& sent, const AddedMasses& masses, double from_s,
                       double to_s);
  /// Converts the load to panels on the blocks at their present positions.
  void map(const wire::Load& load);
  void observe(const wire::Load& load, double time_s);
  [[nodiscard]] nlohmann::json seconds() const;

  Solid solid_;
  PressureHistory water_;
  FailureWatch failure_;
  Margins margins_;           ///< until something fails
  EdgeTension edge_tension_;  ///< likewise
  LargestStrain strain_;
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
  wire::Load last_load_;              ///< under which the blocks reached their positions
  std::optional<double> unrecorded_;  ///< time still to be recorded; none when a checkpoint is written
  double next_history_s_ = 0;
  double next_frame_s_ = 0;
  double recorded_s_ = -1;  ///< time of frame_
  double largest_penetration_m_ = 0;
  std::optional<Breach> breach_;  ///< the first
  Frames frames_;
  double step_s_ = 0;    ///< wall time in the solid's steps
  double map_s_ = 0;     ///< wall time in converting messages
  double watch_s_ = 0;   ///< wall time in checking failure, margins, energies
  double output_s_ = 0;  ///< wall time in writing results
};

}  // namespace blockweir::solid
