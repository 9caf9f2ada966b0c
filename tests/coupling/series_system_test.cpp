// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// blockweir-probability on structures that fail in several ways: the least of levels, of which another governs at the
// means than at the threshold. Ways of independent variables have P = 1 - prod(Phi(beta_i)).
#include <fcntl.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/processes.hpp"

namespace blockweir::test::series_system_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

double phi(double u) {
  return std::erfc(-u / std::sqrt(2)) / 2;
}

/// One way to fail: at level `steepness` (index + alpha.u), of variables of its own.
struct Way {
  std::vector<double> alpha;
  double index = 0;
  double steepness = 1;
};

double exact(const std::vector<Way>& ways) {
  double stands = 0;
  for (const Way& way : ways) stands += std::log1p(-phi(-way.index));
  return -std::expm1(stands);
}

double level(const std::vector<Way>& ways, const std::vector<double>& u) {
  double least = std::numeric_limits<double>::infinity();
  auto own = u.begin();
  for (const Way& way : ways) {
    double margin = way.index;
    for (const double alpha : way.alpha) margin += alpha * *own++;
    least = std::min(least, way.steepness * margin);
  }
  return least;
}

std::vector<Way> random_ways(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even;
  std::vector<Way> ways(2 + random() % 2);
  for (Way& way : ways) {
    way.alpha.resize(1 + random() % 2);
    double square = 0;
    for (double& alpha : way.alpha) square += std::pow(alpha = normal(random), 2);
    for (double& alpha : way.alpha) alpha /= std::sqrt(square);
    way.index = 2 + 4 * even(random);
    way.steepness = std::pow(10, -1.5 + 2 * even(random));
  }
  return ways;
}

class SeriesSystem : public Processes {
 protected:
  using Function = std::function<double(const std::vector<double>&)>;
  static json standard(std::size_t count) {
    return std::vector<json>(
        count, {{"distribution", "normal"}, {"mean", 0}, {"deviation", 1}, {"least", nullptr}, {"most", nullptr}});
  }
  static std::size_t variables_of(const std::vector<Way>& ways) {
    std::size_t count = 0;
    for (const Way& way : ways) count += way.alpha.size();
    return count;
  }

  void SetUp() override {
    Processes::SetUp();
    ASSERT_EQ(shell("mkfifo to from"), 0);
    program_ = start("sh -c 'exec " + programs + "/blockweir-probability <to >from'", "log");
    to_.open(folder / "to");
    from_.open(folder / "from");
  }
  void TearDown() override {
    to_.close();
    EXPECT_EQ(end_of(program_, 10), 0);
    Processes::TearDown();
  }

  /// Its answer, or trouble, at the threshold 0.
  json ask(const char* method, const json& variables, const Function& function) {
    say({{"do", method},
         {"seed", 1},
         {"variables", variables},
         {"correlations", json::array()},
         {"threshold", 0},
         {"samples", 1000}});
    for (std::string line; std::getline(from_, line);) {
      const json heard = json::parse(line);
      if (!heard.contains("evaluate")) return heard;
      json values = json::array();
      for (const auto& point : heard["evaluate"].get<std::vector<std::vector<double>>>()) {
        values.push_back(function(point));  // NaN is null
      }
      say({{"values", values}});
    }
    ADD_FAILURE() << text("log");
    return {};
  }

 private:
  void say(const json& line) { to_ << line.dump() << std::endl; }

  pid_t program_ = -1;
  std::ofstream to_;
  std::ifstream from_;
};

TEST_F(SeriesSystem, IsAnsweredByTheWayThatIsLikeliestNotByTheOneAtTheMeans) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<Way> ways = random_ways(seed);
    const double p = exact(ways);
    const json variables = standard(variables_of(ways));
    const Function function = [&](const auto& u) { return level(ways, u); };
    SCOPED_TRACE(fmt::format("seed {}, P {}", seed, p));
    const json form = ask("form", variables, function);
    ASSERT_TRUE(form.contains("answer")) << form;
    EXPECT_LE(form["answer"]["probability"].get<double>(), 1.001 * p);
    EXPECT_GE(form["answer"]["at_most"].get<double>(), 0.9 * p);
    EXPECT_LE(form["answer"]["at_most"].get<double>(), 1.1 * p);
    const json importance = ask("importance", variables, function);
    ASSERT_TRUE(importance.contains("answer")) << importance;
    const double found = importance["answer"]["probability"];
    const double half = found - importance["answer"]["interval"][0].get<double>();
    EXPECT_NEAR(found, p, 2 * half);  // 1.96 of its standard errors twice
    const json subset = ask("subset", variables, function);
    if (subset.contains("trouble")) {
      EXPECT_THAT(subset["trouble"].get<std::string>(), HasSubstr("its points miss the design point"));
    } else {
      EXPECT_NEAR(std::log10(subset["answer"]["probability"].get<double>() / p), 0, 1.5);
    }
  }
}

/// What governs at the means does not depend on the variable that fails.
TEST_F(SeriesSystem, IsFoundAtAnyDistance) {
  for (const double index : {3.6, 4.5, 6.0, 9.0, 12.0, 20.0}) {
    const std::vector<Way> ways{{{1}, 34, 0.2 / 5}, {{1}, index, 1}};
    const Function function = [&](const auto& u) { return level(ways, u); };
    const json form = ask("form", standard(2), function)["answer"];
    EXPECT_NEAR(form["index"].get<double>(), index, 1e-6);
    EXPECT_NEAR(std::log10(form["probability"].get<double>() / phi(-index)), 0, 1e-3);
    EXPECT_EQ(form["without_effect_at_means"], index < 0.04 * 34 ? json::array() : json::array({1}));
    const json sorm = ask("sorm", standard(2), function)["answer"];
    EXPECT_NEAR(sorm["breitung"]["index"].get<double>(), index, 1e-2);
    const json subset = ask("subset", standard(2), function);
    if (subset.contains("answer"))
      EXPECT_NEAR(std::log10(subset["answer"]["probability"].get<double>() / phi(-index)), 0, 1) << index;
  }
}

/// No step of a search leaves a distribution, and a point of no value far from the means spoils none.
TEST_F(SeriesSystem, IsSearchedWithinTheDistributions) {
  const json variables = {
      {{"distribution", "uniform"}, {"from", 0}, {"to", 0.9}, {"least", nullptr}, {"most", nullptr}},
      {{"distribution", "normal"}, {"mean", 40}, {"deviation", 5}, {"least", nullptr}, {"most", nullptr}}};
  double lowest = 1;
  const Function function = [&](const auto& x) {
    lowest = std::min(lowest, x[0]);
    return x[1] < 0 ? std::nan("") : x[1] + 20 * x[0] - 24;
  };
  const json form = ask("form", variables, function);
  ASSERT_TRUE(form.contains("answer")) << form;
  EXPECT_GE(lowest, 0);
  double p = 0;
  constexpr int steps = 10'000;
  for (int i = 0; i < steps; ++i) p += phi((24 - 20 * 0.9 * (i + 0.5) / steps - 40) / 5) / steps;
  EXPECT_NEAR(std::log10(form["answer"]["probability"].get<double>() / p), 0, 0.5);
  const json refused = ask("form", variables, [](const auto&) { return std::nan(""); });
  EXPECT_EQ(refused["at"].size(), 2U) << refused;
}

TEST_F(SeriesSystem, HasNoDesignPointWhereNoneIsAtTheThreshold) {
  const json form = ask("form", standard(1), [](const auto& u) { return u[0] < -2 ? -7.1 : u[0] + 3; });
  EXPECT_THAT(form.value("trouble", ""), HasSubstr("off that which is asked for")) << form;
}

}  // namespace
}  // namespace blockweir::test::series_system_test
