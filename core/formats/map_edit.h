// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/problem_list.h"
#include "core/geometry/pose.h"
#include "core/types/error.h"
#include "core/types/plane.h"

namespace planewright {

/// A plane as a scan of the same file has it.
struct SeenPlane {
    int scan = 0;
    PlaneId plane = kNoPlane;
};

/// What the operator says of a stop in the map of several; its scan stays as it was recorded.
struct MapEdit {
    enum class Kind {
        Omit,      ///< it is no part of the map, while `on`
        Order,     ///< it comes right before another stop, or last
        Match,     ///< its plane is the one that another stop saw, or is one of its own
        Odometry,  ///< where wheels tell it to be, or that nobody knows
        Floor,     ///< where it is in the building, and its floor with it; or that this is left to odometry
    };
    Kind kind = Kind::Omit;
    int scan = 0;                  ///< of the stop, in its file
    bool on = true;                ///< of Omit
    std::optional<int> before;     ///< of Order: the scan that follows; none: it is last
    PlaneId plane = kNoPlane;      ///< of Match: of the stop's own
    std::optional<SeenPlane> as;   ///< of Match; none: no other plane is the same
    std::optional<Pose> odometry;  ///< of Odometry; none: unknown
    std::optional<Pose> place;     ///< of Floor; none: left to odometry
};
std::string_view name(MapEdit::Kind kind);

/// Whether edits of a file that are of this kind are those of a map.
bool isMapEditKind(std::string_view kind);

/// The payload of an edit as a file holds it.
std::string mapEditJson(const MapEdit& edit);

/// Reads an edit of a scan from its kind and payload. Errors (Unreadable) begin with `place`.
Result<MapEdit> readMapEditJson(int scan, std::string_view kind, std::string_view payload, const std::string& place);

/// An edit of a map as a file holds it.
struct StoredMapEdit {
    int seq = 0;  ///< rises with every edit of the file, those of planes among them
    MapEdit edit;
    bool undone = false;
};

class SqlDatabase;

/// Gives the edit's seq.
Result<int> insertMapEdit(SqlDatabase& database, const MapEdit& edit, bool undone);

/// The edits of the map of all scans, in their order. What cannot be used is left out and told to `problems`.
Result<std::vector<StoredMapEdit>> readMapEdits(SqlDatabase& database, ProblemList& problems);

/// The edits of the map that a file holds, and what of them cannot be used, beginning with the file's name.
struct ReadMapEdits {
    std::vector<StoredMapEdit> edits;
    std::vector<std::string> problems;
};

/// Errors: as of scansOfPwscan.
Result<ReadMapEdits> mapEditsOfPwscan(const std::string& path);

/// The edits that are not undone, in their order.
std::vector<MapEdit> editsInForce(const std::vector<StoredMapEdit>& edits);

}  // namespace planewright
