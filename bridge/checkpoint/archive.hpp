// SPDX-License-Identifier: GPL-3.0-or-later
// Serializes state to bytes and back with cereal: types with `serialize(archive)`, and compositions of them. C++17: the
// OpenFOAM plugin includes this.
#pragma once

#include <Eigen/Core>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>

namespace cereal {

/// Matrices of fixed size, and vectors of any size.
template <class Archive, class Scalar, int Rows, int Columns, int Options>
void serialize(Archive& archive, Eigen::Matrix<Scalar, Rows, Columns, Options>& matrix) {
  static_assert(Columns > 0);
  if constexpr (Rows == Eigen::Dynamic) {
    Eigen::Index rows = matrix.rows();
    archive(rows);
    matrix.resize(rows, Columns);
  }
  archive(binary_data(matrix.data(), sizeof(Scalar) * static_cast<std::size_t>(matrix.size())));
}

}  // namespace cereal

namespace blockweir::checkpoint {

template <class... Parts>
std::string pack(const Parts&... parts) {
  std::ostringstream bytes;
  cereal::BinaryOutputArchive{bytes}(parts...);
  return std::move(bytes).str();
}

/// Throws cereal::Exception if the bytes end too early.
template <class... Parts>
void unpack(const std::string& bytes, Parts&... parts) {
  std::istringstream stream(bytes);
  cereal::BinaryInputArchive{stream}(parts...);
}

}  // namespace blockweir::checkpoint
