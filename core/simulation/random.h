// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <random>

namespace planewright {

/// Random numbers that are the same on every build: the distributions of the standard library are not. Neither is the
/// order in which arguments in parentheses are made: a call has one of them.
class Random {
public:
    /// A stream of its own for every seed and number, so that slices do not depend on one another.
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

    /// Uniform in [0, 1).
    double uniform();

    /// Uniform between two limits.
    double uniform(double low, double high);

    /// A whole number from first to last, both included.
    int integer(int first, int last);

    /// A pair of independent numbers of the standard normal distribution (Box and Muller 1958).
    struct Pair {
        double first;
        double second;
    };
    Pair normalPair();

private:
    std::mt19937_64 engine_;
};

}  // namespace planewright
