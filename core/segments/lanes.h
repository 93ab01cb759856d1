// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// Lanes in which loops over scan points run, whatever the processor: sums then have the same bits on all.
inline constexpr int kLanes = 16;

/// A register of so many floats or integers, and the same at any address.
template <int Width>
struct Register;
template <>
struct Register<4> {
    using Floats [[gnu::vector_size(16)]] = float;
    using Integers [[gnu::vector_size(16)]] = int;
    using Anywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
    static constexpr Integers kNumbers{0, 1, 2, 3};
};
template <>
struct Register<8> {
    using Floats [[gnu::vector_size(32)]] = float;
    using Integers [[gnu::vector_size(32)]] = int;
    using Anywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
    static constexpr Integers kNumbers{0, 1, 2, 3, 4, 5, 6, 7};
};
template <>
struct Register<16> {
    using Floats [[gnu::vector_size(64)]] = float;
    using Integers [[gnu::vector_size(64)]] = int;
    using Anywhere [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = float;
    static constexpr Integers kNumbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
};

/// Sixteen lanes of floats in the registers of one kind of processor. Everything is inlined into a function for that
/// kind, and arguments are references: no register is ever passed.
template <int Width>
struct LanesOf {
    static constexpr int kParts = kLanes / Width;
    using Floats = typename Register<Width>::Floats;
    using Integers = typename Register<Width>::Integers;

    Floats part[kParts] = {};

    /// Σ over the lanes: halves are added until one is left.
    [[gnu::always_inline]] inline float sum() const
    {
        Register<4>::Floats four;
        if constexpr (Width == 4) {
            four = (part[0] + part[2]) + (part[1] + part[3]);
        } else {
            Register<8>::Floats eight;
            if constexpr (Width == 8)
                eight = part[0] + part[1];
            else
                eight = __builtin_shufflevector(part[0], part[0], 0, 1, 2, 3, 4, 5, 6, 7) +
                        __builtin_shufflevector(part[0], part[0], 8, 9, 10, 11, 12, 13, 14, 15);
            four =
                __builtin_shufflevector(eight, eight, 0, 1, 2, 3) + __builtin_shufflevector(eight, eight, 4, 5, 6, 7);
        }
        const Register<4>::Floats two = four + __builtin_shufflevector(four, four, 2, 3, 2, 3);
        return two[0] + two[1];
    }

    /// The largest lane.
    [[gnu::always_inline]] inline float largest() const
    {
        Floats most = part[0];
        for (int p = 1; p < kParts; ++p)
            most = part[p] > most ? part[p] : most;
        for (int half = Width / 2; half > 0; half /= 2) {
            const Integers other = Register<Width>::kNumbers ^ half;
            const Floats turned = __builtin_shuffle(most, other);
            most = turned > most ? turned : most;
        }
        return most[0];
    }
};

}  // namespace planewright
