// SPDX-License-Identifier: GPL-3.0-or-later
// Steady flow through joints that are full of water and as wide as they are: linear, symmetric equations.
#pragma once

#include <Eigen/SparseCholesky>
#include <string>
#include <vector>

#include "fluid/joints/network.hpp"

namespace blockweir::joints {

/// Nodes that a held node reaches through open channels; inside nodes beyond have no water to tell of.
std::vector<bool> fed_nodes(const Network& network);

class FullFlow {
 public:
  /// Pressures by node, below 0 where the water would hang; 0 at nodes that are not fed. A factor of one network serves
  /// for others of the same nodes and channels whose apertures differ a little.
  std::vector<double> pressures(const Network& network, const std::vector<bool>& fed, const WaterProperties& water);

  /// What the factor was made of, for a checkpoint; restored, it is made again to the same bits.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

  void keep_factors(bool keep) { keeps_ = keep; }
  [[nodiscard]] long factorizations() const { return factorizations_; }
  [[nodiscard]] long kept() const { return used_again_; }  ///< solutions by a factor of one before

 private:
  /// From an unknown to another, or to a node whose potential is known (`other` -1).
  struct Link {
    int node;
    int other;
    double conductance;
    double potential;
  };
  void assemble(const Network& network, const std::vector<bool>& fed, const std::vector<int>& unknown,
                const WaterProperties& water);
  [[nodiscard]] Eigen::VectorXd inflow(const Eigen::VectorXd& x) const;
  bool refine(Eigen::VectorXd& x) const;
  void factorize(bool anew);

  bool keeps_ = true;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseMatrix<double> factored_;  ///< that factor_ is of
  std::vector<Link> links_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  std::vector<int> pattern_;  ///< unknown of each node, -1: none; what the analysis was made for
  long factorizations_ = 0;
  long used_again_ = 0;
};

}  // namespace blockweir::joints
