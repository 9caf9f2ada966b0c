// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/process_state.hpp"

#include <algorithm>
#include <fstream>
#include <string>

namespace blockweir::process {
namespace {

std::string proc(pid_t pid) {
  return "/proc/" + std::to_string(pid);
}

}  // namespace

std::vector<pid_t> family_of(pid_t pid) {
  std::vector<pid_t> family{pid};
  for (std::size_t i = 0; i < family.size(); ++i) {
    std::ifstream children(proc(family[i]) + "/task/" + std::to_string(family[i]) + "/children");
    for (pid_t child = 0; children >> child;) family.push_back(child);
  }
  return family;
}

bool is_stopped(const std::vector<pid_t>& family) {
  return std::any_of(family.begin(), family.end(), [](pid_t pid) {
    std::ifstream stat(proc(pid) + "/stat");
    std::string line;
    std::getline(stat, line);
    const std::size_t name_end = line.rfind(')');  // a name may hold anything
    return name_end != std::string::npos && line.compare(name_end, 4, ") T ") == 0;
  });
}

}  // namespace blockweir::process
