// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/report/flow_data.hpp"

#include <algorithm>

#include "bridge/picture/flow_files.hpp"

namespace blockweir::picture {

using nlohmann::json;

json flow_data(const std::filesystem::path& run, const json& summary) {
  namespace column = uplift_column;
  constexpr std::size_t most = 20;
  const Rows totals = flow_rows(run, "flow.csv", summary);
  Rows joints = last_rows(flow_rows(run, "joint_uplift.csv", summary));
  if (joints.empty() || totals.size() < 2) return nullptr;
  std::stable_sort(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
    return number_in(a[column::uplift]) > number_in(b[column::uplift]);
  });
  json data = {{"time_s", number_in(joints.front()[0])},
               {"left_out", joints.size() > most ? joints.size() - most : 0},
               {"joints", json::array()},
               {"flows", json::array()}};
  joints.resize(std::min(joints.size(), most));
  for (const auto& row : joints) {
    const auto force = [&](std::size_t k) { return row[k].empty() ? json() : json(number_in(row[k])); };
    data["joints"].push_back({{"name", row[column::joint]},
                              {"length_m", number_in(row[column::length_m])},
                              {"flow_m2_per_s", number_in(row[column::flow])},
                              {"reynolds_number", number_in(row[column::reynolds])},
                              {"uplift_n_per_m", force(column::uplift)},
                              {"triangular_n_per_m", force(column::triangular)},
                              {"drained_n_per_m", force(column::drained)},
                              {"full_n_per_m", force(column::full)}});
  }
  for (std::size_t k = 1; k < totals.front().size(); ++k) {
    if (totals.front()[k].find("_m2_per_s") == std::string::npos) break;
    data["flows"].push_back({{"name", words_of_flow(totals.front()[k])}, {"m2_per_s", number_in(totals.back()[k])}});
  }
  return data;
}

}  // namespace blockweir::picture
