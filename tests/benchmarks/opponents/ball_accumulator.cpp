// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/ball_accumulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planewright {

BallAccumulator::BallAccumulator(double angle, double distanceStep, double maxDistance)
    : bands_(std::max(1, static_cast<int>(std::lround(std::numbers::pi / angle)))),
      distanceStep_(distanceStep),
      distances_(static_cast<std::size_t>(std::ceil(maxDistance / distanceStep)) + 1)
{
    int first = 0;
    for (int band = 0; band < bands_; ++band) {
        const double polar = std::numbers::pi * (band + 0.5) / bands_;
        pieces_.push_back(std::max(1, static_cast<int>(std::lround(2.0 * bands_ * std::sin(polar)))));
        firstOfBand_.push_back(first);
        first += pieces_.back();
    }
    slots_.assign(static_cast<std::size_t>(first) * distances_, -1);
}

const BallAccumulator::Cell* BallAccumulator::vote(const Eigen::Vector3d& normal, double distance)
{
    const auto place = static_cast<std::size_t>(distance / distanceStep_);
    if (place >= distances_)
        return nullptr;
    const double polar = std::acos(std::clamp(normal.z(), -1.0, 1.0)) / std::numbers::pi;
    const auto band = static_cast<std::size_t>(std::min(bands_ - 1, static_cast<int>(polar * bands_)));
    const double turn = std::atan2(normal.y(), normal.x()) / (2.0 * std::numbers::pi) + 0.5;
    const int piece = std::min(pieces_[band] - 1, static_cast<int>(turn * pieces_[band]));
    const std::size_t number = static_cast<std::size_t>(firstOfBand_[band] + piece) * distances_ + place;
    if (slots_[number] < 0) {
        slots_[number] = static_cast<int>(cells_.size());
        used_.push_back(number);
        cells_.emplace_back();
    }
    Cell& cell = cells_[static_cast<std::size_t>(slots_[number])];
    ++cell.votes;
    cell.normals += normal;
    cell.distances += distance;
    return &cell;
}

void BallAccumulator::clear()
{
    for (const std::size_t number : used_)
        slots_[number] = -1;
    used_.clear();
    cells_.clear();
}

}  // namespace planewright
