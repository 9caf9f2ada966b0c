// SPDX-License-Identifier: GPL-3.0-or-later
// Memory for CGAL whose addresses rise in the order of the requests. CGAL orders some of what it finds by address, so
// that with the usual memory a mesh depends on all that was allocated before it: on the length of the scene's text.
// Include it before any header of CGAL.
#pragma once

#ifdef CGAL_ALLOCATOR
#error "bridge/geometry/ascending_memory.hpp comes before the headers of CGAL"
#endif
#define CGAL_ALLOCATOR(T) blockweir::geometry::AscendingMemory<T>

#include <cstddef>

namespace blockweir::geometry {

/// Throws std::bad_alloc if there is no room. What has been given back is used again once all has been.
void* take_ascending(std::size_t bytes);
void give_back_ascending();

template <class T>
struct AscendingMemory {
  using value_type = T;
  AscendingMemory() = default;
  template <class Other>
  AscendingMemory(const AscendingMemory<Other>& /*other*/) {}  // NOLINT(google-explicit-constructor): an allocator's
  T* allocate(std::size_t count) { return static_cast<T*>(take_ascending(count * sizeof(T))); }
  void deallocate(T* /*memory*/, std::size_t /*count*/) { give_back_ascending(); }
  template <class Other>
  bool operator==(const AscendingMemory<Other>& /*other*/) const {
    return true;
  }
};

}  // namespace blockweir::geometry
