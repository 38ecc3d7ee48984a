#pragma once

#include <Eigen/Core>
#include <string>

namespace pcvt {

/// Encodes sites as a .txt file: a comment, then one site "x y", or "x y z", per line in the order
/// of the input. read_sites() returns exactly the same sites.
///
/// Example usage:
///     output.stage("sites.txt", encode_sites(points));
///
/// @throws InternalError if a coordinate is not finite.
std::string encode_sites(const Eigen::Matrix2Xd& points);
std::string encode_sites(const Eigen::Matrix3Xd& points);

}  // namespace pcvt
