// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture nlohmann_json::nlohmann_json
// Both sides of a run on one time axis: a trace that parses, whose spans nest, and whose clocks agree.
#include <fmt/format.h>

#include <fstream>
#include <map>

#include "bridge/picture/trace.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::trace_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Trace : public Processes {
 protected:
  /// Events of a kind of one process: Chrome's Trace Event Format, times in microseconds.
  static std::vector<json> events(const json& trace, int process, const std::string& phase) {
    std::vector<json> all;
    for (const json& event : trace["traceEvents"]) {
      if (event["pid"] == process && event["ph"] == phase) all.push_back(event);
    }
    return all;
  }
  static void expect_nested(const std::vector<json>& spans) {
    constexpr double rounding_us = 1e-2;
    std::vector<double> ends;
    double last = -1;
    for (const json& span : spans) {
      const double from = span["ts"];
      const double to = from + span["dur"].get<double>();
      EXPECT_GE(from, last - rounding_us) << span;
      last = from;
      while (!ends.empty() && ends.back() <= from + rounding_us) ends.pop_back();
      if (!ends.empty()) EXPECT_LE(to, ends.back() + rounding_us) << span;
      ends.push_back(to);
    }
  }
  void write(const std::string& side, const std::string& rows) const {
    fs::create_directories(folder / "trace");
    std::ofstream(folder / "trace" / (side + ".csv")) << "what,window,from_ns,to_ns\n" << rows;
  }
  [[nodiscard]] std::string refusal() const {
    try {
      (void)picture::trace_of_sides(folder / "trace");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Trace, OfARunParsesNestsAndHasOneClock) {
  for (const char* schedule : {"serial", "parallel", "improved"}) {
    SCOPED_TRACE(schedule);
    fs::remove_all(folder / "run");
    ASSERT_EQ(shell(programs + "/blockweir run " + cases +
                    "cracked-dam-upper --trace --out run --set coupling.schedule=" + schedule +
                    " --set analysis.duration_s=1"),
              0)
        << text("out");
    ASSERT_EQ(shell(programs + "/blockweir trace run"), 0) << text("out");
    EXPECT_THAT(text("out"), HasSubstr("run/trace.json"));
    const json trace = json::parse(text("run/trace.json"));
    std::map<std::string, std::pair<double, double>> solid_arrows;
    for (const int process : {1, 2}) {
      const auto spans = events(trace, process, "X");
      EXPECT_GT(spans.size(), 100U);
      expect_nested(spans);
    }
    EXPECT_EQ(events(trace, 1, "M").front()["args"]["name"], "solid");
    EXPECT_EQ(events(trace, 2, "M").front()["args"]["name"], "hydrostatic");
    // Nothing is heard before it is said, whichever side says it: the clocks agree to within a window's wait.
    std::map<std::string, double> said;
    for (const int process : {1, 2}) {
      for (const json& arrow : events(trace, process, "s")) said[arrow["id"]] = arrow["ts"];
    }
    std::size_t heard = 0;
    for (const int process : {1, 2}) {
      for (const json& arrow : events(trace, process, "f")) {
        ASSERT_TRUE(said.contains(arrow["id"])) << arrow;
        EXPECT_GE(arrow["ts"].get<double>(), said[arrow["id"]]) << arrow;
        ++heard;
      }
    }
    EXPECT_EQ(heard, said.size());
    EXPECT_GT(heard, 90U);
  }
}

TEST_F(Trace, HasTheFluidsOfStrangers) {
  const std::string kit = std::string(BLOCKWEIR_SOURCE) + "/bridge/kit/python/";
  const std::string run = programs + "/blockweir run " + cases +
                          "cracked-dam-upper --trace --set analysis.duration_s=0.2 " +
                          "--set fluid.model=external --out run --set 'fluid.external.command=[";
  for (const std::string& fluid :
       {"\"env\",\"PYTHONPATH=" + kit + "\",\"/usr/bin/python3\",\"" + kit + "upper_dam.py\"",
        "\"" + programs + "/kit_upper_dam_c\""}) {
    fs::remove_all(folder / "run");
    ASSERT_EQ(shell(run + fluid + "]'"), 0) << text("out");
    ASSERT_EQ(shell(programs + "/blockweir trace run"), 0) << text("out");
    const json trace = json::parse(text("run/trace.json"));
    EXPECT_THAT(events(trace, 2, "M").front()["args"]["name"].get<std::string>(), HasSubstr("rising water"));
    expect_nested(events(trace, 2, "X"));
    EXPECT_EQ(events(trace, 1, "s").size(), events(trace, 2, "f").size());
  }
}

TEST_F(Trace, OfARunWithoutOneIsRefused) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases + "cracked-dam-upper --out run --set analysis.duration_s=0.1"),
            0);
  EXPECT_EQ(shell(programs + "/blockweir trace run"), 2);
  EXPECT_THAT(text("out"), HasSubstr("found no trace of an exchange"));
  EXPECT_THAT(text("out"), HasSubstr("make it with \"blockweir run SCENE --trace\""));
}

TEST_F(Trace, PutsGapsDownAsComputingAndAllTimesOnOneAxis) {
  write("solid", "send,0,1000,2000\nwait,0,2000,9000\nsend,1,12000,13000\nwait,1,14000,15000\n");
  write("mine", "wait,0,500,3000\nsend,0,8000,8500\n");
  const json trace = picture::trace_of_sides(folder / "trace");
  const auto spans = events(trace, 1, "X");
  std::string told;
  for (const json& span : spans) {
    told +=
        fmt::format("{} {} {};", span["name"].get<std::string>(), span["ts"].get<double>(), span["dur"].get<double>());
  }
  EXPECT_EQ(
      told,
      "window 0 0.5 11;send 0.5 1;wait 1.5 7;compute 8.5 3;window 1 11.5 3;send 11.5 1;compute 12.5 1;wait 13.5 1;");
  EXPECT_EQ(events(trace, 2, "X").front()["ts"], 0);
}

TEST_F(Trace, WhoseFilesAreDamagedIsRefusedWithTheLine) {
  write("solid", "send,0,1000,2000\nwait,zero,2000,9000\nsend,1,12000,13000\n");
  EXPECT_THAT(refusal(), HasSubstr("solid.csv:3: found \"wait,zero,2000,9000\"; expected what,window,from_ns,to_ns"));
  write("solid", "send,0,1000,2000\nwait,0,500,9000\n");
  EXPECT_THAT(refusal(), HasSubstr("times that do not decrease"));
  write("solid", "send,0,1000,2000\nwait,0,20");  // its process was killed
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace blockweir::test::trace_test
