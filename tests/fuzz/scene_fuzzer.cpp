// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a scene: read, or refused with what was found and what is expected.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "bridge/scene/read/read.hpp"
#include "tests/fuzz/spoiler.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Half of the time as a writer of scenes would: changed bytes alone seldom get past the syntax.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string spoiled = blockweir::test::Spoiler(seed).spoil(std::string(data, data + size), 4);
  const std::size_t kept = std::min(spoiled.size(), most);
  std::memcpy(data, spoiled.data(), kept);
  return kept;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blockweir::scene;
  try {
    if (read_text(std::string(data, data + size), "fuzz.toml").scene.blocks.empty()) std::abort();
  } catch (const SceneError& error) {
    if (error.diagnostics().empty()) std::abort();
    for (const Diagnostic& d : error.diagnostics()) {
      if (d.found.empty() || d.expected.empty()) std::abort();
    }
  }
  return 0;
}
