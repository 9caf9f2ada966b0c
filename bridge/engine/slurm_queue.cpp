// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/engine/slurm_queue.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "bridge/results/shell_word.hpp"

namespace blockweir::engine {
namespace {

struct Said {
  int status = 0;
  std::string text;  ///< on both outputs
};

Said ask(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += results::shell_word(word) + " ";
  std::FILE* pipe = ::popen((command + "2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + words.front() + ": end other programs");
  Said said;
  std::array<char, 4096> buffer{};
  for (std::size_t more = 0; (more = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    said.text.append(buffer.data(), more);
  }
  const int status = ::pclose(pipe);
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  while (said.text.ends_with('\n')) said.text.pop_back();
  return said;
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
      "--engine slurm: the queue refused {} tasks: \"{}\"; {}; what is done is kept, and the same command goes on",
      tasks, said.text,
      unreachable
          ? "its controller does not answer: see whether \"sinfo\" does, and ask those who run the cluster"
          : "state other options of sbatch with --sbatch (\"sinfo\" lists partitions and their limits), or take "
            "fewer tasks with a larger --batch"));
}

QueueState state_of(const std::string& job) {
  const Said said = ask({"squeue", "--noheader", "--array", "--jobs=" + job, "--format=%T %r"});
  QueueState state;
  if (said.status != 0) {  // a job that has been over for some minutes is not known any more
    if (said.text.find("Invalid job id") == std::string::npos) state.trouble = said.text;
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

void cancel(const std::string& job) {
  ask({"scancel", job});
}

}  // namespace blockweir::engine
