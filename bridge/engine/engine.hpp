// SPDX-License-Identifier: GPL-3.0-or-later
// Many independent pieces of work, done by processes of this machine or of a cluster. The answers do not depend on the
// engine or on the order of the work.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::engine {

struct Work {
  std::string name;       ///< for messages and the queue
  nlohmann::json common;  ///< data shared by all items
  std::vector<nlohmann::json> items;
  bool brief = false;  ///< many short items that wait for each other: not worth a queue
};

/// Works on one item. Each working process makes one, from the shared data.
using Worker = std::function<nlohmann::json(const nlohmann::json& item)>;
using MakeWorker = std::function<Worker(const nlohmann::json& common)>;

/// Called with item and answer; the answer is null if the working process was killed.
using OnAnswer = std::function<void(std::size_t item, const nlohmann::json& answer)>;

/// The processes' time, and the part of it spent on items.
struct Effort {
  double had_s = 0;
  double worked_s = 0;
  /// Share lost to start, messages and waiting.
  [[nodiscard]] double lost() const { return had_s > 0 ? 1 - worked_s / had_s : 0; }
};

class Engine {
 public:
  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Calls `on_answer` once for each item, as they finish. False if SIGINT or SIGTERM stopped it; then some items are
  /// missing. Throws std::runtime_error if the work cannot continue.
  [[nodiscard]] virtual bool perform(const Work& work, const OnAnswer& on_answer) = 0;

  /// Of all work so far.
  [[nodiscard]] const Effort& effort() const { return effort_; }

 protected:
  void add(const Effort& more) {
    effort_.had_s += more.had_s;
    effort_.worked_s += more.worked_s;
  }

 private:
  Effort effort_;
};

/// Number of processes that the machine runs at once.
[[nodiscard]] int processors();

/// Runs up to `jobs` processes on this machine; each takes the next item when it has finished one.
std::unique_ptr<Engine> local_engine(int jobs, MakeWorker make);

}  // namespace blockweir::engine
