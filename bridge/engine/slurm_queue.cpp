// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/engine/slurm_queue.hpp"
#include "bridge/results/counted.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <sstream>
#include <stdexcept>

namespace blockweir::engine {
namespace {

struct Said {
  int status = 0;    ///< 128 + signal where one has ended it
  std::string text;  ///< on both outputs
};

/// Starts `words` in a process group of its own: what a terminal sends to ours, as Ctrl-C, ends no question halfway.
pid_t start(const std::vector<std::string>& words, int output) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
  pid_t child = -1;
  const int failed = ::posix_spawnp(&child, arguments.front(), &files, &attributes, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::posix_spawnattr_destroy(&attributes);
  return failed == 0 ? child : -1;
}

Said ask(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  const bool piped = ::pipe2(ends.data(), O_CLOEXEC) == 0;
  const pid_t child = piped ? start(words, ends[1]) : -1;
  if (piped) ::close(ends[1]);
  if (child < 0) {
    if (piped) ::close(ends[0]);
    throw std::runtime_error("cannot start " + words.front() + ": end other programs");
  }
  Said said;
  std::array<char, 4096> buffer{};
  for (ssize_t more = 0; (more = ::read(ends[0], buffer.data(), buffer.size())) != 0;) {
    if (more < 0 && errno != EINTR) break;
    if (more > 0) said.text.append(buffer.data(), static_cast<std::size_t>(more));
  }
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  while (said.text.ends_with('\n')) said.text.pop_back();
  return said;
}

/// Why a question has no answer; never empty.
std::string trouble_of(const char* program, const Said& said) {
  return said.text.empty() ? fmt::format("{} ended with status {} without a message", program, said.status) : said.text;
}

bool is_unknown_job(const Said& said) {
  return said.text.find("Invalid job id") != std::string::npos;
}

}  // namespace

void require_slurm() {
  if (ask({"sh", "-c", "command -v sbatch squeue scancel"}).status == 0) return;
  throw std::runtime_error(
      "--engine slurm: found no sbatch, squeue and scancel on this machine; expected a machine from which Slurm's "
      "queue "
      "is used; log in to the cluster's front end (on Debian the package slurm-client has them), or leave --engine "
      "out: "
      "all processors of this machine then work");
}

std::string submit(const std::filesystem::path& script, const std::string& name, std::size_t tasks,
                   const std::filesystem::path& logs, const std::vector<std::string>& options) {
  std::vector<std::string> words{"sbatch",
                                 "--parsable",
                                 "--requeue",
                                 "--open-mode=append",
                                 "--job-name=" + name,
                                 fmt::format("--array=0-{}", tasks - 1),
                                 fmt::format("--output={}/%a.log", logs.string())};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(script.string());
  const Said said = ask(words);
  const std::string job = said.text.substr(said.text.rfind('\n') + 1);
  const std::string number = job.substr(0, job.find(';'));  // "NUMBER;CLUSTER"
  if (said.status == 0 && !number.empty() && number.find_first_not_of("0123456789") == std::string::npos) return number;
  const bool unreachable = said.text.find("contact") != std::string::npos;
  throw std::runtime_error(fmt::format(
      "--engine slurm: the queue refused {}: \"{}\"; {}; what is done is kept, and the same command continues",
      results::counted(tasks, "task"), said.text,
      unreachable
          ? "its controller does not answer: see whether \"sinfo\" does, and ask those who run the cluster"
          : "state other options of sbatch with --sbatch (\"sinfo\" lists partitions and their limits), or take "
            "fewer tasks with a larger --batch"));
}

QueueState state_of(const std::string& job) {
  const Said said = ask({"squeue", "--noheader", "--array", "--jobs=" + job, "--format=%T %r"});
  QueueState state;
  if (said.status != 0) {  // a job that has been over for some minutes is not known any more
    if (!is_unknown_job(said)) state.trouble = trouble_of("squeue", said);
    return state;
  }
  std::istringstream lines(said.text);
  for (std::string line; std::getline(lines, line);) {
    const std::string word = line.substr(0, line.find(' '));
    if (word == "PENDING" || word == "REQUEUED" || word == "SUSPENDED") {
      ++state.waiting;
      if (state.reason.empty() && word.size() < line.size()) state.reason = line.substr(word.size() + 1);
    } else if (word == "RUNNING" || word == "COMPLETING" || word == "CONFIGURING") {
      ++state.running;
    }
  }
  return state;
}

std::string cancel(const std::string& job) {
  const Said said = ask({"scancel", job});
  return said.status == 0 || is_unknown_job(said) ? "" : trouble_of("scancel", said);
}

}  // namespace blockweir::engine
