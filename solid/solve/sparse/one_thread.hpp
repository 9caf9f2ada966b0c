// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps OpenMP from using threads in loops that are too short for them.
#pragma once

// Of the OpenMP that CHOLMOD was built with; <omp.h> would be the compiler's own.
extern "C" {
void omp_set_max_active_levels(int levels);
int omp_get_max_active_levels(void);
}

namespace blockweir::solid {

/// During its lifetime, OpenMP's parallel regions on this thread use one thread. CHOLMOD requests four on any machine,
/// for loops of microseconds; half of a factorization's time was spent waking them.
class OneThread {
 public:
  OneThread() : before_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_;
};

}  // namespace blockweir::solid
