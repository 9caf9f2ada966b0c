// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/dxf_pairs.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bridge/results/parse_number.hpp"

namespace blockweir::scene {
namespace {

/// Within quotes, on one line.
std::string shown(std::string text) {
  constexpr std::size_t most = 40;
  if (text.size() > most) text = text.substr(0, most) + " ...";
  for (char& c : text) {
    if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
  }
  return '"' + text + '"';
}

bool is_real(int code) {
  return (code >= 10 && code < 60) || (code >= 110 && code < 150) || (code >= 210 && code < 240);
}
bool is_integer(int code) {
  return (code >= 60 && code < 80) || (code >= 90 && code < 100);
}

class Pairs {
 public:
  /// Returns whether the pair is valid; otherwise `fault` says what is wrong.
  bool take(int line, const std::string& code_text, const std::string& value) {
    const auto code = results::parse_number<int>(code_text);
    if (!code) return wrong(line, shown(code_text) + " as a group code", "a whole number");
    if (*code == 0) {
      if (!entity_ends()) return false;
      if (value == "EOF" && in_section_) {
        return wrong(line, "EOF after a section that has not ended", "ENDSEC before it: some of the drawing is lost");
      }
      if (value == "SECTION" || value == "ENDSEC") in_section_ = value == "SECTION";
      begin(line, value);
      return true;
    }
    if ((is_real(*code) && !results::parse_number<double>(value)) ||
        (is_integer(*code) && !results::parse_number<long>(value))) {
      return wrong(line + 1, fmt::format("{} after the group code {}", shown(value), *code),
                   is_real(*code) ? "a finite number" : "a whole number");
    }
    if (*code == 90) points_said_ = results::parse_number<long>(value);
    ++times_[*code];
    return true;
  }

  [[nodiscard]] bool at_end() const { return kind_ == "EOF"; }
  /// What is missing when the file has ended.
  DxfFault end(int last_line) {
    const std::string of = kind_.empty() ? "" : fmt::format(" in or after {} at line {}", shown(kind_), line_);
    if (!at_end()) wrong(last_line, "the end of the file" + of, "ENDSEC and EOF: the drawing is cut off");
    return fault;
  }

  DxfFault fault{};

 private:
  bool wrong(int line, const std::string& found, const std::string& expected) {
    fault = {line, found, expected};
    return false;
  }

  void begin(int line, const std::string& kind) {
    line_ = line;
    kind_ = kind;
    times_.clear();
    points_said_.reset();
  }

  /// Has what was begun all its coordinates?
  bool entity_ends() {
    static const std::map<std::string, std::vector<int>> needed = {
        {"LINE", {10, 20, 11, 21}}, {"POINT", {10, 20}}, {"VERTEX", {10, 20}}, {"LWPOLYLINE", {90, 10, 20}}};
    if (const auto kind = needed.find(kind_); kind != needed.end()) {
      for (const int code : kind->second) {
        if (times_[code] > 0) continue;
        return wrong(line_, fmt::format("{} without the group code {}", kind_, code), "all its coordinates");
      }
    }
    if (kind_ != "LWPOLYLINE" || (times_[10] == points_said_ && times_[20] == points_said_)) return true;
    return wrong(line_,
                 fmt::format("LWPOLYLINE of {} points with {} x and {} y", *points_said_, times_[10], times_[20]),
                 "as many of each as it states");
  }

  bool in_section_ = false;
  int line_ = 0;
  std::string kind_;           ///< of the entity that begins at line_
  std::map<int, long> times_;  ///< how often each group code came since
  std::optional<long> points_said_;
};

}  // namespace

DxfFault first_fault_of_dxf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !stream) throw std::runtime_error("it cannot be read");
  Pairs pairs;
  std::string code;
  std::string value;
  int line = 0;
  while (!pairs.at_end() && std::getline(stream, code)) {
    if (line == 0 && code.starts_with("AutoCAD Binary DXF")) return {1, "a binary drawing", "one of text (ASCII DXF)"};
    const bool whole = static_cast<bool>(std::getline(stream, value));
    if (!whole) return pairs.end(line + 1);
    if (!pairs.take(line + 1, boost::trim_copy(code), boost::trim_copy(value))) return pairs.fault;
    line += 2;
  }
  return pairs.end(line);
}

}  // namespace blockweir::scene
