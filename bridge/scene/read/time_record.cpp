// SPDX-License-Identifier: GPL-3.0-or-later
// A record is a text file of rows: numbers between commas, semicolons or blanks. Lines that begin with # or % are
// remarks, and the first other line may be a heading. Files of the PEER strong motion data base (.AT2) have a form of
// their own: three lines of text, a line with number and distance of the values, and then the values, several a row.
#include "bridge/scene/read/time_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "bridge/results/parse_number.hpp"
#include "bridge/scene/read/table_reader.hpp"

namespace blockweir::scene {
namespace {

constexpr std::size_t most_rows = 100'000;
constexpr std::size_t most_header = 200;

/// Which numbers of a row say what.
struct Layout {
  std::string file;
  int column = 2;                ///< of the value, the first being 1
  std::optional<double> step_s;  ///< between rows; without it the first column is the time
  bool column_stated = false;
  bool scale_stated = false;
  double scale = 1;
};

struct Row {
  double time = 0;
  double value = 0;
  int line = 0;  ///< of the file
};

/// What is wrong with a record, how it should be, and what to do.
struct Fault {
  std::string found;
  const char* expected;
  const char* remedy = "check the path and the file";
};

std::vector<std::string> fields_of(std::string line) {
  boost::trim(line);
  const bool marked = line.find_first_of(",;") != std::string::npos;
  std::vector<std::string> fields;
  boost::split(fields, line, boost::is_any_of(marked ? ",;" : " \t"),
               marked ? boost::token_compress_off : boost::token_compress_on);
  for (std::string& field : fields) boost::trim(field);
  return fields;
}

/// Words, and no number among them. "nan" is a value that is lacking, not a word.
bool is_heading(const std::vector<std::string>& fields) {
  const auto is_number = [](const std::string& field) {
    char* end = nullptr;
    std::strtod(field.c_str(), &end);
    return end != field.c_str() && *end == '\0';
  };
  const auto is_empty = [](const std::string& field) { return field.empty(); };
  return std::none_of(fields.begin(), fields.end(), is_number) && !std::all_of(fields.begin(), fields.end(), is_empty);
}

double number_in(const std::vector<std::string>& fields, std::size_t column, int line) {
  if (column >= fields.size()) {
    throw Fault{fmt::format("line {} has no column {}", line, column + 1), "the same columns in each row",
                "complete the row, or correct `column`"};
  }
  const std::string& field = fields[column];
  if (const auto value = results::parse_number<double>(field)) return *value;
  throw Fault{field.empty() ? fmt::format("line {} has nothing in column {}", line, column + 1)
                            : fmt::format("\"{}\" at line {} is not a number", field.substr(0, 40), line),
              "rows of finite numbers, between commas, semicolons or blanks",
              "fill in a value that is lacking from the rows beside it"};
}

/// What the fourth line of a PEER file states.
struct PeerHeader {
  std::size_t count = 0;
  double step_s = 0;
};

/// None if the file has no such line; the stream is at the line after it then, and else at the beginning.
std::optional<PeerHeader> peer_header(std::istream& stream) {
  static const std::regex form(R"(\s*NPTS\s*=\s*(\d{1,9})\s*,\s*DT\s*=\s*(\d*\.?\d+(?:E[-+]?\d+)?)\s*(?:SEC)?.*)",
                               std::regex::icase);
  constexpr int header_lines = 4;
  std::string line;
  for (int i = 0; i < header_lines; ++i) std::getline(stream, line);
  boost::trim(line);
  if (std::smatch found; stream && line.size() < most_header && std::regex_match(line, found, form)) {
    return PeerHeader{std::stoul(found[1]), std::stod(found[2])};
  }
  stream.clear();
  stream.seekg(0);
  return std::nullopt;
}

/// Throws a Fault.
std::vector<Row> peer_rows(std::istream& stream, const PeerHeader& header, const Layout& layout) {
  if (layout.step_s || layout.column_stated || !layout.scale_stated) {
    throw Fault{fmt::format("it is a PEER file, whose fourth line states NPTS and DT = {} s", header.step_s),
                "`scale` beside it, and neither step_s nor column",
                "write scale = 9.81 for values in g, as most of these files have; the third line names their unit"};
  }
  if (header.count > most_rows || !(header.step_s > 0)) {
    throw Fault{fmt::format("line 4 states {} values {} s apart", header.count, header.step_s),
                "up to 100000 values, some time apart"};
  }
  std::vector<Row> rows;
  int line_number = 4;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    boost::trim(line);
    if (line.empty()) continue;
    const auto fields = fields_of(line);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double time_s = static_cast<double>(rows.size()) * header.step_s;
      rows.push_back({time_s, layout.scale * number_in(fields, i, line_number), line_number});
    }
  }
  if (rows.size() != header.count) {
    throw Fault{fmt::format("it has {} values, and line 4 states NPTS = {}", rows.size(), header.count),
                "as many values as it states", "fetch the file again: it may be cut off"};
  }
  return rows;
}

/// Throws a Fault.
std::vector<Row> rows_of(std::istream& stream, const Layout& layout) {
  if (const auto header = peer_header(stream)) return peer_rows(stream, *header, layout);
  std::vector<Row> rows;
  const auto value_at = static_cast<std::size_t>(layout.column - 1);
  bool heading_allowed = true;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    constexpr const char* byte_order_mark = "\xEF\xBB\xBF";  // as spreadsheets begin a text in UTF-8
    if (++line_number == 1 && line.starts_with(byte_order_mark)) line.erase(0, 3);
    boost::trim(line);
    if (line.empty() || line[0] == '#' || line[0] == '%') continue;
    const auto fields = fields_of(line);
    if (std::exchange(heading_allowed, false) && is_heading(fields)) continue;
    if (line.find(',') != std::string::npos && line.find(';') != std::string::npos) {
      throw Fault{fmt::format("line {} has commas and semicolons", line_number),
                  "one of both between numbers, and decimal points", "put points for decimal commas"};
    }
    if (layout.step_s && !layout.column_stated && fields.size() > 1) {
      throw Fault{
          fmt::format("line {} has {} numbers, of which step_s makes the first the value", line_number, fields.size()),
          "one number a row where step_s is given, or `column`; without step_s the first column is the time",
          "leave step_s out, or state `column`; where a row has several values of one record, put one in each row"};
    }
    const double time =
        layout.step_s ? static_cast<double>(rows.size()) * *layout.step_s : number_in(fields, 0, line_number);
    if (!rows.empty() && time <= rows.back().time) {
      throw Fault{fmt::format("time goes from {} s to {} s at line {}", rows.back().time, time, line_number),
                  "times that increase from row to row", "put the rows in order, and give each time once"};
    }
    rows.push_back({time, layout.scale * number_in(fields, value_at, line_number), line_number});
    if (!std::isfinite(rows.back().value)) {
      throw Fault{fmt::format("the value at line {} is too large once scaled", line_number), "finite numbers",
                  "correct the value, or scale"};
    }
    if (rows.size() > most_rows)
      throw Fault{fmt::format("more than {} rows", most_rows), "a shorter record", "cut the record, or sample it anew"};
  }
  if (rows.size() < 2) throw Fault{rows.empty() ? "it has no row" : "it has one row", "two rows or more"};
  return rows;
}

void take_record(toml::table& described, const std::filesystem::path& folder, Problems& problems,
                 RecordSources& sources) {
  const Place place = problems.at(described.get("file")->source());
  Layout layout;
  {
    TableReader table(problems, &described, "a record in a file");
    if (!table.text("file", layout.file, true)) return;
    double step = 0;
    if (table.number("step_s", step, positive())) layout.step_s = step, layout.column = 1;
    layout.column_stated = table.integer("column", layout.column, 1);
    layout.scale_stated = table.number("scale", layout.scale);
  }
  const auto refuse = [&](const Fault& fault) {
    problems.error(place, fmt::format("the record {}: {}", layout.file, fault.found), fault.expected, fault.remedy);
  };
  if (!layout.step_s && layout.column_stated && layout.column == 1) {
    return refuse({"column 1 is the time", "the column of the value, from 2, or step_s", "correct `column`"});
  }
  const std::filesystem::path path = folder / layout.file;
  std::error_code failed;
  std::ifstream stream(path);
  if (!std::filesystem::exists(path, failed)) {
    return refuse({"there is no such file", "a file of rows, its path from the scene's folder", "correct the path"});
  }
  if (!std::filesystem::is_regular_file(path, failed) || !stream) {
    return refuse({"it cannot be read", "a file of rows", "check the path, and what you may read"});
  }
  try {
    toml::array table;
    RecordSource source{.file = layout.file};
    if (layout.scale_stated) source.scale = layout.scale;
    for (const Row& row : rows_of(stream, layout)) {
      table.push_back(toml::array{row.time, row.value});
      source.lines.push_back(row.line);
    }
    for (const char* key : {"file", "column", "step_s", "scale"}) described.erase(key);
    described.insert("table", std::move(table));
    sources.emplace(&described, std::move(source));
  } catch (const Fault& fault) {
    refuse(fault);
  }
}

void take_all(toml::table& file, const std::filesystem::path& folder, Problems& problems, RecordSources& sources) {
  for (auto&& [key, node] : file) {
    if (toml::table* table = node.as_table()) {
      const bool record = table->is_inline() && table->contains("file");
      record ? take_record(*table, folder, problems, sources) : take_all(*table, folder, problems, sources);
    } else if (toml::array* list = node.as_array()) {
      for (auto& entry : *list) {
        if (toml::table* section = entry.as_table()) take_all(*section, folder, problems, sources);
      }
    }
  }
}

}  // namespace

RecordSources take_records(toml::table& file, const std::filesystem::path& folder, Problems& problems) {
  RecordSources sources;
  take_all(file, folder, problems, sources);
  return sources;
}

}  // namespace blockweir::scene
