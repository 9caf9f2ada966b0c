// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/ascending_memory.hpp"

#include <sys/mman.h>

#include <new>

namespace blockweir::geometry {
namespace {

/// A range of addresses; memory stands behind those that have been written to.
class Region {
 public:
  Region() {
    for (size_ = std::size_t{1} << 33; size_ >= least; size_ /= 4) {  // where there is a limit, less
      void* const found =
          mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
      if (found == MAP_FAILED) continue;
      start_ = static_cast<std::byte*>(found);
      return;
    }
  }
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;
  ~Region() {
    if (start_ != nullptr) munmap(start_, size_);
  }

  void* take(std::size_t bytes) {
    constexpr std::size_t line = alignof(std::max_align_t);
    const std::size_t rounded = (bytes + line - 1) / line * line;
    if (start_ == nullptr || rounded > size_ - taken_) throw std::bad_alloc();
    void* const found = start_ + taken_;
    taken_ += rounded;
    ++parts_;
    return found;
  }
  void give_back() {
    if (--parts_ == 0) taken_ = 0;
  }

 private:
  static constexpr std::size_t least = std::size_t{1} << 24;
  std::byte* start_ = nullptr;
  std::size_t size_ = 0;
  std::size_t taken_ = 0;
  std::size_t parts_ = 0;
};

thread_local Region region;

}  // namespace

void* take_ascending(std::size_t bytes) {
  return region.take(bytes);
}

void give_back_ascending() {
  region.give_back();
}

}  // namespace blockweir::geometry
