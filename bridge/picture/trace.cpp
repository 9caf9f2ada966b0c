// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <vector>

#include "bridge/process/programs.hpp"
#include "bridge/results/result_file.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct TracedSpan {
  std::string what;
  std::uint64_t window = 0;
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
};

struct TracedSide {
  std::string name;
  std::vector<TracedSpan> spans{};  ///< in order of time, none of which overlap
};

TracedSide read_side(const fs::path& file) {
  TracedSide side{file.stem().string()};
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto refuse = [&](std::size_t number) {
    throw std::invalid_argument(fmt::format(
        "{}:{}: found \"{}\"; expected what,window,from_ns,to_ns, times that do not decrease; make the run anew",
        file.string(), number, line));
  };
  if (line != "what,window,from_ns,to_ns") refuse(1);
  for (std::size_t number = 2; std::getline(stream, line); ++number) {
    TracedSpan span;
    const std::size_t comma = line.find(',');
    unsigned long long window = 0;
    long long from = 0;
    long long to = 0;
    char rest = 0;
    const bool whole = comma != std::string::npos &&
                       std::sscanf(line.c_str() + comma, ",%llu,%lld,%lld%c", &window, &from, &to, &rest) == 3;
    if (!whole && stream.peek() == std::ifstream::traits_type::eof()) break;  // a side that was killed
    if (!whole || from > to || (!side.spans.empty() && from < side.spans.back().to_ns)) refuse(number);
    side.spans.push_back({line.substr(0, comma), window, from, to});
  }
  return side;
}

/// Spans of one side, as events of process `pid`.
class SideEvents {
 public:
  SideEvents(json& events, int pid, std::int64_t zero_ns) : events_(events), pid_(pid), zero_ns_(zero_ns) {}

  void name(const std::string& name) {
    events_.push_back({{"name", "process_name"}, {"ph", "M"}, {"pid", pid_}, {"tid", 1}, {"args", {{"name", name}}}});
  }
  void span(const std::string& name, const char* kind, std::uint64_t window, std::int64_t from_ns, std::int64_t to_ns) {
    json event = at(name, kind, "X", from_ns);
    event["dur"] = static_cast<double>(to_ns - from_ns) / 1e3;
    event["args"]["window"] = window;
    events_.push_back(std::move(event));
  }
  /// One end of the arrow of a message.
  void arrow(const char* phase, const std::string& message, std::uint64_t window, std::int64_t at_ns) {
    json event = at(message, "message", phase, at_ns);
    event["id"] = fmt::format("{} {}", message, window);
    if (*phase == 'f') event["bp"] = "e";
    events_.push_back(std::move(event));
  }

 private:
  [[nodiscard]] json at(const std::string& name, const char* kind, const char* phase, std::int64_t at_ns) const {
    return {{"name", name}, {"cat", kind}, {"ph", phase},
            {"pid", pid_},  {"tid", 1},    {"ts", static_cast<double>(at_ns - zero_ns_) / 1e3}};
  }
  json& events_;
  int pid_;
  std::int64_t zero_ns_;
};

/// A window lasts until the side turns to the next one; what is neither sending nor waiting is computing.
void add_side(const TracedSide& side, SideEvents& events) {
  const std::string sends = side.name == "solid" ? "motion" : "load";
  const std::string gets = side.name == "solid" ? "load" : "motion";
  events.name(side.name);
  for (std::size_t i = 0; i < side.spans.size();) {
    std::size_t end = i;
    while (end < side.spans.size() && side.spans[end].window == side.spans[i].window) ++end;
    const std::uint64_t window = side.spans[i].window;
    const std::int64_t to_ns = end < side.spans.size() ? side.spans[end].from_ns : side.spans[end - 1].to_ns;
    events.span(fmt::format("window {}", window), "window", window, side.spans[i].from_ns, to_ns);
    for (; i < end; ++i) {
      const TracedSpan& span = side.spans[i];
      const std::int64_t next_ns = i + 1 < end ? side.spans[i + 1].from_ns : to_ns;
      events.span(span.what, "exchange", window, span.from_ns, span.to_ns);
      if (next_ns > span.to_ns) events.span("compute", "compute", window, span.to_ns, next_ns);
      const bool sent = span.what == "send";
      events.arrow(sent ? "s" : "f", sent ? sends : gets, window, sent ? span.from_ns : span.to_ns);
    }
  }
}

}  // namespace

json trace_of_sides(const fs::path& folder) {
  std::vector<TracedSide> sides;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".csv") sides.push_back(read_side(entry.path()));
  }
  std::erase_if(sides, [](const TracedSide& side) { return side.spans.empty(); });
  if (sides.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: found no trace of an exchange; expected the run of a scene with water in two processes; make "
                    "it with \"blockweir run SCENE --trace\"",
                    folder.string()));
  }
  const auto solid_first = [](const TracedSide& a, const TracedSide& b) {
    return std::pair(a.name != "solid", a.name) < std::pair(b.name != "solid", b.name);
  };
  std::sort(sides.begin(), sides.end(), solid_first);
  std::int64_t zero_ns = std::numeric_limits<std::int64_t>::max();
  for (const TracedSide& side : sides) zero_ns = std::min(zero_ns, side.spans.front().from_ns);
  json events = json::array();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    SideEvents of_side(events, static_cast<int>(i) + 1, zero_ns);
    add_side(sides[i], of_side);
  }
  return {{"displayTimeUnit", "ms"}, {"traceEvents", std::move(events)}};
}

fs::path trace(const fs::path& run) {
  const fs::path file = run / "trace.json";
  results::replace_file(file, trace_of_sides(process::trace_of(run)).dump() + "\n");
  return file;
}

}  // namespace blockweir::picture
