// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// The experiments of the paper on simulated scans, for both presets and against other extractors: a folder with
// report.md and its figures.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <CLI/CLI.hpp>

#include "app/process/kept_heap.h"
#include "tests/benchmarks/paper/sections.h"

using namespace planewright;

namespace {

/// What the processor calls itself.
std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) == 0)
            return line.substr(line.find(':') + 2);
    }
    return "an unknown processor";
}

}  // namespace

int main(int argc, char** argv)
{
    keepFreedMemory();                  // as the programs do; opponents have it, too
    setenv("OMP_NUM_THREADS", "1", 1);  // opponents get one thread as the product does
    std::string folder = "paper-report";
    bool quick = false;
    CLI::App program{"The experiments of the paper, as a report in a folder."};
    program.add_option("-o,--output", folder, "Folder of the report")->capture_default_str();
    program.add_flag("--quick", quick, "A smoke of seconds: all tables and figures from few and small scans");
    CLI11_PARSE(program, argc, argv);

    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        std::fprintf(stderr, "paper_report: cannot make the folder %s: %s\n", folder.c_str(), error.message().c_str());
        return 1;
    }
    const ExperimentPlan plan = quick ? quickPlan() : ExperimentPlan{};
    Report report(folder);
    report.heading(1, "The experiments of the paper");
    report.text("Made by tests/benchmarks/run-paper" + std::string(quick ? " --quick: a smoke, no measurement" : "") +
                " on " + processorName() + ", GCC " __VERSION__ ". Everything but the times is the same on every run.");
    const std::vector<ComparedScan> scans =
        compareMethods(plan, {"default noise", plan.settings, *simulationNoise("default"), quick ? 50 : 200});
    writeClustering(report, plan);
    writeIndoor(report, plan, scans);
    writeSteps(report, plan);
    writeGrowth(report, plan);
    writeTwelvePlanes(report, plan, scans);
    writeOpponents(report, plan, scans);
    writeVariations(report, plan);
    if (!report.write()) {
        std::fprintf(stderr, "paper_report: the report in %s is not complete\n", folder.c_str());
        return 1;
    }
    std::printf("%s/report.md\n", folder.c_str());
    return 0;
}
