// SPDX-License-Identifier: GPL-3.0-or-later
// Processes, not threads: a run has signals and children to itself, and one that crashes takes one item with it.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>

#include "bridge/engine/engine.hpp"
#include "bridge/engine/stop_signals.hpp"
#include "bridge/results/seconds.hpp"

namespace blockweir::engine {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// What all processes see: the next item, and the one that each works on.
class Counter {
 public:
  explicit Counter(std::size_t workers) : size_(sizeof(std::atomic<std::size_t>) * (workers + 2)) {
    void* memory = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory for the processes of a study; end other programs");
    at_ = static_cast<std::atomic<std::size_t>*>(memory);
    for (std::size_t i = 0; i < workers + 2; ++i) new (at_ + i) std::atomic<std::size_t>(i < 2 ? 0 : none);
  }
  ~Counter() { ::munmap(at_, size_); }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  std::size_t take(std::size_t worker) { return at_[worker + 2] = at_[0]++; }
  [[nodiscard]] std::size_t next() const { return at_[0]; }
  [[nodiscard]] std::size_t taken_by(std::size_t worker) const { return at_[worker + 2]; }
  void forget(std::size_t worker) { at_[worker + 2] = none; }
  void stop() { at_[1] = 1; }
  [[nodiscard]] bool stopped() const { return at_[1] != 0; }

 private:
  std::atomic<std::size_t>* at_ = nullptr;
  std::size_t size_;
};

struct Process {
  pid_t id = -1;
  int answers = -1;             ///< a pipe from it
  std::string unfinished_line;  ///< of an answer, received so far
};

void write_all(int to, const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t more = ::write(to, text.data() + sent, text.size() - sent);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) ::_exit(1);
    sent += static_cast<std::size_t>(more);
  }
}

/// Calls of one perform().
class Crew {
 public:
  Crew(const Work& work, const OnAnswer& on_answer, const MakeWorker& make, std::size_t size)
      : work_(work), on_answer_(on_answer), make_(make), counter_(size), crew_(size) {}

  ~Crew() {
    for (const Process& one : crew_) {
      if (one.id < 0) continue;
      ::kill(one.id, SIGTERM);
      ::close(one.answers);
      ::waitpid(one.id, nullptr, 0);
    }
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  bool perform() {
    for (std::size_t w = 0; w < crew_.size(); ++w) start(w);
    while (running_ > 0) listen();
    return !counter_.stopped();
  }
  [[nodiscard]] double worked_s() const { return worked_s_; }

 private:
  void start(std::size_t w) {
    if (counter_.next() >= work_.items.size() || counter_.stopped()) return;
    std::array<int, 2> ends{};
    std::fflush(nullptr);  // else both would write it
    const bool piped = ::pipe2(ends.data(), O_CLOEXEC) == 0;
    const pid_t parent = ::getpid();
    const pid_t child = piped ? ::fork() : -1;
    if (child == 0) become_worker(w, ends[1], parent);
    const int why = errno;
    if (piped) ::close(ends[1]);
    if (child > 0) {
      crew_[w] = {child, ends[0], ""};
      ++running_;
      return;
    }
    if (piped) ::close(ends[0]);
    if (running_ > 0) return;  // the others do its work
    throw std::runtime_error(fmt::format(
        "cannot start a process for \"{}\": {}; end other programs, or raise the limit of processes (ulimit -u)",
        work_.name, std::strerror(why)));
  }

  [[noreturn]] void become_worker(std::size_t w, int answers, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(127);  // gone before we said so
    ::setpgid(0, 0);                          // Ctrl-C reaches the parent alone, which passes it on
    signals_.restore();
    int status = 0;
    try {
      const Worker worker = make_(work_.common);
      for (std::size_t i = counter_.take(w); i < work_.items.size() && !counter_.stopped(); i = counter_.take(w)) {
        const Clock::time_point begun = Clock::now();
        const json answer = worker(work_.items[i]);
        write_all(answers, json{i, seconds_since(begun), answer}.dump() + "\n");
      }
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
      status = 1;
    } catch (...) {  // stopped: its item has no answer
      status = 1;
    }
    std::fflush(nullptr);
    ::_exit(status);
  }

  void listen() {
    std::vector<pollfd> sources{{signals_.descriptor(), POLLIN, 0}};
    std::vector<std::size_t> workers{none};
    for (std::size_t w = 0; w < crew_.size(); ++w) {
      if (crew_[w].id < 0) continue;
      sources.push_back({crew_[w].answers, POLLIN, 0});
      workers.push_back(w);
    }
    if (::poll(sources.data(), sources.size(), -1) < 0) return;
    if (const int signal = signals_.next(); signal != 0) {
      counter_.stop();
      for (const Process& one : crew_) {
        if (one.id > 0) ::kill(one.id, signal);
      }
    }
    for (std::size_t s = 1; s < sources.size(); ++s) {
      if (sources[s].revents != 0) read_answers(workers[s]);
    }
  }

  void read_answers(std::size_t w) {
    Process& one = crew_[w];
    std::array<char, 65536> buffer{};
    const ssize_t more = ::read(one.answers, buffer.data(), buffer.size());
    if (more < 0 && errno == EINTR) return;
    if (more <= 0) return end(w);
    one.unfinished_line.append(buffer.data(), static_cast<std::size_t>(more));
    for (auto at = one.unfinished_line.find('\n'); at != std::string::npos; at = one.unfinished_line.find('\n')) {
      const json line = json::parse(one.unfinished_line.substr(0, at));
      one.unfinished_line.erase(0, at + 1);
      worked_s_ += line[1].get<double>();
      if (counter_.stopped()) continue;  // it may be what it is because of the stop
      answered_[line[0].get<std::size_t>()] = true;
      on_answer_(line[0], line[2]);
    }
  }

  /// The item of one that was killed has no answer; another process takes the next.
  void end(std::size_t w) {
    ::close(crew_[w].answers);
    ::waitpid(crew_[w].id, nullptr, 0);
    crew_[w] = {};
    --running_;
    const std::size_t last = counter_.taken_by(w);
    counter_.forget(w);
    if (counter_.stopped()) return;
    if (last == none) {
      throw std::runtime_error(fmt::format(
          "a process for \"{}\" ended before it had begun; its message stands above; see whether memory is short",
          work_.name));
    }
    if (last < work_.items.size() && !answered_[last]) {
      answered_[last] = true;
      on_answer_(last, nullptr);
    }
    start(w);
  }

  const Work& work_;
  const OnAnswer& on_answer_;
  const MakeWorker& make_;
  StopSignals signals_;
  Counter counter_;
  std::vector<Process> crew_;
  std::vector<bool> answered_ = std::vector<bool>(work_.items.size(), false);
  std::size_t running_ = 0;
  double worked_s_ = 0;
};

class LocalEngine : public Engine {
 public:
  LocalEngine(int jobs, MakeWorker make) : jobs_(static_cast<std::size_t>(jobs)), make_(std::move(make)) {}

  bool perform(const Work& work, const OnAnswer& on_answer) override {
    if (work.items.empty()) return true;
    const Clock::time_point begun = Clock::now();
    const std::size_t size = std::min(jobs_, work.items.size());
    Crew crew(work, on_answer, make_, size);
    const bool all = crew.perform();
    add({static_cast<double>(size) * seconds_since(begun), crew.worked_s()});
    return all;
  }

 private:
  std::size_t jobs_;
  MakeWorker make_;
};

}  // namespace

int processors() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::unique_ptr<Engine> local_engine(int jobs, MakeWorker make) {
  return std::make_unique<LocalEngine>(jobs, std::move(make));
}

}  // namespace blockweir::engine
