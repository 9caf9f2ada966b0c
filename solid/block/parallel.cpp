// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace blockweir::solid {
namespace {

struct Loop {
  std::size_t count;
  std::size_t pieces;
  void (*work)(const void* context, std::size_t first, std::size_t end);
  const void* context;
};

/// Threads that wait for a loop and take pieces of it. OpenMP's spin at the end of each loop: where another process has
/// one of two cores, a step of a wall of 1,000 blocks took a hundred times as long with them.
class Workers {
 public:
  void run(const Loop& loop, std::size_t threads) {
    if (taken_.test_and_set()) return loop.work(loop.context, 0, loop.count);  // by a loop of another thread
    std::unique_lock lock(mutex_);
    for (; started_ + 1 < threads; ++started_) std::thread([this, id = started_] { wait_for_loops(id); }).detach();
    loop_ = &loop;
    next_ = 0;
    wanted_ = threads - 1;
    begun_.notify_all();
    take_pieces(lock);
    ended_.wait(lock, [this] { return running_ == 0; });
    loop_ = nullptr;
    taken_.clear();
  }

 private:
  [[nodiscard]] bool open() const { return loop_ != nullptr && next_ < loop_->pieces; }

  void wait_for_loops(std::size_t id) {
    std::unique_lock lock(mutex_);
    for (;;) {
      begun_.wait(lock, [&] { return open() && id < wanted_; });
      take_pieces(lock);
      if (running_ == 0) ended_.notify_one();
    }
  }

  void take_pieces(std::unique_lock<std::mutex>& lock) {
    while (open()) {
      const Loop& loop = *loop_;
      const std::size_t piece = next_++;
      ++running_;
      lock.unlock();
      loop.work(loop.context, loop.count * piece / loop.pieces, loop.count * (piece + 1) / loop.pieces);
      lock.lock();
      --running_;
    }
  }

  std::atomic_flag taken_;
  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable ended_;
  const Loop* loop_ = nullptr;
  std::size_t next_ = 0;     ///< piece
  std::size_t running_ = 0;  ///< pieces
  std::size_t wanted_ = 0;   ///< workers
  std::size_t started_ = 0;
};

std::size_t threads_at_first() {
  const char* said = std::getenv("OMP_NUM_THREADS");
  const long count = said == nullptr ? 0 : std::strtol(said, nullptr, 10);
  return count > 0 ? static_cast<std::size_t>(count) : std::thread::hardware_concurrency();
}

std::atomic<std::size_t>& wanted_threads() {
  static std::atomic<std::size_t> count = std::clamp<std::size_t>(threads_at_first(), 1, 64);
  return count;
}

}  // namespace

std::size_t threads() {
  return wanted_threads();
}

void set_threads(std::size_t count) {
  wanted_threads() = std::max<std::size_t>(count, 1);
}

void share(std::size_t count, void (*work)(const void* context, std::size_t first, std::size_t end),
           const void* context) {
  constexpr std::size_t piece = 500;
  constexpr std::size_t most_pieces = 32;
  const std::size_t on = threads();
  if (on == 1) return work(context, 0, count);
  static Workers& workers = *new Workers;  // they wait on when the process ends
  workers.run({count, std::clamp<std::size_t>(count / piece, 1, most_pieces), work, context}, on);
}

}  // namespace blockweir::solid
