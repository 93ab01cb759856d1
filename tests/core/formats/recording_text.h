// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

/// The text of a small recording: 3 beams from 0° by 0.25°, 0.1 to 30 m.
inline std::string recordingText(const std::string& rows,
                                 const std::string& columns = "slice,time_s,pitch_deg,r0,r1,r2", int beams = 3)
{
    return "# format = nodding-laser-csv 1\n# scanner = UTM-30LX\n# bearing_start_deg = 0\n# bearing_step_deg = 0.25\n"
           "# beams = " +
           std::to_string(beams) + "\n# range_min_m = 0.1\n# range_max_m = 30\n# pitch_axis_offset_m = 0.05\n" +
           columns + "\n" + rows;
}

/// The column line of many beams.
inline std::string columnsOf(int beams)
{
    std::string columns = "slice,time_s,pitch_deg";
    for (int beam = 0; beam < beams; ++beam)
        columns += ",r" + std::to_string(beam);
    return columns;
}
