// SPDX-License-Identifier: GPL-3.0-or-later
// The real programs, started and ended in a folder of the test's own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "tests/own_folder.hpp"

namespace blockweir::test {

namespace fs = std::filesystem;
inline const std::string programs = BLOCKWEIR_PROGRAMS;
inline const std::string cases = std::string(BLOCKWEIR_SOURCE) + "/cases/";

class Processes : public OwnFolder {
 protected:
  [[nodiscard]] std::string text(const std::string& file) const {
    std::ostringstream all;
    all << std::ifstream(folder / file).rdbuf();
    return all.str();
  }
  /// Exit status of a shell command; its output goes to the file "out".
  [[nodiscard]] int shell(const std::string& command) const {
    const int status = std::system(("cd " + folder.string() + " && timeout 280 " + command + " >out 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }
  [[nodiscard]] pid_t start(const std::string& command, const std::string& log) const {
    const pid_t pid = fork();
    if (pid == 0) {
      const std::string line = "cd " + folder.string() + " && exec " + command + " >" + log + " 2>&1";
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    return pid;
  }
  /// Exit status, or -1 when it still runs after `patience_s`.
  static int end_of(pid_t pid, double patience_s) {
    for (const auto begin = std::chrono::steady_clock::now();
         std::chrono::steady_clock::now() - begin < std::chrono::duration<double>(patience_s);) {
      int status = 0;
      if (waitpid(pid, &status, WNOHANG) == pid)
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return -1;
  }

  /// Sends `signal` (its name without SIG) to the process `name` of that launcher's run alone; true when it was there.
  [[nodiscard]] bool signal_child(pid_t launcher, const std::string& name, const std::string& signal) const {
    return shell("pkill -" + signal + " -P " + std::to_string(launcher) + " -f '[b]lockweir-" + name + "'") == 0;
  }

  /// That the run in `run` has written so far, below the heading.
  [[nodiscard]] long rows_of(const std::string& run) const {
    const std::string history = text(run + "/history.csv");
    return std::max(0L, std::count(history.begin(), history.end(), '\n') - 1);
  }
  /// Until the run in `run` has written so many rows; false when it does not within 10 s.
  [[nodiscard]] bool under_way(const std::string& run, long rows = 20) const {
    for (int wait = 0; wait < 10'000 && rows_of(run) < rows; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return rows_of(run) >= rows;
  }
  /// Files may grow to `blocks` half kilobytes, as if the disk were full then.
  static std::string on_a_full_disk(long blocks, const std::string& command) {
    return "sh -c \"trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; exec " + command + "\"";
  }
  /// Does a process that this test started, or one of its children, still run? All of them start in its folder.
  [[nodiscard]] bool orphan() const {
    for (const auto& process : fs::directory_iterator("/proc")) {
      std::error_code ended;  // or another's
      const std::string where = fs::read_symlink(process.path() / "cwd", ended).string();
      if (!ended && where.rfind(folder.string(), 0) == 0) return true;
    }
    return false;
  }
};

}  // namespace blockweir::test
