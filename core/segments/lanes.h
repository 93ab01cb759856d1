// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// Inlines a lambda, which takes no attribute in brackets where it has parameters.
#define PLANEWRIGHT_INLINED __attribute__((always_inline))

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
        return folded([](const auto& a, const auto& b, auto& both) PLANEWRIGHT_INLINED { both = a + b; });
    }

    /// The largest lane.
    [[gnu::always_inline]] inline float largest() const
    {
        return folded([](const auto& a, const auto& b, auto& both) PLANEWRIGHT_INLINED { both = b > a ? b : a; });
    }

private:
    /// Puts the halves together until one lane is left.
    template <class Together>
    [[gnu::always_inline]] inline float folded(Together together) const
    {
        Register<4>::Floats four;
        if constexpr (Width == 4) {
            Register<4>::Floats first;
            Register<4>::Floats second;
            together(part[0], part[2], first);
            together(part[1], part[3], second);
            together(first, second, four);
        } else {
            Register<8>::Floats eight;
            if constexpr (Width == 8) {
                together(part[0], part[1], eight);
            } else {
                const Register<8>::Floats low = __builtin_shufflevector(part[0], part[0], 0, 1, 2, 3, 4, 5, 6, 7);
                const Register<8>::Floats high =
                    __builtin_shufflevector(part[0], part[0], 8, 9, 10, 11, 12, 13, 14, 15);
                together(low, high, eight);
            }
            const Register<4>::Floats low = __builtin_shufflevector(eight, eight, 0, 1, 2, 3);
            const Register<4>::Floats high = __builtin_shufflevector(eight, eight, 4, 5, 6, 7);
            together(low, high, four);
        }
        const Register<4>::Floats upper = __builtin_shufflevector(four, four, 2, 3, 2, 3);
        Register<4>::Floats two;
        together(four, upper, two);
        const float lower = two[0];
        const float higher = two[1];
        float one;
        together(lower, higher, one);
        return one;
    }
};

}  // namespace planewright
