// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/engine/slurm_engine.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "bridge/engine/batch_files.hpp"
#include "bridge/engine/slurm_queue.hpp"
#include "bridge/engine/stop_signals.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/results/shell_word.hpp"

namespace blockweir::engine {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

/// The last line that a task has said, for people.
std::string last_words(const fs::path& logs) {
  std::string last;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(logs, gone)) {
    if (entry.path().extension() != ".log") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      if (!line.empty()) last = entry.path().filename().string() + ": " + line;
    }
  }
  return last;
}

/// One perform(): what is missing is put into the queue, and again where a job leaves it undone.
class QueuedWork {
 public:
  QueuedWork(const Work& work, const OnAnswer& on_answer, const SlurmOptions& options)
      : work_(work),
        on_answer_(on_answer),
        options_(options),
        folder_(options.folder / (results::file_name(work.name) + ".slurm")),
        digests_(digests_of(work)) {
    for (std::size_t i = 0; i < digests_.size(); ++i) missing_[digests_[i]].push_back(i);
  }

  bool perform() {
    results::make_folder(folder_);
    take_up();
    if (!wait_for(former_job())) return false;
    constexpr int most_vain = 3;
    for (int vain = 0; !missing_.empty();) {
      const std::size_t before = missing_.size();
      if (signals_.next() != 0) return false;
      if (!wait_for(submit_missing())) return false;
      vain = missing_.size() < before ? 0 : vain + 1;
      if (vain == most_vain) give_up(vain);
    }
    std::error_code late;  // a log that is still written is no trouble
    fs::remove_all(folder_, late);
    return true;
  }
  [[nodiscard]] const Effort& effort() const { return effort_; }

 private:
  [[nodiscard]] fs::path job_file() const { return folder_ / "job"; }

  /// The job of a previous command that was stopped without its job; empty if there is none.
  [[nodiscard]] std::string former_job() const {
    std::ifstream stream(job_file());
    std::string job;
    stream >> job;
    return job;
  }

  std::string submit_missing() {
    std::vector<std::string> digests;
    std::vector<json> items;
    for (std::size_t i = 0; i < digests_.size(); ++i) {
      const auto found = missing_.find(digests_[i]);
      if (found == missing_.end() || found->second.front() != i) continue;  // each once
      digests.push_back(digests_[i]);
      items.push_back(work_.items[i]);
    }
    const bool first = options_.batch == 0 && measured_.items == 0 && items.size() > first_items;
    if (first) items.resize(first_items);
    digests.resize(items.size());
    const std::size_t batch = options_.batch > 0     ? static_cast<std::size_t>(options_.batch)
                              : measured_.items == 0 ? 1
                                                     : batch_size(items.size(), measured_);
    int number = 1;
    while (fs::exists(folder_ / fmt::format("batch-{}", number))) ++number;
    const BatchFiles files(folder_ / fmt::format("batch-{}", number));
    files.write(work_.common, batch, digests, items);
    const fs::path program = fs::read_symlink("/proc/self/exe");
    const fs::path script = files.folder() / "task.sh";
    results::write_file(
        script, fmt::format("#!/bin/sh\nexec {} work {} \"$SLURM_ARRAY_TASK_ID\"\n",
                            results::shell_word(program.string()), results::shell_word(files.folder().string())));
    logs_ = files.folder();
    const std::size_t tasks = (items.size() + batch - 1) / batch;
    const std::string job = submit(script, results::file_name(work_.name), tasks, logs_, options_.sbatch);
    results::replace_file(job_file(), job + "\n");
    fmt::print(stderr, "{}: job {} in the queue: {} of {}{}\n", work_.name, job, results::counted(tasks, "task"), batch,
               first ? ", to see how long one takes" : "");
    return job;
  }

  /// Until it has left the queue. False when stopped: it is taken out of the queue then.
  bool wait_for(const std::string& job) {
    constexpr int look_every_ms = 1000;
    constexpr double longest_silence_s = 600;
    if (job.empty()) return true;
    Clock::time_point answered = Clock::now();
    for (;;) {
      const QueueState state = state_of(job);
      take_up();
      if (state.over()) break;
      if (state.trouble.empty()) {
        answered = Clock::now();
      } else if (seconds_since(answered) > longest_silence_s) {
        throw std::runtime_error(fmt::format(
            "--engine slurm: the queue has not answered for {:.0f} s: \"{}\"; job {} may still be there, and "
            "what it does counts; the same command continues once the queue answers",
            longest_silence_s, state.trouble, job));
      }
      report_progress(state);
      pollfd stop{signals_.descriptor(), POLLIN, 0};
      ::poll(&stop, 1, look_every_ms);
      if (signals_.next() == 0) continue;
      take_out(job);
      return false;
    }
    fs::remove(job_file());
    take_up();
    return true;
  }

  /// The job's number is kept where it may still be there: the same command finds it again.
  void take_out(const std::string& job) {
    const std::string trouble = cancel(job);
    take_up();
    if (trouble.empty()) return static_cast<void>(fs::remove(job_file()));
    fmt::print(stderr, "{}: job {} may still be in the queue: \"{}\"; \"scancel {}\" takes it out\n", work_.name, job,
               trouble, job);
  }

  /// Passes on the answers that have arrived.
  void take_up() {
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder_, gone)) {
      if (!entry.is_directory()) continue;
      const Answers answers = BatchFiles(entry.path()).take(seen_[entry.path().filename().string()]);
      effort_.had_s += answers.effort.had_s;
      effort_.worked_s += answers.effort.worked_s;
      if (answers.measured.items > 0) {
        measured_.items += answers.measured.items;
        measured_.worked_s += answers.measured.worked_s;
        measured_.processors = answers.measured.processors;
      }
      for (const auto& [digest, answer] : answers.by_digest) {
        const auto found = missing_.find(digest);
        if (found == missing_.end()) continue;
        for (const std::size_t item : found->second) on_answer_(item, answer);
        missing_.erase(found);
      }
    }
  }

  void report_progress(const QueueState& state) {
    constexpr double report_every_s = 5;
    if (seconds_since(reported_) < report_every_s) return;
    reported_ = Clock::now();
    fmt::print(stderr, "{}: {} of {} missing; {} tasks run, {} wait{}{}\n", work_.name, missing_.size(),
               digests_.size(), state.running, state.waiting, state.reason.empty() ? "" : " (" + state.reason + ")",
               state.trouble.empty() ? "" : "; the queue does not answer: " + state.trouble);
  }

  [[noreturn]] void give_up(int vain) const {
    const std::string words = last_words(logs_);
    throw std::runtime_error(fmt::format(
        "--engine slurm: {} jobs in a row have left the queue without an answer, {} of {} are missing; {}; see "
        "the logs in {}, and whether all machines see that folder and {}; the same command continues",
        vain, missing_.size(), digests_.size(),
        words.empty() ? "the tasks have written no message" : "the last message of a task is \"" + words + "\"",
        logs_.string(), fs::read_symlink("/proc/self/exe").string()));
  }

  const Work& work_;
  const OnAnswer& on_answer_;
  const SlurmOptions& options_;
  fs::path folder_;
  std::vector<std::string> digests_;
  std::map<std::string, std::vector<std::size_t>> missing_;  ///< items by their digests
  std::map<std::string, std::set<std::string>> seen_;        ///< files of answers, by folder
  StopSignals signals_;
  fs::path logs_;
  Clock::time_point reported_ = Clock::now();
  Effort effort_;
  Measured measured_;
};

class SlurmEngine : public Engine {
 public:
  SlurmEngine(SlurmOptions options, int jobs, MakeWorker make)
      : options_(std::move(options)), here_(local_engine(jobs, std::move(make))) {
    require_slurm();
  }

  bool perform(const Work& work, const OnAnswer& on_answer) override {
    if (work.items.empty()) return true;
    if (work.brief) return here_->perform(work, on_answer);
    QueuedWork queued(work, on_answer, options_);
    const bool all = queued.perform();
    add(queued.effort());
    return all;
  }

 private:
  SlurmOptions options_;
  std::unique_ptr<Engine> here_;
};

/// What a task has of processors.
int processors_of_task() {
  const char* value = std::getenv("SLURM_CPUS_PER_TASK");
  return value == nullptr ? 1 : std::max(1, std::atoi(value));
}

std::string word_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "0" : value;
}

}  // namespace

std::unique_ptr<Engine> slurm_engine(SlurmOptions options, MakeWorker make) {
  return std::make_unique<SlurmEngine>(std::move(options), processors(), std::move(make));
}

int work_on_batch(const fs::path& folder, int task, const MakeWorker& make) {
  constexpr double left_every_s = 1;
  const BatchFiles files(folder);
  const BatchFiles::Task own = files.read(task);
  const std::string prefix = fmt::format("{}-", task);
  std::set<std::string> seen;
  const Answers former = files.take(seen, prefix);  // of this task before it was killed
  Work work{.name = fmt::format("task {}", task), .common = own.common, .items = {}};
  std::vector<std::string> digests;
  for (std::size_t i = 0; i < own.items.size(); ++i) {
    if (former.by_digest.contains(own.digests[i])) continue;
    work.items.push_back(own.items[i]);
    digests.push_back(own.digests[i]);
  }
  const int processors = processors_of_task();
  const auto engine = local_engine(processors, make);
  Answers answers;
  Clock::time_point left = Clock::now();
  int files_left = 0;
  std::size_t answers_made = 0;
  const auto leave = [&] {
    if (answers.by_digest.empty() && answers.effort.had_s == 0) return;
    files.leave(fmt::format("{}{}-{}-{}", prefix, word_of("SLURM_RESTART_COUNT"), ::getpid(), files_left++), answers);
    answers = {};
    left = Clock::now();
  };
  const bool all = engine->perform(work, [&](std::size_t i, const json& answer) {
    if (answer.is_null()) return;  // killed: whoever asked has it done again
    ++answers_made;
    answers.by_digest[digests[i]] = answer;
    if (seconds_since(left) >= left_every_s) leave();
  });
  answers.effort = engine->effort();
  answers.measured = {.items = answers_made, .worked_s = answers.effort.worked_s, .processors = processors};
  leave();
  return all ? 0 : 1;
}

}  // namespace blockweir::engine
