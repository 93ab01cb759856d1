// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/health_facts.h"

#include <charconv>

#include "core/types/angle.h"

namespace planewright {

namespace {

std::string fixed(double number, int digits)
{
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, digits).ptr};
}

std::string losses(const LinkHealth& link)
{
    return "lost " + std::to_string(link.lost) + ", corrupt " + std::to_string(link.corrupt) + ", late " +
           std::to_string(link.late);
}

/// One damaged in a hundred is a cable's fault.
bool isBad(const LinkHealth& link)
{
    return 100 * (link.corrupt + link.lost) > link.good;
}

}  // namespace

std::vector<HealthFact> factsOf(const NoddingHealth& health)
{
    std::vector<HealthFact> facts;
    for (const std::string& trouble : {health.laser.trouble, health.tilt.trouble, health.motor.trouble}) {
        if (!trouble.empty())
            facts.push_back({"", trouble, true, "▲ " + trouble});
    }
    const auto addLink = [&](const std::string& name, const std::string& what, const LinkHealth& link, bool isBrief) {
        const std::string rate = fixed(link.rate, 1) + " " + what + "/s";
        facts.push_back({name, rate, false, isBrief ? rate : ""});
        facts.push_back({what, std::to_string(link.good) + ", " + losses(link), isBad(link),
                         isBrief       ? losses(link)
                         : isBad(link) ? what + " " + losses(link)
                                       : ""});
    };
    addLink("Laser", "scans", health.laser, true);
    addLink("Tilt unit", "angles", health.tilt, false);
    const std::string load = fixed(100.0 * health.motor.load, 0) + " %";
    facts.push_back({"Load", load, false, "load " + load});
    if (health.motor.voltage > 0.0)
        facts.push_back({"Supply", fixed(health.motor.voltage, 1) + " V", false});
    if (health.motor.temperature)
        facts.push_back({"Temperature", fixed(*health.motor.temperature, 0) + " °C", false,
                         fixed(*health.motor.temperature, 0) + " °C"});
    const std::chrono::duration<double, std::milli> skew = health.largestSkew;
    facts.push_back({"Largest skew", fixed(skew.count(), 1) + " ms", false});
    facts.push_back({"Tilt step", fixed(toDegrees(health.pitchStep), 3) + "°", false});
    facts.push_back({"Slices lost", std::to_string(health.slicesLost), health.slicesLost > 0});
    return facts;
}

}  // namespace planewright
