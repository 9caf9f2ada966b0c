// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/one_thread.hpp"

// Of the OpenMP that CHOLMOD was built with; <omp.h> would be the compiler's own.
extern "C" {
void omp_set_max_active_levels(int levels);
int omp_get_max_active_levels(void);
}

namespace blockweir::solid {

OneThread::OneThread() : before_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
}

OneThread::~OneThread() {
  omp_set_max_active_levels(before_);
}

}  // namespace blockweir::solid
