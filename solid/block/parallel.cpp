// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>

namespace blockweir::solid {
namespace {

using tbb::global_control;

std::unique_ptr<global_control> limit_to(std::size_t count) {
  return std::make_unique<global_control>(global_control::max_allowed_parallelism, std::max<std::size_t>(count, 1));
}

/// What stops a process comes to the thread that waits for it, never to one of TBB's, which would end the process or
/// leave that thread asleep.
void leave_stops_to_others(sigset_t* before = nullptr) {
  sigset_t stops;
  sigemptyset(&stops);
  for (const int stop : {SIGINT, SIGTERM}) sigaddset(&stops, stop);
  ::pthread_sigmask(SIG_BLOCK, &stops, before);
}

/// Of threads that others may have started.
class Workers : public tbb::task_scheduler_observer {
 public:
  Workers() { observe(true); }
  void on_scheduler_entry(bool is_worker) override {
    if (is_worker) leave_stops_to_others();
  }
};

/// A thread begins with the mask of the one that starts it, which is any that shares work.
class MayStartWorkers {
 public:
  MayStartWorkers() {
    static const auto* const workers = new Workers;  // for good: TBB's threads outlive what is static
    (void)workers;
    leave_stops_to_others(&before_);
  }
  ~MayStartWorkers() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  MayStartWorkers(const MayStartWorkers&) = delete;
  MayStartWorkers& operator=(const MayStartWorkers&) = delete;

 private:
  sigset_t before_{};
};

/// TBB starts one for each core.
std::unique_ptr<global_control>& limit() {
  const char* said = std::getenv("OMP_NUM_THREADS");
  const long count = said == nullptr ? 0 : std::strtol(said, nullptr, 10);
  static std::unique_ptr<global_control> first = count > 0 ? limit_to(static_cast<std::size_t>(count)) : nullptr;
  return first;
}

}  // namespace

std::size_t threads() {
  (void)limit();
  return global_control::active_value(global_control::max_allowed_parallelism);
}

void set_threads(std::size_t count) {
  const MayStartWorkers with_their_mask;
  limit().reset();  // of several the least holds
  limit() = limit_to(count);
}

void share(std::size_t count, std::size_t piece, void (*work)(const void* context, std::size_t first, std::size_t end),
           const void* context) {
  if (threads() == 1) return work(context, 0, count);
  const MayStartWorkers with_their_mask;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, piece),
                    [&](const auto& range) { work(context, range.begin(), range.end()); });
}

void share_by_place(std::size_t count, void (*work)(const void* context, std::size_t first, std::size_t end),
                    const void* context) {
  if (threads() == 1) return work(context, 0, count);
  const MayStartWorkers with_their_mask;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) { work(context, range.begin(), range.end()); },
      tbb::static_partitioner());
}

}  // namespace blockweir::solid
