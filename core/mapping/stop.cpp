// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/stop.h"

namespace planewright {

ObservedPlane observedPlane(const Plane& plane, const Outline& outline)
{
    return {plane.id, {plane.normal, plane.distance, plane.covariance, plane.tangents}, outline.parts};
}

}  // namespace planewright
