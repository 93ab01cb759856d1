// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "devices/emulated/emulated_laser.h"

namespace planewright {

/// A wall 4 m in front, as wide and high as one can see, and nothing else.
inline Scene wallInFront()
{
    Scene scene;
    scene.name = "wall";
    RectangleSurface wall;
    wall.corner = {-500.0, 4.0, -500.0};
    wall.edgeU = {1000.0, 0.0, 0.0};
    wall.edgeV = {0.0, 0.0, 1000.0};
    wall.plane = 0;
    scene.rectangles.push_back(wall);
    scene.planes.push_back({0, "wall", {0.0, 1.0, 0.0}, 4.0});
    return scene;
}

/// The wall without errors, as a laser on the pitch axis itself sees it.
inline std::shared_ptr<const EmulatedView> viewOfWall()
{
    return std::make_shared<EmulatedView>(wallInFront(), SimulationNoise{}, 1, 0.0);
}

inline double level(std::chrono::nanoseconds /*at*/)
{
    return 0.5 * std::numbers::pi;
}

inline EmulatedLaserOptions laserOptions(const std::string& model = "UTM-30LX", std::vector<FaultAt> faults = {})
{
    EmulatedLaserOptions options;
    options.model = *emulatedLaserModel(model);
    options.faults = std::move(faults);
    return options;
}

/// An emulated laser that is spoken to byte by byte, without a link.
class LaserRig {
public:
    using Time = std::chrono::nanoseconds;

    explicit LaserRig(const EmulatedLaserOptions& options, std::function<double(Time)> pitch = level)
        : laser(*EmulatedLaser::make(viewOfWall(), std::move(pitch), options))
    {
    }

    void send(const std::string& text)
    {
        laser->receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now);
    }

    /// All that comes until a moment.
    std::string hear(Time until)
    {
        now = until;
        std::string text;
        for (const EmulatedOutput& output : laser->takeOutput(until)) {
            lastAt = output.at;
            text.append(output.bytes.begin(), output.bytes.end());
        }
        return text;
    }

    /// A request and what comes within 10 ms.
    std::string ask(const std::string& request)
    {
        send(request + "\n");
        return hear(now + std::chrono::milliseconds{10});
    }

    std::shared_ptr<EmulatedLaser> laser;
    Time now{0};
    Time lastAt{0};  ///< of the last bytes that came
};

}  // namespace planewright
