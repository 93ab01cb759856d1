// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/plane.h"

namespace planewright {

void makeCanonical(Eigen::Vector3d& normal, double& distance)
{
    bool turn = distance < 0.0;
    if (distance == 0.0) {
        for (const int axis : {2, 1, 0}) {
            if (normal[axis] != 0.0) {
                turn = normal[axis] < 0.0;
                break;
            }
        }
    }
    if (turn) {
        normal = -normal;
        distance = -distance;
    }
    // No negative zeros: they would print as "-0".
    normal.array() += 0.0;
    distance += 0.0;
}

}  // namespace planewright
