// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/plane_frame.h"

namespace planewright {

/// Two stretches side by side; ends[0] is the lower end along their direction, ends[1] the upper one.
struct Strip {
    std::size_t before;
    std::size_t after;
    struct End {
        double before;  ///< fraction on the earlier stretch
        double after;   ///< fraction on the later stretch
        bool stepped;   ///< both stretches end here, at places too different to be joined without further evidence
    };
    std::array<End, 2> ends;
};

/// The corners of a strip on its earlier and on its later stretch [m].
struct StripCorners {
    Eigen::Vector2d beforeLow;
    Eigen::Vector2d beforeHigh;
    Eigen::Vector2d afterLow;
    Eigen::Vector2d afterHigh;
};

/// Makes rings of strips. Strips that share a whole side become one ring: its winding number at any point is the sum
/// of theirs, so that the union stays the same and has far fewer rings to unite.
class RingChains {
public:
    explicit RingChains(std::size_t stretches) : chainAt_(stretches, kNone) {}

    void add(const Strip& strip, const StripCorners& corners);
    std::vector<PlanarRing> rings() const;

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    struct Chain {
        bool turned;  ///< the lower side is on the right
        std::array<Strip::End, 2> ends;
        PlanarRing low;   ///< its lower side from the first stretch to the last
        PlanarRing high;  ///< its upper side
    };

    std::vector<Chain> chains_;
    std::vector<std::size_t> chainAt_;  // per stretch: the chain whose last stretch it is
};

}  // namespace planewright
