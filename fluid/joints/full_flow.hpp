// SPDX-License-Identifier: GPL-3.0-or-later
// Steady flow through joints that are full of water and have fixed apertures: linear, symmetric equations.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <string>
#include <vector>

#include "fluid/joints/network.hpp"

namespace blockweir::joints {

/// Nodes connected to a held node through open channels. Other inside nodes have no known water.
std::vector<bool> fed_nodes(const Network& network);

class FullFlow {
 public:
  FullFlow();
  ~FullFlow();

  /// Nodal pressures, negative where water would hang; 0 at nodes that are not fed. A factorization can serve other
  /// networks with the same nodes and channels and slightly different apertures.
  std::vector<double> pressures(const Network& network, const std::vector<bool>& fed, const WaterProperties& water);

  /// The matrix of the factorization, for a checkpoint; the restored factorization has the same bits.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

  void keep_factors(bool keep) { keeps_ = keep; }
  [[nodiscard]] long factorizations() const { return factorizations_; }
  [[nodiscard]] long kept() const { return used_again_; }  ///< solutions with a reused factorization

 private:
  /// Connects an unknown to another, or to a node with known potential (`other` -1).
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
  Eigen::SparseMatrix<double> factored_;  ///< matrix of factor_
  std::vector<Link> links_;
  struct Factor;
  std::unique_ptr<Factor> factor_;
  std::vector<int> pattern_;  ///< unknown of each node, -1: none; the symbolic analysis is for this pattern
  long factorizations_ = 0;
  long used_again_ = 0;
};

}  // namespace blockweir::joints
