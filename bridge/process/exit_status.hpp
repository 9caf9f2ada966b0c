// SPDX-License-Identifier: GPL-3.0-or-later
// How a program ends when its work throws.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "bridge/process/stopped.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/diagnostic.hpp"

namespace blockweir::process {

/// Has all that was said reached standard output? A full disk shows when the last of it is written.
inline bool output_is_written() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

/// Has whoever read standard output gone, as `head` does when it has enough?
inline bool reader_is_gone() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

/// The status that shells give a tool which a closed pipe ends: 128 + SIGPIPE. Nothing is said: nothing is wrong.
inline constexpr int closed_pipe = 141;

/// What `work` returns, 1 where that was 0 and standard output did not take what it said; where it throws, a message on
/// standard error and 130 when it was stopped, 2 when the scene or the command is wrong (SceneError,
/// std::invalid_argument), else 1. Plain fputs: where even the message cannot be written, the status says enough.
template <class Work>
int exit_status(const char* program, Work work) noexcept {
  const auto say = [program](const std::exception& error) {
    std::fputs(results::for_stderr(std::string(program) + ": " + error.what() + "\n").c_str(), stderr);
  };
  try {
    const int status = work();
    if (output_is_written()) return status;
    if (reader_is_gone()) return status == 0 ? closed_pipe : status;
    std::fputs(program, stderr);
    std::fputs(": standard output cannot be written: is the disk full?\n", stderr);
    return status == 0 ? 1 : status;
  } catch (const scene::SceneError& error) {
    std::fputs(results::for_stderr(std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  } catch (const std::invalid_argument& error) {
    say(error);
    return 2;
  } catch (const Stopped& stopped) {
    say(stopped);
    return stopped_status;
  } catch (const std::system_error& error) {
    if (error.code().value() == EPIPE && reader_is_gone()) return closed_pipe;
    say(error);
    return 1;
  } catch (const std::exception& error) {
    say(error);
    return 1;
  }
}

}  // namespace blockweir::process
