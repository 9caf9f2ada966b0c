// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps OpenMP from using threads in loops that are too short for them.
#pragma once

namespace blockweir::solid {

/// During its lifetime, OpenMP's parallel regions on this thread use one thread. CHOLMOD requests four on any machine,
/// for loops of microseconds; half of a factorization's time was spent waking them.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_;
};

}  // namespace blockweir::solid
