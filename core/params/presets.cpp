// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/presets.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <string>

#include "core/params/registry.h"

namespace planewright {

const std::vector<Preset>& methodPresets()
{
    static const std::vector<Preset> presets{
        {"precise",
         "maximum likelihood from all points of a segment, one pitch error a slice, chi-square tests",
         {{"method.estimator", "likelihood"},
          {"noise.estimated", "true"},
          {"segments.split-distance", "0.01"},
          {"segments.split-sigmas", "4.5"},
          {"segments.min-length", "0"},
          {"segments.min-points", "4"},
          {"planes.flatness", "0.002"},
          {"planes.min-segments", "3"},
          {"planes.min-slices", "3"},
          {"planes.max-normal-sigma", "5"},
          {"planes.max-contested", "0.35"}}},
        {"paper", "the published method, with its formulas corrected: raw end points, metric thresholds", {}},
    };
    return presets;
}

const std::vector<Preset>& sensorPresets()
{
    static const std::vector<Preset> presets{
        {"utm-30lx",
         "Hokuyo UTM-30LX, 30 m",
         {{"noise.range-constant", "0.008"},
          {"noise.range-proportional", "0.001"},
          {"noise.bearing", "0.02"},
          {"noise.pitch", "0.084"}}},
        {"ust-20lx",
         "Hokuyo UST-20LX, 20 m",
         {{"noise.range-constant", "0.012"},
          {"noise.range-proportional", "0.001"},
          {"noise.bearing", "0.02"},
          {"noise.pitch", "0.084"}}},
        {"urg-04lx",
         "Hokuyo URG-04LX, 5.6 m",
         {{"noise.range-constant", "0.01"},
          {"noise.range-proportional", "0.005"},
          {"noise.bearing", "0.02"},
          {"noise.pitch", "0.15"},
          {"noise.systematic", "0.0015"}}},
        {"sick-lms200",
         "SICK LMS 200, 80 m",
         {{"noise.range-constant", "0.01"},
          {"noise.range-proportional", "0.0005"},
          {"noise.bearing", "0.02"},
          {"noise.pitch", "0.1"},
          {"noise.systematic", "0.0015"}}},
        // Depths come in steps that grow with their square, 75 mm at 5 m: what is off is off alike for all of a
        // surface.
        {"depth-camera",
         "depth camera of structured light (Kinect, Xtion), 5 m",
         {{"noise.range-constant", "0.002"},
          {"noise.range-proportional", "0.003"},
          {"noise.bearing", "0.02"},
          {"noise.pitch", "0.01"},
          {"noise.systematic", "0.01"}}},
    };
    return presets;
}

const Preset* findPreset(const std::vector<Preset>& presets, std::string_view name)
{
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.name == name; });
    return found == presets.end() ? nullptr : &*found;
}

const Preset* sensorOfScanner(std::string_view scanner)
{
    // Beginnings of the names that scanners and recordings give, in capitals and without blanks and signs.
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kKnown{{
        {"HOKUYOUTM30LX", "utm-30lx"},
        {"UTM30LX", "utm-30lx"},
        {"HOKUYOUST20LX", "ust-20lx"},
        {"UST20LX", "ust-20lx"},
        {"HOKUYOURG04LX", "urg-04lx"},
        {"URG04LX", "urg-04lx"},
        {"SICKLMS", "sick-lms200"},
        {"LMS2", "sick-lms200"},
        {"DEPTHCAMERA", "depth-camera"},
    }};
    std::string plain;
    for (const char c : scanner) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    for (const auto& [beginning, sensor] : kKnown) {
        if (std::string_view{plain}.starts_with(beginning))
            return findPreset(sensorPresets(), sensor);
    }
    return nullptr;
}

void apply(const Preset& preset, Parameters& parameters)
{
    for (const auto& [key, value] : preset.values) {
        [[maybe_unused]] const auto done = setParameter(parameters, key, value);
        assert(done);
    }
}

}  // namespace planewright
