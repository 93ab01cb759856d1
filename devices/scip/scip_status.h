// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace planewright {

/// Versions of the protocol that give the same letters other meanings. SCIP 2.2: UST, UTM-30LX-EW.
enum class ScipVersion { V2_0, V2_2 };

/// The version that a VV reply's PROT names, "SCIP 2.2"; 2.0 where it names none that is known.
ScipVersion scipVersionOf(std::string_view protocol);

/// What a status is to whoever asked.
enum class ScipVerdict {
    Good,         ///< done, or data
    AlreadySo,    ///< it was so before
    NotNow,       ///< not in this state: it may be asked again
    Refused,      ///< the request is wrong for this laser, now and later
    Verifying,    ///< a stream pauses while the laser checks an error
    Resumed,      ///< a stream goes on after such a pause
    Malfunction,  ///< the laser says that it is broken
};

struct ScipMeaning {
    ScipVerdict verdict{};
    std::string_view text;  ///< "the laser cannot be switched on"
};

/// What a status means: of this command, and of this version of the protocol. An unknown one is Refused.
ScipMeaning scipMeaning(std::string_view command, std::string_view status, ScipVersion version);

/// "status 0E: unknown request", for people.
std::string describeScipStatus(std::string_view command, std::string_view status, ScipVersion version);

}  // namespace planewright
