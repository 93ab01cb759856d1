// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/map_edits.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/files/file_kind.h"
#include "core/types/plane_words.h"

namespace planewright {

namespace {

/// The place of a scan among stops or inputs; their size where it is not there.
std::size_t placeOf(std::span<const StopInput> inputs, const std::string& path, int scan)
{
    const auto found = std::ranges::find_if(
        inputs, [&](const StopInput& input) { return input.path == path && input.choice.scan == scan; });
    return static_cast<std::size_t>(found - inputs.begin());
}

/// Moves a stop before another one of its file, or behind all.
void reorder(std::vector<StopInput>& inputs, std::size_t from, std::optional<std::size_t> before)
{
    StopInput moved = std::move(inputs[from]);
    inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(from));
    std::size_t to = inputs.size();
    if (before)
        to = *before > from ? *before - 1 : *before;
    inputs.insert(inputs.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
}

/// The place of a scan's stop in a floor's map.
std::optional<std::size_t> stopIn(const BuildingMap& map, std::span<const StopScan> stops, const std::string& path,
                                  int scan)
{
    for (std::size_t i = 0; i < map.stops.size(); ++i) {
        const StopScan& stop = stops[static_cast<std::size_t>(map.stops[i].stop->id)];
        if (stop.path == path && stop.scan == scan)
            return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> planeIn(const MapStop& stop, PlaneId id)
{
    const auto& planes = stop.stop->planes;
    const auto found = std::ranges::find(planes, id, &ObservedPlane::id);
    return found == planes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - planes.begin()));
}

std::string placeText(const std::string& path, int scan, PlaneId plane)
{
    return path + ", scan " + std::to_string(scan) + ", " + planeLabel(plane);
}

}  // namespace

Result<std::vector<StopEdit>> mapEditsOf(std::span<const std::string> paths, std::vector<std::string>& problems)
{
    std::vector<StopEdit> edits;
    for (const std::string& path : paths) {
        if (!suffixOf(path, {kPwscanSuffix}, ""))
            continue;
        const auto stored = mapEditsOfPwscan(path);
        if (!stored)
            return tl::unexpected{stored.error()};
        problems.insert(problems.end(), stored->problems.begin(), stored->problems.end());
        for (const MapEdit& edit : editsInForce(stored->edits))
            edits.push_back({path, edit});
    }
    return edits;
}

std::vector<StopInput> withEdits(std::vector<StopInput> inputs, std::span<const StopEdit> edits,
                                 std::vector<std::string>& problems)
{
    std::vector<std::pair<std::string, int>> omitted;
    const auto tell = [&problems](const StopEdit& edit, int scan) {
        problems.push_back(edit.path + ": an edit of the map names scan " + std::to_string(scan) +
                           ", which is not there; it is not applied");
    };
    for (const StopEdit& each : edits) {
        const MapEdit& edit = each.edit;
        if (edit.kind == MapEdit::Kind::Match || edit.kind == MapEdit::Kind::Floor)
            continue;
        const std::size_t place = placeOf(inputs, each.path, edit.scan);
        if (place == inputs.size()) {
            tell(each, edit.scan);
            continue;
        }
        if (edit.kind == MapEdit::Kind::Odometry) {
            inputs[place].odometry = edit.odometry;
        } else if (edit.kind == MapEdit::Kind::Omit) {
            std::erase(omitted, std::pair{each.path, edit.scan});
            if (edit.on)
                omitted.emplace_back(each.path, edit.scan);
        } else {
            std::optional<std::size_t> before;
            if (edit.before) {
                before = placeOf(inputs, each.path, *edit.before);
                if (*before == inputs.size()) {
                    tell(each, *edit.before);
                    continue;
                }
            }
            if (before != place)
                reorder(inputs, place, before);
        }
    }
    for (const auto& [path, scan] : omitted)
        inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(placeOf(inputs, path, scan)));
    return inputs;
}

std::map<int, Pose> floorsByHand(std::span<const StopScan> stops, std::span<const StopEdit> edits)
{
    std::map<int, std::pair<int, Pose>> ofFloors;  // the stop that was placed last, and where
    for (const StopEdit& each : edits) {
        if (each.edit.kind != MapEdit::Kind::Floor)
            continue;
        const auto stop = std::ranges::find_if(
            stops, [&](const StopScan& other) { return other.path == each.path && other.scan == each.edit.scan; });
        if (stop == stops.end())
            continue;
        if (each.edit.place)
            ofFloors[stop->floor] = {static_cast<int>(stop - stops.begin()), *each.edit.place};
        else
            ofFloors.erase(stop->floor);
    }
    std::map<int, Pose> ofStops;
    for (const auto& [floor, placed] : ofFloors)
        ofStops.insert(placed);
    return ofStops;
}

void matchByHand(MapBuilder& builder, std::span<const StopScan> stops, std::span<const StopEdit> edits,
                 std::vector<std::string>& problems)
{
    for (const StopEdit& each : edits) {
        const MapEdit& edit = each.edit;
        if (edit.kind != MapEdit::Kind::Match)
            continue;
        const BuildingMap& map = builder.map();
        const auto stop = stopIn(map, stops, each.path, edit.scan);
        if (!stop)
            continue;
        const std::string place = placeText(each.path, edit.scan, edit.plane);
        const auto plane = planeIn(map.stops[*stop], edit.plane);
        if (!plane || !map.stops[*stop].isPlaced()) {
            problems.push_back(place + ": this plane is not in the map; its match by hand is not applied");
            continue;
        }
        std::optional<std::size_t> target;
        if (edit.as) {
            const auto other = stopIn(map, stops, each.path, edit.as->scan);
            const auto seen = other ? planeIn(map.stops[*other], edit.as->plane) : std::nullopt;
            if (seen)
                target = map.stops[*other].matches[*seen].plane;
            if (!target) {
                problems.push_back(place + ": the map has no plane of " +
                                   placeText(each.path, edit.as->scan, edit.as->plane) +
                                   " that it was matched with; that match is not applied");
                continue;
            }
        }
        if (const auto matched = builder.match(*stop, *plane, target); !matched)
            problems.push_back(place + ": " + matched.error().message);
    }
}

}  // namespace planewright
