// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_wire cppzmq nlohmann_json::nlohmann_json
// What goes wrong on the line itself: who notices, when, what is printed, what is left. bridge/channel/README.md has
// the table.
#include <limits>
#include <map>
#include <optional>
#include <random>

#include "tests/fault/frame_faults.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::line_faults_test {
namespace {

using testing::HasSubstr;
using From = Relay::From;

/// What befalls a side itself.
enum class Blow { killed, stopped, full_disk };

class LineFaults : public Processes {
 protected:
  struct Sides {
    pid_t solid;
    pid_t fluid;
    [[nodiscard]] pid_t of(From side) const { return side == From::solid ? solid : fluid; }
    [[nodiscard]] pid_t beside(From side) const { return side == From::solid ? fluid : solid; }
  };
  [[nodiscard]] std::string at(const char* name) const { return "ipc://" + (folder / name).string(); }
  [[nodiscard]] pid_t start_solid() const {
    return start(programs + "/blockweir-solid " + scene + " --out o --endpoint " + at("a"), "solid");
  }
  [[nodiscard]] pid_t start_fluid(const char* line) const {
    return start(programs + "/blockweir-hydrostatic " + scene + " --endpoint " + at(line), "fluid");
  }
  /// Without a relay; both have come, and so many rows are written.
  [[nodiscard]] Sides both_under_way(long rows = 20) const {
    const Sides sides{start_solid(), start_fluid("a")};
    EXPECT_TRUE(under_way("o", rows)) << text("solid") << text("fluid");
    return sides;
  }
  /// What was recorded is the beginning of what a sound run records, in whole rows, at least `rows` of them.
  void expect_no_wrong_result(const std::string& whole, long rows, bool with_summary = true) const {
    const std::string history = text("o/history.csv");
    EXPECT_EQ(whole.compare(0, history.size(), history), 0);
    EXPECT_TRUE(history.ends_with('\n'));
    EXPECT_GE(rows_of("o"), rows);
    if (with_summary) {
      EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
    }
  }
  [[nodiscard]] std::string sound_history() const {
    EXPECT_EQ(shell(programs + "/blockweir run " + scene + " --quiet --out whole"), 0) << text("out");
    return text("whole/history.csv");
  }
  /// The receiver ends by itself, the other one when the line breaks.
  void expect_noticed(From from, const Relay::Tamper& tamper, const char* says) {
    const pid_t solid = start_solid();
    auto relay = std::make_unique<Relay>(at("a"), at("b"), tamper);
    const pid_t fluid = start_fluid("b");
    const pid_t receiver = from == From::solid ? fluid : solid;
    EXPECT_EQ(end_of(receiver, 15), 1) << text("solid") << text("fluid");
    relay.reset();
    EXPECT_EQ(end_of(receiver == solid ? fluid : solid, 5), 1) << text("solid") << text("fluid");
    EXPECT_THAT(text(from == From::solid ? "fluid" : "solid"), HasSubstr(says));
    EXPECT_FALSE(orphan());
  }
  /// A side is killed or stopped once `rows` are written: the other ends by itself, within the time-out.
  void expect_loss_noticed(From victim, Blow blow, long rows) {
    const Sides sides = both_under_way(rows);
    kill(sides.of(victim), blow == Blow::killed ? SIGKILL : SIGSTOP);
    EXPECT_EQ(end_of(sides.beside(victim), 1.5), 1);
    EXPECT_THAT(text(victim == From::solid ? "fluid" : "solid"),
                testing::AnyOf(HasSubstr("closed the line"), HasSubstr("has been silent for 1 s")));
    kill(sides.of(victim), SIGCONT);
    EXPECT_EQ(end_of(sides.of(victim), 5), blow == Blow::killed ? 128 + SIGKILL : 1);
  }
  /// The solid alone writes results.
  void expect_full_disk_noticed(long half_kilobytes) {
    const Sides sides{
        start(on_a_full_disk(half_kilobytes, programs + "/blockweir-solid " + scene + " --out o --endpoint " + at("a")),
              "solid"),
        start_fluid("a")};
    EXPECT_EQ(end_of(sides.solid, 15), 1);
    EXPECT_EQ(end_of(sides.fluid, 5), 1);
    EXPECT_THAT(text("solid"), HasSubstr("is the disk full, or the folder not writable?"));
  }
  void TearDown() override { EXPECT_FALSE(orphan()); }

  const std::string scene =
      cases + "cracked-dam-upper --set analysis.duration_s=4 --set coupling.timeout_s=1 --set output.frame_every_s=1";
};

/// No hang: all ends within its time. No orphan, no lost and no wrong result: looked for after each.
TEST_F(LineFaults, EachIsNoticedAndNoWrongResultIsWritten) {
  const char* asked = std::getenv("BLOCKWEIR_FAULTS");
  const int count = asked != nullptr ? std::atoi(asked) : 22;
  constexpr unsigned seed = 20260102;
  std::mt19937 random(seed);
  const std::string whole = sound_history();
  std::map<std::string, int> done;
  for (int trial = 0; trial < count && !HasFailure(); ++trial) {
    const From from = trial % 2 == 0 ? From::fluid : From::solid;
    const std::vector<Fault> frames = faults_of(from);
    const std::size_t kind = static_cast<std::size_t>(trial / 2) % (frames.size() + 3);
    const long window = 3 + static_cast<long>(random() % 90);
    const auto blow = kind < frames.size() ? std::nullopt : std::optional(static_cast<Blow>(kind - frames.size()));
    const char* name = !blow                    ? frames[kind].name
                       : *blow == Blow::killed  ? "killed"
                       : *blow == Blow::stopped ? "stopped"
                                                : "disk full";
    SCOPED_TRACE(testing::Message() << trial << ": " << name << ", window " << window << " of "
                                    << (from == From::fluid ? "the fluid" : "the solid"));
    if (!blow) {
      expect_noticed(
          from,
          [&](From sender, std::size_t number, const std::vector<Frame>& sent) -> std::vector<Frame> {
            if (sender != from || number != static_cast<std::size_t>(window)) return {sent.back()};
            return frames[kind].happens(sent, random);
          },
          frames[kind].says);
    } else if (*blow == Blow::full_disk) {
      expect_full_disk_noticed(40 + window);
    } else {
      expect_loss_noticed(from, *blow, window);
    }
    const bool dead = blow == Blow::killed && from == From::solid;
    expect_no_wrong_result(whole, blow == Blow::full_disk ? 1 : window, !dead);
    EXPECT_FALSE(orphan());
    ++done[name];
    fs::remove_all(folder / "o");
  }
  if (HasFailure()) return;
  std::string kinds;
  for (const auto& [name, times] : done) kinds += " " + std::to_string(times) + " " + name + ",";
  kinds.back() = ':';
  std::printf("%d faults, seed %u,%s no hang, no orphan, no lost result, no wrong result\n", count, seed,
              kinds.c_str());
}

TEST_F(LineFaults, APartnerOfAnotherVersionIsRefusedWithBothNumbers) {
  expect_noticed(
      From::fluid,
      [](From, std::size_t number, const std::vector<Frame>& sent) -> std::vector<Frame> {
        if (number > 0) return {sent.back()};
        return {altered<wire::Hello>(sent.back(), [](wire::Hello& hello) { hello.protocol = 11; })};
      },
      "handshake refused: protocol: solid has 10, hydrostatic has 11");
}

TEST_F(LineFaults, APartnerFromBeforeChecksumsIsRefused) {
  expect_noticed(
      From::fluid,
      [](From, std::size_t, const std::vector<Frame>& sent) -> std::vector<Frame> {
        return {Frame(sent.back().begin(), sent.back().end() - 16)};
      },
      "not of protocol 10: are both sides of one version of blockweir?");
}

TEST_F(LineFaults, AStrangerOnALineInUseChangesNothing) {
  const std::string whole = sound_history();
  const pid_t solid = start_solid();
  const pid_t fluid = start_fluid("a");
  ASSERT_TRUE(under_way("o"));
  for (const int stays_ms : {10, 20, 30, 40, 50}) {
    zmq::context_t context;
    zmq::socket_t stranger(context, zmq::socket_type::pair);
    stranger.set(zmq::sockopt::linger, 0);
    stranger.connect(at("a"));
    stranger.send(zmq::buffer(std::string("anything")), zmq::send_flags::dontwait);
    std::this_thread::sleep_for(std::chrono::milliseconds(stays_ms));
  }
  EXPECT_EQ(end_of(solid, 30), 0) << text("solid");
  EXPECT_EQ(end_of(fluid, 5), 0) << text("fluid");
  EXPECT_EQ(text("o/history.csv"), whole);
}

TEST_F(LineFaults, AStoppedPartnerIsNoticedWithinTheTimeOut) {
  const std::string whole = sound_history();
  for (const From victim : {From::solid, From::fluid}) {
    expect_loss_noticed(victim, Blow::stopped, 20);
    expect_no_wrong_result(whole, 20);
    fs::remove_all(folder / "o");
  }
}

TEST_F(LineFaults, APartnerThatGoesOnInTimeLosesNothing) {
  const std::string whole = sound_history();
  for (const From stopped : {From::solid, From::fluid}) {
    const Sides sides = both_under_way();
    kill(sides.of(stopped), SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    kill(sides.of(stopped), SIGCONT);
    EXPECT_EQ(end_of(sides.solid, 30), 0) << text("solid");
    EXPECT_EQ(end_of(sides.fluid, 5), 0) << text("fluid");
    EXPECT_EQ(text("o/history.csv"), whole);
    fs::remove_all(folder / "o");
  }
}

TEST_F(LineFaults, ATakenPortIsRefused) {
  const std::string port = " --endpoint tcp://127.0.0.1:" + std::to_string(20000 + getpid() % 20000);
  const pid_t first = start(programs + "/blockweir-solid " + scene + " --out a" + port, "first");
  for (int wait = 0; wait < 1000 && !fs::exists(folder / "a/history.csv"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(shell(programs + "/blockweir-solid " + scene + " --out b" + port), 1);
  EXPECT_THAT(text("out"), HasSubstr("Address already in use; choose another --endpoint"));
  EXPECT_EQ(end_of(first, 25), 1);
}

TEST_F(LineFaults, ADiskThatFillsUpLeavesACheckpointToGoOnFrom) {
  fs::create_directory(folder / "disk");
  if (shell("mount -t tmpfs -o size=32m none disk") != 0)
    GTEST_SKIP() << "no disk can be mounted here: " << text("out");
  const std::string often = cases + "cracked-dam-upper --set output.checkpoint_every_s=0.002 --quiet --out ";
  EXPECT_EQ(shell(programs + "/blockweir run " + often + "whole"), 0) << text("out");
  const pid_t run = start(programs + "/blockweir run " + often + "disk/o", "log");
  EXPECT_TRUE(under_way("disk/o"));
  EXPECT_EQ(shell("dd if=/dev/zero of=disk/filler bs=4k"), 1);
  EXPECT_EQ(end_of(run, 20), 1) << text("log");
  EXPECT_THAT(text("log"), HasSubstr("no room is left on the disk that holds disk/o"));
  EXPECT_THAT(text("log"), HasSubstr("\"blockweir resume disk/o\" continues the run"));
  EXPECT_FALSE(orphan());
  fs::remove(folder / "disk/filler");
  EXPECT_EQ(shell(programs + "/blockweir resume disk/o --quiet"), 0) << text("out");
  EXPECT_EQ(text("disk/o/history.csv"), text("whole/history.csv"));
  EXPECT_EQ(shell("umount disk"), 0) << text("out");
}

TEST_F(LineFaults, AReportForAFullDiskIsRefusedBeforeItsRun) {
  fs::create_directory(folder / "disk");
  if (shell("mount -t tmpfs -o size=64k none disk") != 0)
    GTEST_SKIP() << "no disk can be mounted here: " << text("out");
  EXPECT_EQ(shell(programs + "/blockweir report " + cases + "cracked-dam-upper --out disk/r.html"), 1);
  EXPECT_THAT(text("out"), HasSubstr("no room is left on the disk that holds disk/r.html: "));
  EXPECT_FALSE(fs::exists(folder / "runs"));
  EXPECT_EQ(shell("umount disk"), 0) << text("out");
}

TEST_F(LineFaults, TheLauncherEndsAPartnerThatIsStopped) {
  const pid_t run = start(programs + "/blockweir run " + scene + " --set analysis.step_s=0.001 --quiet --out o", "log");
  ASSERT_TRUE(under_way("o"));
  EXPECT_TRUE(signal_child(run, "hydrostatic", "STOP"));
  EXPECT_EQ(end_of(run, 15), 1) << text("log");
  EXPECT_EQ(nlohmann::json::parse(text("o/summary.json"))["outcome"], "stopped");
}

}  // namespace
}  // namespace blockweir::test::line_faults_test
