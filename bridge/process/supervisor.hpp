// SPDX-License-Identifier: GPL-3.0-or-later
// Starts child processes together and sees to it that none outlives the others, or us.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace blockweir::process {

struct Command {
  std::string name;                        ///< how messages call it
  std::vector<std::string> words;          ///< program and arguments
  int inherited_fd = -1;                   ///< a descriptor of ours that the child keeps; -1: none
  std::filesystem::path output{};          ///< file for all that it writes; empty: standard error to NAME.log alone
  std::filesystem::path folder{};          ///< that it runs in; empty: ours
  std::vector<std::string> environment{};  ///< NAME=value, beside ours
  std::string remedy = "build or install all programs of blockweir";  ///< where it cannot be started
  bool external = false;  ///< a user's, which has to connect to the first and to stay
  bool aside = false;     ///< the others do without it: it is waited for where they end well, else killed
};

struct ChildEnd {
  std::string name;
  int exit_code = 0;     ///< 128 + signal for one that was killed
  bool by_us = false;    ///< we had asked it to end, or killed it
  bool stopped = false;  ///< it, or what it started, had been stopped (SIGSTOP) when another failed
  bool external = false;
  std::vector<std::string> words{};  ///< of an external one: its command
  bool early = false;                ///< an external one ended before the first was in touch with it
  std::string last_line;             ///< of what it wrote to its standard error
};

struct Supervised {
  std::vector<ChildEnd> ends;  ///< of all but those aside, in the order in which they ended
  bool interrupted = false;    ///< we were asked to stop
  bool asked_to_stop = false;  ///< the same, also where all had just ended well: who has more to do does not do it
  bool overdue = false;        ///< it took too long and was killed
  [[nodiscard]] bool all_fine() const;
};

/// That is not empty.
std::string last_line(const std::filesystem::path& log);

/// SIGINT and SIGTERM wait for as long as it lives, but for supervise(), which hears them; those that came too late for
/// that are forgotten.
class StopsLater {
 public:
  StopsLater();
  ~StopsLater();
  StopsLater(const StopsLater&) = delete;
  StopsLater& operator=(const StopsLater&) = delete;

 private:
  sigset_t before_{};
};

/// Runs all commands at once until the last has ended. Their standard error goes to files `log_folder`/NAME.log
/// unless a command says otherwise.
/// When one fails, the others get `grace_s` to notice by themselves, then SIGTERM, then SIGKILL. One that is stopped
/// notices nothing: it gets SIGTERM at once, and is woken to leave in order. SIGINT or SIGTERM to
/// us is passed on to the first command, which leaves in order and tells the others; a second one, or one that comes
/// before they are in touch, to all. What the commands themselves started and left behind is waited for, and killed
/// after `grace_s`. One that is external and ends before they are in touch has failed, and ends all at once. The kernel
/// ends the children should we be killed. `tick` is called about every 50 ms and says whether they are. What still runs
/// after `longest_s` is killed; 0: never.
Supervised supervise(const std::vector<Command>& commands, const std::filesystem::path& log_folder, double grace_s,
                     const std::function<bool()>& tick, double longest_s = 0);

}  // namespace blockweir::process
