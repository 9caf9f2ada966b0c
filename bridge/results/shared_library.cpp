// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace blockweir::results {

void* symbol_of(const std::string& library, const std::string& name) {
  void* const opened = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const symbol = opened != nullptr ? ::dlsym(opened, name.c_str()) : nullptr;
  if (symbol != nullptr) return symbol;
  throw std::runtime_error(fmt::format(
      "cannot open a part of blockweir: {}; build or install all of it, and the packages that it needs", ::dlerror()));
}

}  // namespace blockweir::results
