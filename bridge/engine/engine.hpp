// SPDX-License-Identifier: GPL-3.0-or-later
// Many pieces of work that do not depend on each other, done by processes of this machine or of a cluster. Whoever asks
// gets the same answers from any engine, in whatever order they are done.
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
  nlohmann::json common;  ///< what holds for all items
  std::vector<nlohmann::json> items;
  bool brief = false;  ///< one of many short steps that wait for each other: not worth a queue
};

/// Does one item. Made once in each process that works, from what holds for all.
using Worker = std::function<nlohmann::json(const nlohmann::json& item)>;
using MakeWorker = std::function<Worker(const nlohmann::json& common)>;

/// Item and answer; null where the process that worked on it was killed.
using Heard = std::function<void(std::size_t item, const nlohmann::json& answer)>;

/// What processes had of time, and what of it they worked on items.
struct Effort {
  double had_s = 0;
  double worked_s = 0;
  /// Lost to start, messages and waiting.
  [[nodiscard]] double lost() const { return had_s > 0 ? 1 - worked_s / had_s : 0; }
};

class Engine {
 public:
  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// `heard` is called here, once for each item, as they end. False when SIGINT or SIGTERM has stopped it: some items
  /// are not heard of then. Throws std::runtime_error where work cannot go on.
  [[nodiscard]] virtual bool perform(const Work& work, const Heard& heard) = 0;

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

/// As many as the machine runs at once.
[[nodiscard]] int processors();

/// So many processes of this machine at once, each with its next item as soon as it is done with one.
std::unique_ptr<Engine> local_engine(int jobs, MakeWorker make);

}  // namespace blockweir::engine
