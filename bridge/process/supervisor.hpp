// SPDX-License-Identifier: GPL-3.0-or-later
// Starts child processes together and makes sure that none outlives the others, or us.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace blockweir::process {

struct Command {
  std::string name;                        ///< name in messages
  std::vector<std::string> words;          ///< program and arguments
  int inherited_fd = -1;                   ///< a descriptor of ours that the child inherits; -1: none
  std::filesystem::path output{};          ///< file for all its output; empty: only standard error, to NAME.log
  std::filesystem::path folder{};          ///< working folder; empty: ours
  std::vector<std::string> environment{};  ///< NAME=value, in addition to ours
  std::string remedy = "build or install all programs of blockweir";  ///< if it cannot be started
  bool external = false;  ///< a user's program, which has to connect to the first command and stay
  bool aside = false;     ///< optional for the others: waited for if they end well, otherwise killed
};

struct ChildEnd {
  std::string name;
  int exit_code = 0;     ///< 128 + signal if it was killed
  bool by_us = false;    ///< we asked it to end, or killed it
  bool stopped = false;  ///< it or a descendant was stopped (SIGSTOP) when another failed
  bool external = false;
  std::vector<std::string> words{};  ///< command of an external program
  bool early = false;                ///< an external program ended before it had connected to the first
  std::string last_line;             ///< of its standard error
};

struct Supervised {
  std::vector<ChildEnd> ends;  ///< all except the optional ones, in the order in which they ended
  bool interrupted = false;    ///< we were asked to stop
  bool asked_to_stop = false;  ///< the same, also after all had ended well: the caller does no further work
  bool overdue = false;        ///< killed because it took too long
  [[nodiscard]] bool all_fine() const;
};

/// The last line that is not empty.
std::string last_line(const std::filesystem::path& log);

/// Blocks SIGINT and SIGTERM during its lifetime, except in supervise(), which handles them; those that supervise() has
/// not handled are delivered at the end.
class StopsLater {
 public:
  StopsLater();
  ~StopsLater();
  StopsLater(const StopsLater&) = delete;
  StopsLater& operator=(const StopsLater&) = delete;

 private:
  sigset_t before_{};
};

/// Runs all commands in parallel until the last has ended. Their standard error goes to
/// `log_folder`/NAME.log unless a command says otherwise. If one fails, the others have `grace_s` to notice
/// it, a second before they are connected, then they get SIGTERM, then SIGKILL. A stopped process cannot notice: it
/// gets SIGTERM at once and is continued so that it can end in order; so are all if all are stopped for `grace_s`.
/// SIGINT or SIGTERM to us goes to the first command, which ends in order and tells the others; a second signal, or one
/// before they are connected, goes to all. Descendants of the commands are waited for, and killed after `grace_s`. An
/// external command that ends before it is connected has failed, and ends all others at once. If we are killed, the
/// kernel ends the children. `tick` is called about every 50 ms and returns whether they are connected. After
/// `longest_s` all are killed; 0: no limit.
Supervised supervise(const std::vector<Command>& commands, const std::filesystem::path& log_folder, double grace_s,
                     const std::function<bool()>& tick, double longest_s = 0);

}  // namespace blockweir::process
