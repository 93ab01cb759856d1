// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/formats/byte_reader.h"
#include "core/types/error.h"

namespace planewright {

/// What the header of a .pcd says, as far as it is needed.
struct PcdHeader {
    enum class Data { Ascii, Binary, Compressed };

    struct Field {
        std::string name;
        std::size_t size = 0;   ///< of one value [bytes]
        char type = 'F';        ///< F, I or U
        std::size_t count = 1;  ///< values of a point
    };

    std::vector<Field> fields;
    std::array<std::size_t, 3> coordinates{};  ///< which fields are x, y, z
    int columns = 0;
    int rows = 0;
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< [m]
    Data data = Data::Ascii;

    std::size_t points() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    std::size_t valuesOfPoint() const;
    std::size_t bytesOfPoint() const;
    /// Bytes of a point before a field.
    std::size_t offsetOf(std::size_t field) const;
    std::size_t valueBefore(std::size_t field) const;
};

/// Reads the lines up to and with DATA. Errors (Unreadable) name file, line and key.
Result<PcdHeader> readPcdHeader(ByteReader& reader, const std::string& fileName);

}  // namespace planewright
