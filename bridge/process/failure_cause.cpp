// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/failure_cause.hpp"

#include <fmt/format.h>

#include "bridge/process/fluid_name.hpp"
#include "bridge/process/previous_run.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;

/// Then the logs, too, have no place for a last word, and whichever process is heard of first tells of another.
bool is_full(const fs::path& folder) {
  std::error_code unknown;
  const fs::space_info space = fs::space(folder, unknown);
  return !unknown && space.available < 4096;
}

/// What the loader, or ZeroMQ with its threads, says where memory is short.
bool lacks_memory(const std::string& line) {
  const auto has = [&](const char* words) { return line.find(words) != std::string::npos; };
  return has("failed to map segment") || has("cannot allocate") || has("Cannot allocate memory") ||
         has("Resource temporarily unavailable");
}

std::string text_without_memory(const ChildEnd& end) {
  return fmt::format(
      "not enough memory for the {} process to start (\"{}\"); free some, or raise the limit (ulimit -v)", end.name,
      end.last_line);
}

/// Whether it only tells of the other process, which has said the same or more itself.
bool is_echo(const ChildEnd& end) {
  const auto has = [&](const char* words) { return end.last_line.find(words) != std::string::npos; };
  return has("see its own message for the cause") || has(" process stopped in window ");
}

/// Whether `end` says more about the failure than the present cause.
bool says_more(const ChildEnd& end, const ChildEnd& cause) {
  return is_echo(cause) || (cause.external && !is_echo(end));
}

/// The first process that failed by itself, or the first after it that is not a consequence; null if none did. The
/// solid's message about an external fluid is preferred to the fluid's own: its form is known, and it contains that
/// text.
const ChildEnd* cause_of(const Supervised& supervised) {
  const ChildEnd* cause = nullptr;
  for (const ChildEnd& end : supervised.ends) {
    if ((end.exit_code == 0 && !end.early) || end.by_us) continue;
    if (cause == nullptr || (!end.last_line.empty() && says_more(end, *cause))) cause = &end;
  }
  return cause;
}

/// A program of the user's by its command, ours by what it computes.
std::string name_of(const ChildEnd& end) {
  return end.external ? external_fluid_name(end.words) : end.name + " process";
}

/// The last message of a user's program may have any form, so its name is put in front.
std::string end_of_external(const ChildEnd& end) {
  const std::string said = end.last_line.empty() ? "" : fmt::format(", its last line: \"{}\"", end.last_line);
  return fmt::format("the {} ended with exit status {}{}{}; {}all that it wrote is in {}.log",
                     external_fluid_name(end.words), end.exit_code, end.early ? " before the run was under way" : "",
                     said, end.early ? "it has to connect to BLOCKWEIR_ENDPOINT and to stay; " : "", end.name);
}

}  // namespace

std::string failure_cause(const Supervised& supervised, const fs::path& folder, double patience_s) {
  if (supervised.interrupted) {
    return has_frames(folder) ? "stopped on request; the results so far stand"
                              : "stopped on request before its first frame";
  }
  if (supervised.overdue) return "still running when its time was over";
  for (const ChildEnd& end : supervised.ends) {
    // A process that was killed says nothing itself.
    if (end.exit_code > 128 && !end.by_us) {
      if (!end.external && lacks_memory(end.last_line)) return text_without_memory(end);
      return fmt::format("the {} was ended by signal {}", name_of(end), end.exit_code - 128);
    }
  }
  for (const ChildEnd& end : supervised.ends) {
    if (end.stopped) {
      return fmt::format("the {} was stopped (SIGSTOP) and answered no more{}", name_of(end),
                         patience_s > 0 && supervised.ends.size() > 1
                             ? fmt::format("; timeout_s of [coupling], {:.4g} s, sets the patience", patience_s)
                             : "");
    }
  }
  const ChildEnd* cause = cause_of(supervised);
  if (cause == nullptr) return "";
  if (is_full(folder)) {
    return fmt::format("no room is left on the disk that holds {}; free some, or choose another folder with --out",
                       folder.string());
  }
  if (cause->external) return end_of_external(*cause);
  if (lacks_memory(cause->last_line)) return text_without_memory(*cause);
  if (!cause->last_line.empty()) return cause->last_line;
  return fmt::format("the {0} process ended with {1}, and {0}.log does not say why: is the disk full?", cause->name,
                     cause->exit_code);
}

}  // namespace blockweir::process
