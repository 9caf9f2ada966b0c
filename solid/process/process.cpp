// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/channel/endpoint.hpp"
#include "bridge/channel/handshake.hpp"
#include "bridge/channel/keys.hpp"
#include "bridge/process/fluid_name.hpp"
#include "bridge/process/sides.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/peak_memory.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/schedule/hello.hpp"
#include "bridge/schedule/run.hpp"
#include "solid/process/coupled_solid.hpp"

namespace blockweir::process {
namespace {

using schedule::Exchanges;
using schedule::FluidReport;

using Clock = std::chrono::steady_clock;

/// Progress lines: at most twenty a second on a pipe, one in two seconds for people. While the structure settles,
/// "settling SOLUTIONS"; then "time_s level_m largest_displacement_m", and "solving WINDOW time_s SOLUTIONS" from a
/// long window. A waiting fluid gets a sign of life after each solution.
class Reports {
 public:
  /// `checkpoints`: some are written before the process is asked to stop.
  Reports(int fd, double duration_s, bool checkpoints) : fd_(fd), duration_s_(duration_s), checkpoints_(checkpoints) {}

  /// Where the fluid waits for what is solved, from now on; null: nowhere.
  void set_fluid(channel::Channel* fluid) { fluid_ = fluid; }

  /// Throws channel::Interrupted once the process has been asked to stop: there is nothing to keep yet.
  void settling(long solutions) {
    if (channel::stop_requested()) throw channel::Interrupted("asked to stop while the structure settled");
    const auto now = Clock::now();
    if (now - looked_ < look_every) return;
    looked_ = now;
    const std::string text = fmt::format("settling: {} linear systems solved", solutions);
    tell_fluid(text);
    if (due()) write(fd_ >= 0 ? fmt::format("settling {}\n", solutions) : text + "\n");
  }
  /// Throws channel::Interrupted once the process has been asked twice, or once a while ago: at the window's end a
  /// checkpoint would be written, for which whoever asks waits a little, or, where no others are written, until then.
  void solving(std::uint64_t window, double time_s, long solutions) {
    const auto now = Clock::now();
    if (channel::stop_requested() && !asked_) asked_ = now;  // not before: a stopped process (SIGSTOP) is asked late
    const bool twice = channel::stop_requested_twice();
    if (twice || (checkpoints_ && asked_ && now - *asked_ > patience)) {
      throw channel::Interrupted(
          fmt::format("asked{} to stop, in window {} at {:.4g} s", twice ? " twice" : "", window, time_s));
    }
    if (now - looked_ < look_every) return;
    looked_ = now;
    if (std::exchange(window_, window) != window) window_since_ = now;
    const std::string text = fmt::format("window {}, {:.4g} s: {} solutions so far", window, time_s, solutions);
    tell_fluid(text);
    if (now - window_since_ < long_window || !due()) return;
    write(fd_ >= 0 ? fmt::format("solving {} {:.9g} {}\n", window, time_s, solutions) : text + "\n");
  }
  void run(double time_s, double level_m, double displacement_m) {
    if (!due() && begun_ && time_s < duration_s_) return;
    begun_ = true;
    write(fd_ >= 0 ? fmt::format("{:.9g} {:.9g} {:.9g}\n", time_s, level_m, displacement_m)
                   : fmt::format("{:.4g} of {:.4g} s{}, largest displacement {:.3g} m\n", time_s, duration_s_,
                                 std::isnan(level_m) ? "" : fmt::format(", level {:.4g} m", level_m), displacement_m));
  }

 private:
  static constexpr std::chrono::milliseconds look_every{20};  // solutions of few blocks come by the ten thousand
  static constexpr std::chrono::milliseconds long_window{1'000};
  static constexpr std::chrono::seconds patience{3};

  void tell_fluid(const std::string& text) {
    if (fluid_ != nullptr) fluid_->send(wire::Progress{text});
  }
  bool due() {
    const auto now = Clock::now();
    if (silent_ || now - last_ < std::chrono::milliseconds(fd_ >= 0 ? 50 : 2000)) return false;
    last_ = now;
    return true;
  }
  void write(const std::string& line) {
    // If nobody reads, the run continues without progress lines.
    silent_ = silent_ || ::write(fd_ >= 0 ? fd_ : STDERR_FILENO, line.data(), line.size()) < 0;
  }

  int fd_;
  double duration_s_;
  bool checkpoints_;
  std::optional<Clock::time_point> asked_;  ///< to stop
  Clock::time_point last_ = Clock::now();
  Clock::time_point looked_;
  channel::Channel* fluid_ = nullptr;
  std::uint64_t window_ = 0;
  Clock::time_point window_since_ = Clock::now();
  bool begun_ = false;
  bool silent_ = false;
};

/// Of this process's threads so far, its loading among it.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Messages that were skipped, and the process that was not needed: its start would take about as long as the solid's.
std::vector<std::string> skips_of(const Exchanges& exchanges, bool dry, bool one_process, double exchange_s,
                                  double start_s) {
  using results::saved;
  std::vector<std::string> skips;
  if (exchanges.skipped > 0 && !dry) {
    skips.push_back(fmt::format("{} of {} exchanges: no block had moved and the water stood{}", exchanges.skipped,
                                exchanges.said + exchanges.skipped,
                                saved(exchange_s, exchanges.said, exchanges.skipped)));
  }
  if (dry) skips.push_back(fmt::format("a fluid process: the scene has no water{}", saved(start_s)));
  if (one_process && exchanges.said > 0) {
    skips.push_back(fmt::format("a second process: the water was within the solid's{}", saved(start_s)));
  }
  return skips;
}

/// With water somebody has to be asked for its pressures, without water nobody.
void require_line(const scene::Scene& scene, const SolidProcess& process) {
  const bool alone = scene.fluid == scene::FluidModel::none;
  if (!alone && !process.make_fluid && process.line.endpoint.empty()) {
    throw std::invalid_argument(
        "the scene has water, and no --endpoint: say with it where to listen for the fluid process (ipc://PATH or "
        "tcp://HOST:PORT), or start \"blockweir run\"");
  }
  if (alone && !process.line.endpoint.empty()) {
    throw std::invalid_argument(
        fmt::format("--endpoint {}: the scene has no water to exchange; add [water] with a level "
                    "to it, or leave --endpoint out",
                    process.line.endpoint));
  }
}

/// The solid side of one run: without water, with the water in this process, or with a fluid process on the line.
class SolidRun {
 public:
  SolidRun(const scene::Scene& scene, SolidProcess& process, Clock::time_point start)
      : scene_(scene),
        process_(process),
        start_(start),
        checkpoints_(process.folder, "solid", scene.digest, scene.output.checkpoint_every_s),
        reports_(process.progress_fd, scene.analysis.duration_s, scene.output.checkpoint_every_s > 0),
        coupled_(scene, process.folder, process.resume == 0 ? results::Begin::anew : results::Begin::where_it_stopped,
                 {.run = [&](double time_s, double level_m, double moved_m) { reports_.run(time_s, level_m, moved_m); },
                  .settling = [&](long solutions) { reports_.settling(solutions); },
                  .solving = [&](std::uint64_t window, double time_s,
                                 long solutions) { reports_.solving(window, time_s, solutions); }}) {}

  /// A run that ends early leaves its summary, too.
  void run() {
    try {
      if (scene_.fluid == scene::FluidModel::none) {
        exchange_with(nullptr);
      } else if (process_.make_fluid) {
        run_with_own_fluid();
      } else {
        run_with_partner();
      }
    } catch (const solid::SolveError& error) {
      finish(error.what(), /*ends_here_again=*/true);
      throw;
    } catch (const std::exception& error) {
      finish(error.what());
      throw;
    }
    finish("");
  }
  [[nodiscard]] const FluidReport& report() const { return report_; }

 private:
  void exchange_with(schedule::FluidLine* fluid) {
    started_s_ = seconds_since(start_);
    if (channel_) waited_before_s_ = channel_->waited_s();
    exchanges_ = schedule::run_solid(fluid, scene_, checkpoints_, process_.resume, coupled_);
  }

  void run_with_own_fluid() {
    const std::unique_ptr<schedule::FluidSide> fluid = process_.make_fluid(scene_, process_.folder);
    checkpoint::Checkpoints its_own(process_.folder, scene::name(scene_.fluid), scene_.digest, 0);
    schedule::FluidTurn turn(*fluid, its_own, process_.resume);
    schedule::LocalFluid here(turn, within_s_);
    exchange_with(&here);
    report_ = turn.report();
  }

  void run_with_partner() {
    const scene::FluidEntry& fluid = scene::fluid_entry(scene_.fluid);
    std::string name = fluid_name(scene_);
    process_.line.partner = name;
    process_.line.timeout_s = scene_.coupling.timeout_s;
    process_.line.open_timeout_s = scene_.coupling.open_timeout_s;
    channel_.emplace(process_.line);
    const wire::Hello theirs = channel_->handshake(schedule::hello(scene_, "solid", process_.resume));
    if (fluid.yours) {
      name = fmt::format("external fluid \"{}\"", channel::printable(theirs.role));
      channel_->call_partner(name);
    }
    reports_.set_fluid(&*channel_);
    schedule::RemoteFluid there(*channel_, name);
    exchange_with(&there);
  }

  void finish(const std::string& stopped, bool ends_here_again = false) {
    nlohmann::json profile = {{"start_up", started_s_}};
    double exchange_s = within_s_;
    if (process_.make_fluid) profile["wait_for_fluid"] = within_s_;
    if (channel_) {
      profile["wait_for_fluid"] = channel_->waited_s() - waited_before_s_;
      profile["pack"] = channel_->packed_s();
      profile["wire"] = channel_->wire_s();
      exchange_s = channel_->waited_s() - waited_before_s_ + channel_->packed_s() + channel_->wire_s();
    }
    nlohmann::json own = {{"wall_time_s", seconds_since(start_)},
                          {"profile_s", profile},
                          {"counts", {{"exchanges", exchanges_.said}, {"skipped_exchanges", exchanges_.skipped}}},
                          {"peak_memory_mb", {{"solid", results::peak_memory_mb()}}}};
    if (ends_here_again) own["ends_here_again"] = true;
    const bool dry = scene_.fluid == scene::FluidModel::none;
    coupled_.finish(own, stopped, skips_of(exchanges_, dry, process_.make_fluid != nullptr, exchange_s, own_start_s_));
  }

  const scene::Scene& scene_;
  SolidProcess& process_;
  Clock::time_point start_;
  checkpoint::Checkpoints checkpoints_;
  Reports reports_;
  solid::CoupledSolid coupled_;
  double own_start_s_ = processor_s();
  std::optional<channel::Channel> channel_;
  FluidReport report_;
  Exchanges exchanges_;
  double started_s_ = 0;
  double waited_before_s_ = 0;
  double within_s_ = 0;  ///< in a fluid of this process
};

}  // namespace

FluidReport run_process(SolidProcess process) {
  const auto start = Clock::now();
  const scene::Scene scene = scene::read(process.scene, process.overrides).scene;
  require_line(scene, process);
  const channel::Options& line = process.line;
  if (!line.endpoint.empty()) {  // before a folder is made that nothing would be written to
    if (!line.keys.empty()) channel::read_keys(line.keys);
    channel::check_endpoint(line.endpoint, /*listens=*/true, /*may_come=*/line.insecure || !line.keys.empty());
  }
  channel::catch_stop_signals();
  results::make_folder(process.folder);
  const results::FolderLock lock(process.folder);
  if (process.resume == 0) checkpoint::forget(process.folder);
  SolidRun run(scene, process, start);
  run.run();
  return run.report();
}

}  // namespace blockweir::process
