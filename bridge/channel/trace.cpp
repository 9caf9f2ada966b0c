// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/trace.hpp"

#include <cstdlib>

namespace blockweir::channel {

std::unique_ptr<Trace> Trace::of(const std::string& role) {
  const char* const folder = std::getenv("BLOCKWEIR_TRACE");
  if (folder == nullptr || *folder == '\0') return nullptr;
  if (role.empty() || role.find('/') != std::string::npos) return nullptr;
  std::ofstream stream(std::string(folder) + "/" + role + ".csv");
  if (!(stream << "what,window,from_ns,to_ns\n")) return nullptr;
  return std::make_unique<Trace>(std::move(stream));
}

void Trace::add(const char* what, std::uint64_t window, Clock::time_point from, Clock::time_point to) {
  const auto ns = [](Clock::time_point at) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(at.time_since_epoch()).count();
  };
  stream_ << what << ',' << window << ',' << ns(from) << ',' << ns(to) << '\n';
}

}  // namespace blockweir::channel
