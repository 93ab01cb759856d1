// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// A reader of binary little-endian PLY of its own: it knows the format's rules and nothing of who wrote the file.
/// A list property `name` gives its values under `name.0`, `name.1`, …
struct PlyFile {
    struct Element {
        std::string name;
        std::vector<std::string> properties;                ///< in order, with their types: "double x"
        std::vector<std::map<std::string, double>> values;  ///< one map for each
    };
    std::vector<Element> elements;
    std::size_t bytesLeft = 0;
};

/// A little-endian value of a PLY or PCD type.
inline double takeValue(const std::string& bytes, std::size_t& at, const std::string& type)
{
    const auto take = [&]<class Number>(Number number) {
        std::memcpy(&number, bytes.data() + at, sizeof number);
        at += sizeof number;
        return static_cast<double>(number);
    };
    if (type == "double")
        return take(double{});
    if (type == "float")
        return take(float{});
    if (type == "int")
        return take(int{});
    return take(static_cast<unsigned char>(0));  // uchar
}

inline PlyFile parsePly(const std::string& bytes)
{
    PlyFile file;
    const std::size_t end = bytes.find("end_header\n");
    std::istringstream header(bytes.substr(0, end));
    std::vector<std::size_t> counts;
    std::string line;
    std::getline(header, line);
    if (line != "ply" || !std::getline(header, line) || line != "format binary_little_endian 1.0")
        return file;
    while (std::getline(header, line)) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "element") {
            file.elements.emplace_back();
            counts.emplace_back();
            words >> file.elements.back().name >> counts.back();
        } else if (word == "property")
            file.elements.back().properties.push_back(line.substr(9));
    }
    std::size_t at = end + 11;
    for (std::size_t i = 0; i < file.elements.size(); ++i) {
        auto& element = file.elements[i];
        for (std::size_t n = 0; n < counts[i]; ++n) {
            std::map<std::string, double> values;
            for (const std::string& property : element.properties) {
                std::istringstream words(property);
                std::string type, countType, name;
                words >> type;
                if (type != "list") {
                    words >> name;
                    values[name] = takeValue(bytes, at, type);
                    continue;
                }
                words >> countType >> type >> name;
                const int count = static_cast<int>(takeValue(bytes, at, countType));
                for (int k = 0; k < count; ++k)
                    values[name + "." + std::to_string(k)] = takeValue(bytes, at, type);
            }
            element.values.push_back(std::move(values));
        }
    }
    file.bytesLeft = bytes.size() - at;
    return file;
}
