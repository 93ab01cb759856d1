// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/stop_tree.h"

#include <utility>

#include <Eigen/Cholesky>

namespace planewright {

void StopTree::addRoot()
{
    nodes_.emplace_back();
}

void StopTree::add(std::size_t parent, const Eigen::Vector3d& place, const Matrix6d& covariance)
{
    const Node& above = nodes_[parent];
    const Node& jump = nodes_[above.jump];
    Node node;
    node.parent = parent;
    node.depth = above.depth + 1;
    node.jump = above.depth - jump.depth == jump.depth - nodes_[jump.jump].depth ? jump.jump : parent;
    const Matrix6d toOrigin = carriedBy(-place);
    node.covariance = above.covariance + toOrigin * covariance * toOrigin.transpose();
    nodes_.push_back(node);
}

std::size_t StopTree::commonAncestor(std::size_t a, std::size_t b) const
{
    if (nodes_[a].depth < nodes_[b].depth)
        std::swap(a, b);
    while (nodes_[a].depth > nodes_[b].depth)
        a = nodes_[nodes_[a].jump].depth >= nodes_[b].depth ? nodes_[a].jump : nodes_[a].parent;
    while (a != b) {
        const bool apart = nodes_[a].jump != nodes_[b].jump;
        a = apart ? nodes_[a].jump : nodes_[a].parent;
        b = apart ? nodes_[b].jump : nodes_[b].parent;
    }
    return a;
}

void StopTree::link(std::size_t a, std::size_t b, const Eigen::Vector3d& place, const Matrix6d& covariance)
{
    constexpr std::size_t kMostLinks = 16;
    const Matrix6d toOrigin = carriedBy(-place);
    links_.push_back({a, b, toOrigin * covariance * toOrigin.transpose()});
    if (links_.size() > kMostLinks)
        links_.pop_front();
}

Matrix6d StopTree::between(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const
{
    return bestWay(a, b, place).covariance;
}

bool StopTree::isLinked(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const
{
    return bestWay(a, b, place).isLinked;
}

/// Covariance about the origin of the way along the tree.
Matrix6d StopTree::along(std::size_t a, std::size_t b) const
{
    return nodes_[a].covariance + nodes_[b].covariance - 2.0 * nodes_[commonAncestor(a, b)].covariance;
}

StopTree::Way StopTree::bestWay(std::size_t a, std::size_t b, const Eigen::Vector3d& place) const
{
    constexpr double kLever = 5.0;  // at which a turn counts as much as a shift [m]
    const Matrix6d carry = carriedBy(place);
    const auto at = [&](const Matrix6d& covariance) { return Matrix6d(carry * covariance * carry.transpose()); };
    const auto size = [&](const Matrix6d& covariance) {
        return covariance.bottomRightCorner<3, 3>().trace() +
               kLever * kLever * covariance.topLeftCorner<3, 3>().trace();
    };
    Way best{at(along(a, b)), false};
    for (const Link& link : links_) {
        for (const auto& [from, to] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}}) {
            const Matrix6d covariance = at(along(a, from) + link.covariance + along(to, b));
            if (size(covariance) < size(best.covariance))
                best = {covariance, true};
        }
    }
    return best;
}

std::vector<Vector6d> StopTree::corrections(std::size_t a, std::size_t b, const Vector6d& drift) const
{
    const std::size_t top = commonAncestor(a, b);
    const Matrix6d& common = nodes_[top].covariance;
    const Matrix6d way = nodes_[a].covariance + nodes_[b].covariance - 2.0 * common;
    const Vector6d weighted = way.ldlt().solve(drift);

    std::vector<Vector6d> found(nodes_.size(), Vector6d::Zero());
    std::vector<bool> onWay(nodes_.size(), false);
    onWay[top] = true;
    for (const auto& [end, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
        for (std::size_t stop = end; stop != top; stop = nodes_[stop].parent) {
            onWay[stop] = true;
            found[stop] = sign * (nodes_[stop].covariance - common) * weighted;
        }
    }
    // A parent comes before its children.
    for (std::size_t stop = 1; stop < nodes_.size(); ++stop) {
        if (!onWay[stop])
            found[stop] = found[nodes_[stop].parent];
    }
    return found;
}

}  // namespace planewright
