// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/test_program.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <string>

namespace {

/// By the name of its source, without its ending.
std::map<std::string, planewright::TestRun>& entries()
{
    static std::map<std::string, planewright::TestRun> all;
    return all;
}

}  // namespace

planewright::TestEntry::TestEntry(const char* file, TestRun run)
{
    entries().emplace(std::filesystem::path{file}.stem().string(), run);
}

int main(int argc, char** argv)
{
    if (entries().size() == 1 && (argc < 2 || entries().count(argv[1]) == 0))
        return entries().begin()->second(argc, argv);
    const auto entry = argc < 2 ? entries().end() : entries().find(argv[1]);
    if (entry == entries().end()) {
        std::cerr << "usage: " << argv[0] << " TEST [argument of QtTest...]; its tests are:\n";
        for (const auto& [name, run] : entries())
            std::cerr << "  " << name << "\n";
        return 2;
    }
    argv[1] = argv[0];  // QtTest sees a program of its own
    return entry->second(argc - 1, argv + 1);
}
