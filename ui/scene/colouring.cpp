// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/colouring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "ui/scene/trajectory_layer.h"

namespace planewright {

namespace {

/// Key colours of the scale "viridis" (van der Walt and Smith 2015), between which it is mixed.
constexpr std::array<Rgb, 6> kScale{
    {{68, 1, 84}, {64, 67, 135}, {41, 120, 142}, {34, 167, 132}, {121, 209, 81}, {253, 231, 37}}};

struct ClassColour {
    const char* name;
    Rgb light;
};
constexpr std::array<ClassColour, 5> kClasses{{{"floor", {140, 95, 50}},
                                               {"ceiling", {90, 110, 190}},
                                               {"wall", {40, 135, 110}},
                                               {"door", {190, 80, 150}},
                                               {"other", {115, 115, 115}}}};

std::string metres(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f m", std::abs(value) < 0.05 ? 0.0 : value);  // no "-0.0"
    return text.data();
}

std::string planeName(const ShownPlane& plane)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "P%02d", plane.plane->id);
    return plane.name.empty() ? std::string{text.data()} : std::string{text.data()} + " " + plane.name;
}

/// The places of planes that are not hidden in their order; where a legend has lines for some only, the largest before
/// the others.
std::vector<std::size_t> largestFirst(const ShownMap& map, std::size_t most)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < map.planes.size(); ++i) {
        if (!map.planes[i].hidden)
            places.push_back(i);
    }
    if (most == 0 || places.size() + 1 <= most)
        return places;
    const auto areaOf = [&map](std::size_t i) {
        const ShownPlane& plane = map.planes[i];
        return plane.outline ? plane.outline->outline.area : 0.0;
    };
    std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return areaOf(a) > areaOf(b); });
    std::sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most) - 1);
    return places;
}

/// What uncertainty's colours run from and over: three tenths of a millimetre to three centimetres.
constexpr double kLeastSigma = 0.3e-3;  // [m]
constexpr double kSigmaDecades = 2.0;
constexpr std::array<std::pair<double, const char*>, 5> kSigmaMarks{
    {{30e-3, "30 mm or more"}, {10e-3, "10 mm"}, {3e-3, "3 mm"}, {1e-3, "1 mm"}, {0.3e-3, "0.3 mm or less"}}};

double placeOfSigma(double sigma)
{
    return std::log10(std::max(sigma, kLeastSigma) / kLeastSigma) / kSigmaDecades;
}

int placeOfFloor(const ShownBuilding& building, int floor)
{
    return static_cast<int>(std::find(building.floors.begin(), building.floors.end(), floor) - building.floors.begin());
}

}  // namespace

Rgb scaleColour(double place)
{
    const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(kScale.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
    const double share = at - static_cast<double>(below);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * a + share * b));
    };
    const Rgb a = kScale[below];
    const Rgb b = kScale[below + 1];
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Rgb classColour(const std::string& className, Theme theme)
{
    Rgb colour = kClasses.back().light;
    for (const ClassColour& known : kClasses) {
        if (className.starts_with(known.name))
            colour = known.light;
    }
    if (theme == Theme::Light)
        return colour;
    const auto lighter = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel + (255 - channel) / 3); };
    return {lighter(colour.red), lighter(colour.green), lighter(colour.blue)};
}

Colouring::Colouring(const ShownMap& map, const LayerSettings& settings, Theme theme)
    : map_(&map), by_(settings.colourBy), mapBy_(settings.mapColourBy), palette_(settings.palette), theme_(theme)
{
    if (map.building) {
        colourBuilding();
        return;
    }
    planes_.reserve(map.planes.size());
    for (const ShownPlane& plane : map.planes)
        planes_.push_back(by_ == ColourBy::Class ? classColour(plane.className, theme)
                                                 : planeColour(plane.plane->id, palette_, theme));
    if (!map.snapshot)
        return;
    const SegmentLog& log = map.snapshot->segments;
    if (by_ == ColourBy::Step) {
        highest_ = std::max({1.0, static_cast<double>(map.plannedSteps) - 1.0, static_cast<double>(map.step)});
    } else if (by_ == ColourBy::Height) {
        bool first = true;
        for (std::size_t slice = 0; slice < log.slices(); ++slice) {
            for (const LineSegment& segment : log.slice(slice)) {
                const double low = std::min(segment.start.z(), segment.end.z());
                const double high = std::max(segment.start.z(), segment.end.z());
                lowest_ = first ? low : std::min(lowest_, low);
                highest_ = first ? high : std::max(highest_, high);
                first = false;
            }
        }
        highest_ = std::max(highest_, lowest_ + 0.1);
    }
}

void Colouring::colourBuilding()
{
    const ShownBuilding& building = *map_->building;
    for (std::size_t i = 0; i < map_->planes.size(); ++i) {
        const ShownMapPlane& plane = building.planes[i];
        switch (mapBy_) {
            case MapColourBy::Stop:
                planes_.push_back(planeColour(plane.firstStop, palette_, theme_));
                break;
            case MapColourBy::Floor:
                planes_.push_back(planeColour(placeOfFloor(building, plane.floor), palette_, theme_));
                break;
            case MapColourBy::Class:
                planes_.push_back(classColour(map_->planes[i].className, theme_));
                break;
            case MapColourBy::Uncertainty:
                planes_.push_back(scaleColour(placeOfSigma(plane.sigma)));
                break;
        }
    }
}

std::vector<LegendEntry> Colouring::legendOfBuilding() const
{
    const ShownBuilding& building = *map_->building;
    std::vector<LegendEntry> entries{{correctedWayColour(theme_), "way of the map"},
                                     {rawWayColour(theme_), "way by odometry"}};
    std::set<std::string> classes;
    std::set<int> stops;
    switch (mapBy_) {
        case MapColourBy::Stop:
            for (const ShownMapPlane& plane : building.planes)
                stops.insert(plane.firstStop);
            for (const int stop : stops)
                entries.push_back({planeColour(stop, palette_, theme_), "new at stop " + std::to_string(stop)});
            break;
        case MapColourBy::Floor:
            for (const int floor : building.floors)
                entries.push_back(
                    {planeColour(placeOfFloor(building, floor), palette_, theme_), "floor " + std::to_string(floor)});
            break;
        case MapColourBy::Class:
            for (const ShownPlane& plane : map_->planes)
                classes.insert(plane.className.empty() ? "other" : plane.className);
            for (const std::string& name : classes)
                entries.push_back({classColour(name, theme_), name});
            break;
        case MapColourBy::Uncertainty:
            for (const auto& [sigma, text] : kSigmaMarks)
                entries.push_back({scaleColour(placeOfSigma(sigma)), text});
            break;
    }
    return entries;
}

Rgb Colouring::of(int plane, ClusterId cluster, int step, double height) const
{
    switch (by_) {
        case ColourBy::Plane:
        case ColourBy::Class:
            return plane < 0 ? themeColours(theme_).unfitted : ofPlane(plane);
        case ColourBy::Cluster:
            return cluster == kNoCluster ? themeColours(theme_).unfitted : planeColour(cluster, palette_, theme_);
        case ColourBy::Step:
            return scaleColour((step - lowest_) / (highest_ - lowest_));
        case ColourBy::Height:
            return scaleColour((height - lowest_) / (highest_ - lowest_));
        case ColourBy::Uniform:
            break;
    }
    return planeColour(0, palette_, theme_);
}

std::vector<LegendEntry> Colouring::legend(std::size_t most) const
{
    std::vector<LegendEntry> entries;
    const auto scale = [&](auto textOf) {
        constexpr int kMarks = 5;
        for (int i = 0; i < kMarks; ++i) {
            const double place = static_cast<double>(kMarks - 1 - i) / (kMarks - 1);
            entries.push_back({scaleColour(place), textOf(lowest_ + place * (highest_ - lowest_))});
        }
    };
    if (map_->building) {
        entries = legendOfBuilding();
    } else if (by_ == ColourBy::Step) {
        scale([](double step) { return "step " + std::to_string(std::lround(step) + 1); });
    } else if (by_ == ColourBy::Height) {
        scale([](double height) { return metres(height); });
    } else if (by_ == ColourBy::Cluster) {
        if (map_->snapshot) {
            for (const auto& cluster : map_->snapshot->clusters)
                entries.push_back({planeColour(cluster->id, palette_, theme_), "C" + std::to_string(cluster->id)});
        }
        entries.push_back({themeColours(theme_).unfitted, "in no cluster"});
    } else if (by_ == ColourBy::Class) {
        std::set<std::string> classes;
        for (const ShownPlane& plane : map_->planes)
            classes.insert(plane.className.empty() ? "other" : plane.className);
        for (const std::string& name : classes)
            entries.push_back({classColour(name, theme_), name});
        entries.push_back({themeColours(theme_).unfitted, "no plane"});
    } else if (by_ == ColourBy::Plane) {
        for (const std::size_t i : largestFirst(*map_, most))
            entries.push_back({planes_[i], planeName(map_->planes[i])});
        entries.push_back({themeColours(theme_).unfitted, "no plane"});
    }
    if (entries.size() > most && most > 0) {
        const std::size_t left = entries.size() - most + 1;
        entries.resize(most - 1);
        entries.push_back({themeColours(theme_).unfitted, "and " + std::to_string(left) + " more"});
    }
    return entries;
}

}  // namespace planewright
