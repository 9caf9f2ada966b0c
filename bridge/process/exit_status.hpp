// SPDX-License-Identifier: GPL-3.0-or-later
// How a program ends when its work throws.
#pragma once

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "bridge/scene/diagnostic.hpp"

namespace blockweir::process {

/// What `work` returns; where it throws, a message on standard error and 2 when the scene or the command is wrong
/// (SceneError, std::invalid_argument), else 1. Plain fputs: where even the message cannot be written, the status says
/// enough.
template <class Work>
int exit_status(const char* program, Work work) noexcept {
  const auto say = [program](const std::exception& error) {
    std::fputs(program, stderr);
    std::fputs(": ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
  };
  try {
    return work();
  } catch (const scene::SceneError& error) {
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return 2;
  } catch (const std::invalid_argument& error) {
    say(error);
    return 2;
  } catch (const std::exception& error) {
    say(error);
    return 1;
  }
}

}  // namespace blockweir::process
