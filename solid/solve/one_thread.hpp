// SPDX-License-Identifier: GPL-3.0-or-later
// OpenMP's threads, kept out of loops too short for them.
#pragma once

namespace blockweir::solid {

/// While it lives, OpenMP's parallel regions that this thread enters have one thread. CHOLMOD asks for four whatever
/// the machine has, for loops of microseconds: half of a factorization's time went into waking them.
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
