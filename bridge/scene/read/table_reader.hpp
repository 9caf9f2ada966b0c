// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one TOML table key by key: types, ranges, defaults, and keys that nobody reads. Each kind of value has one
// short function, hence their number.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bridge/scene/names.hpp"
#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Allowed range of a number, as a test and in words.
struct Range {
  std::function<bool(double)> holds;
  const char* words;
};
Range any_number();
Range positive();
Range not_negative();
/// Range of a length in a drawing: above 0, below 1e6 m.
Range drawn_length();

/// A table of the file, with the keys that were read so far and its name for messages.
class TableKeys {
 public:
  /// `table` may be null (absent): then all keys take their defaults. `name` is used in messages, e.g. "[analysis]".
  TableKeys(Problems& problems, const toml::table* table, std::string name);
  /// Reports the keys that nobody read.
  ~TableKeys();
  TableKeys(const TableKeys&) = delete;
  TableKeys& operator=(const TableKeys&) = delete;

  [[nodiscard]] bool present() const { return table_ != nullptr; }
  [[nodiscard]] bool has(const char* key) const { return table_ != nullptr && table_->contains(key); }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Place place() const;
  [[nodiscard]] Place place(const char* key) const;
  /// Place of one entry of a list.
  [[nodiscard]] Place place(const char* key, std::size_t entry) const;
  /// Marks the key as known, whatever its value.
  void know(const char* key) { ask(key, false, ""); }

 protected:
  const toml::node* ask(const char* key, bool required, const std::string& expected);
  bool wrong(const char* key, const toml::node& node, const std::string& expected, const std::string& remedy = "");
  bool not_one_of(const char* key, const std::string& word, const std::vector<std::string>& known);

  Problems& problems_;
  const toml::table* table_;
  std::string name_;

 private:
  std::vector<std::string> asked_;
};

/// A wrong value is reported and leaves `into` unchanged. So does an absent key, unless it is required.
class TableReader : public TableKeys {
 public:
  using TableKeys::TableKeys;

  bool number(const char* key, double& into, const Range& range = any_number(), bool required = false);
  bool number(const char* key, std::optional<double>& into, const Range& range = any_number());
  /// A required list of at least `least` numbers.
  bool numbers(const char* key, std::vector<double>& into, const Range& range = any_number(), std::size_t least = 1);
  /// A required list of at least one number, flag or text, as --set takes them.
  bool settings(const char* key, std::vector<std::string>& into);
  bool integer(const char* key, int& into, int least, int most = 1'000'000);
  bool flag(const char* key, bool& into);
  bool text(const char* key, std::string& into, bool required = false);
  /// One of the known words; optional unless `required`.
  bool word(const char* key, std::string& into, const std::vector<std::string>& known, bool required = false);
  /// A list of `count` texts; without `count`, of at least one, or of any number if it `may_be_empty`.
  bool texts(const char* key, std::vector<std::string>& into, std::optional<std::size_t> count = {},
             bool may_be_empty = false);
  /// The same for an optional key; false if it is absent.
  bool texts_if_any(const char* key, std::vector<std::string>& into);
  /// Components xx, yy and xy.
  bool stress(const char* key, std::optional<Eigen::Vector3d>& into);
  /// Components along x and y, of any magnitude.
  bool vector(const char* key, Eigen::Vector2d& into);
  bool point(const char* key, Point& into, bool required = false);
  /// `least` (3 for an outline) to 10,000 points; empty if one is wrong.
  bool points(const char* key, std::vector<Point>& into, std::size_t least = 3);
  /// An optional list of outlines.
  bool outlines(const char* key, std::vector<std::vector<Point>>& into);
  /// A sub-table; null if it is wrong or absent.
  const toml::table* table(const char* key);
  /// A list of tables, at least one if required.
  std::vector<const toml::table*> tables(const char* key, bool required);
  /// `duration_s` is where a ramp without `to` ends.
  bool time_table(const char* key, std::optional<TimeTable>& into, double duration_s);
  /// An index into `names`; -1 if it is wrong or absent.
  int reference(const char* key, const Names& names, bool required = true);

  /// One of the given words, as an enum value.
  template <class Enum>
  void choice(const char* key, Enum& into, const std::vector<std::pair<const char*, Enum>>& words) {
    std::string word;
    if (!text(key, word)) return;
    std::vector<std::string> known;
    for (const auto& [name, value] : words) {
      known.emplace_back(name);
      if (word != name) continue;
      into = value;
      return;
    }
    not_one_of(key, word, known);
  }

 private:
  bool wrong_point(const std::string& key, const toml::node& node, const char* words);
  bool points_of(const char* key, const toml::node& node, std::vector<Point>& into, std::size_t least);
  bool rows(const char* key, TimeTable& into);
  bool ramp(TimeTable& into, double duration_s);
  bool wave(TimeTable& into);
};

/// The value if the node is a finite number.
std::optional<double> finite_number(const toml::node& node);

}  // namespace blockweir::scene
