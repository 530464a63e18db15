// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nanoflann.hpp>

#include <Eigen/Core>

namespace myoface {

/// Finds the columns of a matrix that are nearest to a point of `Dimensions` numbers. The matrix
/// must outlive the tree.
template <int Dimensions>
class PointTree {
public:
    using Columns = Eigen::Matrix<double, Dimensions, Eigen::Dynamic>;

    explicit PointTree(const Columns& columns)
        : adaptor_{columns}, tree_(Dimensions, adaptor_, {12}) {}
    PointTree(const PointTree&) = delete;
    PointTree& operator=(const PointTree&) = delete;

    /// The nearest `count` columns with their squared distances. @return how many there are
    std::size_t nearest(const double* point, std::size_t count, std::uint32_t* columns,
                        double* squared_distances) const {
        return tree_.knnSearch(point, count, columns, squared_distances);
    }

private:
    struct Adaptor {
        const Columns& columns;
        std::size_t kdtree_get_point_count() const {
            return static_cast<std::size_t>(columns.cols());
        }
        double kdtree_get_pt(std::size_t i, std::size_t axis) const {
            return columns(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(i));
        }
        template <typename Box>
        bool kdtree_get_bbox(Box&) const {
            return false;
        }
    };
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>,
                                                     Adaptor, Dimensions>;

    Adaptor adaptor_;
    Tree tree_;
};

}  // namespace myoface
