// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/health_facts.h"

#include <algorithm>

#include "core/types/angle.h"
#include "core/types/angle_text.h"
#include "devices/fault_words.h"

namespace planewright {

namespace {

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

/// "laser-sum": "3 × a line with a wrong sum".
void addFaults(const FaultCounts& counts, std::vector<HealthFact>& facts)
{
    for (const auto& [code, count] : counts) {
        const std::string words{faultWords(code)};
        facts.push_back({code, std::to_string(count) + " ×" + (words.empty() ? "" : " " + words), false});
    }
}

}  // namespace

std::string motorText(const MotorState& motor)
{
    std::string text = "load " + fixedText(100.0 * motor.load, 0) + " %";
    if (motor.voltage > 0.0)
        text += ", " + fixedText(motor.voltage, 1) + " V";
    if (motor.temperature)
        text += ", " + fixedText(*motor.temperature, 0) + " °C";
    return text;
}

std::vector<HealthFact> factsOf(const NoddingHealth& health)
{
    std::vector<HealthFact> facts;
    // A motor's trouble is often that of its link.
    for (const std::string& trouble :
         {health.trouble, health.laser.trouble, health.tilt.trouble, health.motor.trouble}) {
        if (!trouble.empty() && std::ranges::find(facts, trouble, &HealthFact::value) == facts.end())
            facts.push_back({"", trouble, true, "▲ " + trouble});
    }
    const auto addLink = [&](const std::string& name, const std::string& what, const LinkHealth& link, bool isBrief) {
        const std::string rate = fixedText(link.rate, 1) + " " + what + "/s";
        facts.push_back({name, rate, false, isBrief ? rate : ""});
        facts.push_back({what, std::to_string(link.good) + ", " + losses(link), isBad(link),
                         isBrief       ? losses(link)
                         : isBad(link) ? what + " " + losses(link)
                                       : ""});
    };
    addLink("Laser", "scans", health.laser, true);
    addLink("Tilt unit", "angles", health.tilt, false);
    const std::string load = fixedText(100.0 * health.motor.load, 0) + " %";
    facts.push_back({"Load", load, false, "load " + load});
    if (health.motor.voltage > 0.0)
        facts.push_back({"Supply", fixedText(health.motor.voltage, 1) + " V", false});
    if (health.motor.temperature)
        facts.push_back({"Temperature", fixedText(*health.motor.temperature, 0) + " °C", false,
                         fixedText(*health.motor.temperature, 0) + " °C"});
    const std::chrono::duration<double, std::milli> skew = health.largestSkew;
    facts.push_back({"Largest skew", fixedText(skew.count(), 1) + " ms", false});
    facts.push_back({"Tilt step", fixedText(toDegrees(health.pitchStep), 3) + "°", false});
    facts.push_back({"Slices lost", std::to_string(health.slicesLost), health.slicesLost > 0});
    addFaults(health.laser.faults, facts);
    addFaults(health.tilt.faults, facts);
    return facts;
}

}  // namespace planewright
