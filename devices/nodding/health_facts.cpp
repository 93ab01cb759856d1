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

std::string count(std::uint64_t good, std::uint64_t lost, std::uint64_t corrupt, std::uint64_t late)
{
    return std::to_string(good) + ", lost " + std::to_string(lost) + ", corrupt " + std::to_string(corrupt) +
           ", late " + std::to_string(late);
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
            facts.push_back({"", trouble, true});
    }
    const auto addLink = [&](const std::string& name, const std::string& what, const LinkHealth& link) {
        facts.push_back({name, fixed(link.rate, 1) + " " + what + "/s", false});
        facts.push_back({what, count(link.good, link.lost, link.corrupt, link.late), isBad(link)});
    };
    addLink("Laser", "scans", health.laser);
    addLink("Tilt unit", "angles", health.tilt);
    facts.push_back({"Load", fixed(100.0 * health.motor.load, 0) + " %", false});
    if (health.motor.voltage > 0.0)
        facts.push_back({"Supply", fixed(health.motor.voltage, 1) + " V", false});
    if (health.motor.temperature)
        facts.push_back({"Temperature", fixed(*health.motor.temperature, 0) + " °C", false});
    const std::chrono::duration<double, std::milli> skew = health.largestSkew;
    facts.push_back({"Largest skew", fixed(skew.count(), 1) + " ms", false});
    facts.push_back({"Tilt step", fixed(toDegrees(health.pitchStep), 3) + "°", false});
    facts.push_back({"Slices lost", std::to_string(health.slicesLost), health.slicesLost > 0});
    return facts;
}

}  // namespace planewright
