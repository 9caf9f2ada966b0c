// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/dxf_entities.hpp"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <fstream>
#include <map>

#include "bridge/results/parse_number.hpp"

namespace blockweir::scene {
namespace {

class Entities {
 public:
  /// A group of the file that begins at this line.
  void take(int line, int code, const std::string& value) {
    if (code != 0) {
      if (code == 42 && number(value) != 0) bulged_ = true;
      values_[code] = value;
      return;
    }
    end();
    kind_ = value;
    line_ = line;
    values_.clear();
    bulged_ = false;
  }

  std::vector<DxfEntity> found;

 private:
  static double number(const std::string& text) { return results::parse_number<double>(text).value_or(0); }
  [[nodiscard]] double number(int code) const {
    const auto value = values_.find(code);
    return value == values_.end() ? 0 : number(value->second);
  }
  [[nodiscard]] std::string name(int code, const std::string& otherwise = "") const {
    const auto value = values_.find(code);
    return value == values_.end() ? otherwise : boost::to_lower_copy(value->second);
  }

  void end() {
    if (kind_ == "SECTION") section_ = name(2);
    for (const char* other : {"header", "classes", "tables", "objects"}) {
      if (section_ == other) return;
    }
    if (kind_ == "BLOCK") block_ = name(2);
    if (kind_ == "ENDBLK" || kind_ == "ENDSEC") block_.clear();
    if (kind_ == "VERTEX" && bulged_ && !found.empty() && found.back().kind == "POLYLINE") {
      found.back().kind += " with arcs";
    }
    for (const char* none : {"SECTION", "ENDSEC", "BLOCK", "ENDBLK", "VERTEX", "SEQEND"}) {
      if (kind_ == none) return;
    }
    const bool on_paper = number(67) != 0;
    if (on_paper) return;
    found.push_back({kind_ + why_not_read(), name(8, "0"), line_, block_, kind_ == "INSERT" ? name(2) : ""});
  }

  /// Of a polyline whose points are not those of the line that it draws.
  [[nodiscard]] std::string why_not_read() const {
    constexpr long fitted = 2 | 4;
    constexpr long mesh = 16 | 64;
    if (kind_ != "LWPOLYLINE" && kind_ != "POLYLINE") return "";
    const auto stated = values_.find(70);
    const long flags = stated == values_.end() ? 0 : results::parse_number<long>(stated->second).value_or(0);
    if (kind_ == "POLYLINE" && (flags & mesh) != 0) return " of a mesh";
    if (bulged_ || (kind_ == "POLYLINE" && (flags & fitted) != 0)) return " with arcs";
    return number(210) != 0 || number(220) != 0 || number(230) < 0 ? " in a turned plane" : "";
  }

  std::string section_;
  std::string block_;
  std::string kind_;
  int line_ = 0;
  bool bulged_ = false;
  std::map<int, std::string> values_;  ///< the last one of each group code
};

}  // namespace

std::vector<DxfEntity> entities_of_dxf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Entities entities;
  std::string code;
  std::string value;
  for (int line = 1; std::getline(stream, code) && std::getline(stream, value); line += 2) {
    const auto group = results::parse_number<int>(boost::trim_copy(code));
    entities.take(line, group.value_or(-1), boost::trim_copy(value));
  }
  return entities.found;
}

}  // namespace blockweir::scene
