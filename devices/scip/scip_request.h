// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planewright {

// Requests without parameters, as they are sent but for the line feed behind them.
inline constexpr std::string_view kScipIdentity = "VV";
inline constexpr std::string_view kScipLimits = "PP";
inline constexpr std::string_view kScipState = "II";
inline constexpr std::string_view kScipLaserOn = "BM";
inline constexpr std::string_view kScipQuit = "QT";
inline constexpr std::string_view kScipReset = "RS";       ///< laser off, clock to zero, all settings as after power-on
inline constexpr std::string_view kScipResetShort = "RT";  ///< as RS, but keeps the line's and the motor's speed
inline constexpr std::string_view kScipReboot = "RB";      ///< newer models only; sent twice within a second
inline constexpr std::string_view kScipTimeModeOn = "TM0";  ///< the laser is off meanwhile
inline constexpr std::string_view kScipTime = "TM1";        ///< what its clock shows, in time mode only
inline constexpr std::string_view kScipTimeModeOff = "TM2";
inline constexpr std::string_view kScipSpeak2 = "SCIP2.0";  ///< for lasers that begin with SCIP 1.1

/// SS: speed of a serial line [bit/s], up to 999,999. CR: speed of the motor, 0 to 99 in the device's own steps.
/// HS: high sensitivity. DB: simulated malfunction, 1 to 5, or 10 to end it.
std::string scipLineSpeed(int bitsPerSecond);
std::string scipMotorSpeed(int speed);
std::string scipSensitivity(bool high);
std::string scipSimulatedFault(int number);

/// A request with a tag behind it, which its reply repeats: 1 to 16 letters, digits, spaces or ". _ + @".
std::string withScipTag(std::string_view request, std::string_view tag);

/// What a measuring command asks for.
///
/// MD, MS, ME, ND and NE stream what is measured from now on; GD, GS, GE, HD and HE give what was measured last, and
/// know no interval and no count. ME, NE, GE and HE also give intensities; MS and GS send two characters a range
/// instead of three; ND, NE, HD and HE send up to three echoes a beam.
struct ScipMeasurement {
    std::string command = "MD";
    int first = 0;     ///< step, 0 to 9999
    int last = 0;      ///< step, counted too
    int cluster = 0;   ///< steps that share one value, their least; 0 and 1: each has its own
    int interval = 0;  ///< scans left out between two reports, 0 to 9
    int count = 0;     ///< scans in all, 1 to 99; 0: without end. In the echo of a scan: those still to come

    bool isStream() const { return command[0] == 'M' || command[0] == 'N'; }
    bool hasIntensity() const { return command[1] == 'E'; }
    bool isMultiEcho() const { return command[0] == 'N' || command[0] == 'H'; }
    int charactersPerRange() const { return command[1] == 'S' ? 2 : 3; }
    /// Values that a scan has: beams, or groups of them.
    int values() const;
};

/// The request, without a line feed. What it says must be within the limits above.
std::string scipRequest(const ScipMeasurement& measurement);

/// An echo or a request in its parts.
struct ScipEcho {
    std::string_view command;
    std::string_view parameters;
    std::string_view tag;  ///< behind ';', empty where there is none
};

/// Reads the line that a reply begins with; empty where no command of SCIP begins it, or what follows is no number and
/// no tag. The number may be too long or too short: a reply repeats mistakes of the request.
std::optional<ScipEcho> readScipEcho(std::string_view line);

/// Digits that the command needs behind it; empty for what is no command.
std::optional<std::size_t> scipParameterLength(std::string_view command);

/// Reads the parameters of a measuring command; empty where it is none or they are not of its form, or the last step
/// comes before the first.
std::optional<ScipMeasurement> readScipMeasurement(const ScipEcho& echo);

/// The most characters that a tag has.
inline constexpr std::size_t kScipTagLength = 16;

/// True for what may stand in a tag.
bool isScipTag(std::string_view text);

}  // namespace planewright
