// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one TOML table key by key: types, defaults, and which keys nobody asked for.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/diagnostic.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Collects what is wrong with a file.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}
  void error(int line, std::string found, std::string expected, std::string remedy = "");
  void note(int line, std::string found, std::string remedy);
  [[nodiscard]] const std::vector<Diagnostic>& errors() const { return errors_; }
  [[nodiscard]] const std::vector<Diagnostic>& notes() const { return notes_; }

 private:
  std::string file_;
  std::vector<Diagnostic> errors_;
  std::vector<Diagnostic> notes_;
};

/// What a number has to be.
struct Range {
  std::function<bool(double)> holds;
  const char* words;
};
Range any_number();
Range positive();
Range not_negative();
Range between(double low, double high_excluded, const char* words);

class TableReader {
 public:
  /// `table` may be null (absent): all keys then take their defaults. `name` is how messages call it: "[analysis]".
  TableReader(Problems& problems, const toml::table* table, std::string name, int line = 0);
  /// Reports the keys that were never asked for.
  ~TableReader();
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  [[nodiscard]] bool present() const { return table_ != nullptr; }
  [[nodiscard]] bool has(const char* key) const { return table_ != nullptr && table_->contains(key); }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] int line(const char* key) const;

  void number(const char* key, double& into, const Range& range = any_number(), bool required = false);
  void number(const char* key, std::optional<double>& into, const Range& range = any_number());
  void integer(const char* key, int& into, int least);
  void flag(const char* key, bool& into);
  void text(const char* key, std::string& into, bool required = false);
  void texts(const char* key, std::vector<std::string>& into, std::size_t count);
  void point(const char* key, Point& into, bool required = false);
  void points(const char* key, std::vector<Point>& into);
  void time_table(const char* key, std::optional<TimeTable>& into, double duration_s);

  /// One of the given words.
  template <class Enum>
  void choice(const char* key, Enum& into, const std::vector<std::pair<const char*, Enum>>& words) {
    std::string word;
    text(key, word);
    if (word.empty()) return;
    std::vector<std::string> names;
    for (const auto& [name, value] : words) {
      names.emplace_back(name);
      if (word == name) {
        into = value;
        return;
      }
    }
    not_one_of(key, word, names);
  }

  /// An index into `names` for a key that names a block, a material or a joint; -1 when it is wrong.
  int reference(const char* key, const char* what, const std::vector<std::string>& names, bool required = true);

 private:
  const toml::node* ask(const char* key, bool required, const char* expected);
  void wrong_type(const char* key, const toml::node& node, const char* expected);
  void not_one_of(const char* key, const std::string& word, const std::vector<std::string>& names);
  bool read_point(const toml::node& node, Point& into);
  bool read_rows(const char* key, const toml::node& node, TimeTable& into);

  Problems& problems_;
  const toml::table* table_;
  std::string name_;
  int line_;
  std::vector<std::string> asked_;
};

/// The name of `word`'s nearest relative among `names` as a remedy: `did you mean "..."?`
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names);

int line_of(const toml::node& node);

}  // namespace blockweir::scene
