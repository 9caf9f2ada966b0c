// SPDX-License-Identifier: GPL-3.0-or-later
// The exit status of a program whose work may throw.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "bridge/process/stopped.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/diagnostic.hpp"

namespace blockweir::process {

/// Whether all output has reached standard output. A full disk is noticed only when the last of it is written.
inline bool output_is_written() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

/// Whether the reader of standard output has closed it, as `head` does.
inline bool reader_is_gone() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

/// The status that shells give a tool that a closed pipe ends: 128 + SIGPIPE. No message, since nothing is wrong.
inline constexpr int closed_pipe = 141;

/// The return value of `work`; 1 if that is 0 but standard output could not be written. If `work` throws, prints a
/// message on standard error and returns 130 if it was stopped, 2 if the scene or the command is wrong (SceneError,
/// std::invalid_argument), otherwise 1. Uses plain fputs: if even the message cannot be written, the status is enough.
template <class Work>
int exit_status(const char* program, Work work) noexcept {
  const auto say = [program](const std::exception& error) {
    std::fputs(results::for_stderr(std::string(program) + ": " + error.what() + "\n").c_str(), stderr);
  };
  const auto say_output_is_lost = [program] {
    std::fputs(program, stderr);
    std::fputs(": standard output cannot be written: is the disk full?\n", stderr);
  };
  try {
    const int status = work();
    if (output_is_written()) return status;
    if (reader_is_gone()) return status == 0 ? closed_pipe : status;
    say_output_is_lost();
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
  } catch (const std::bad_alloc&) {
    std::fputs(program, stderr);
    std::fputs(": not enough memory; make the model smaller, or raise the limit (ulimit -v)\n", stderr);
    return 1;
  } catch (const std::system_error& error) {
    if (error.code().value() == EPIPE && reader_is_gone()) return closed_pipe;
    if (std::ferror(stdout) != 0) {  // fmt would speak of a file
      say_output_is_lost();
    } else {
      say(error);
    }
    return 1;
  } catch (const std::exception& error) {
    say(error);
    return 1;
  }
}

}  // namespace blockweir::process
