// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include "core/formats/pwscan_project.h"
#include "core/formats/pwscan_writer.h"
#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"

using namespace planewright;

namespace {

constexpr int kBeams = 721;
constexpr int kMostSteps = 20'000;

[[noreturn]] void give(const std::string& problem)
{
    std::fprintf(stderr, "%s\n", problem.c_str());
    std::exit(1);
}

/// Says on the pipe what has been acknowledged, at once.
void acknowledge(int number)
{
    const std::string line = std::to_string(number) + "\n";
    if (::write(STDOUT_FILENO, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        std::exit(1);
}

/// Records into a new file, or adds a scan to one that is there, until somebody kills it.
void recordForEver(const std::string& path)
{
    const ScanRecord scan = sampleScanRecord(kBeams);
    auto writer = std::filesystem::exists(path) ? PwscanWriter::append(path, scan) : PwscanWriter::create(path, scan);
    if (!writer)
        give(writer.error().message);
    const Recording recording = sampleRecording(kMostSteps, kBeams);
    for (const ScanSlice& slice : recording.slices) {
        if (const auto written = writer->write(slice); !written)
            give(written.error().message);
        acknowledge(slice.step);
    }
}

/// Adds edits, and undoes every third of them, until somebody kills it.
void editForEver(const std::string& path)
{
    auto project = PwscanProject::open(path);
    if (!project)
        give(project.error().message);
    for (int plane = 0; plane < kMostSteps; ++plane) {
        const auto seq = project->append(1, {Edit::Kind::Rename, {plane}, std::string(100, 'n'), true});
        if (!seq)
            give(seq.error().message);
        if (*seq % 3 == 0) {
            if (const auto undone = project->setUndone(*seq, true); !undone)
                give(undone.error().message);
        }
        acknowledge(*seq);
    }
}

/// Records in a folder until its disk is full, makes room, goes on, and reads all back.
void recordOverAFullDisk(const std::string& folder)
{
    const std::string ballast = folder + "/ballast";
    const std::string path = folder + "/a.pwscan";
    std::ofstream(ballast) << std::string(std::filesystem::space(folder).available * 2 / 5, 'b');
    auto writer = PwscanWriter::create(path, sampleScanRecord(kBeams));
    if (!writer)
        give(writer.error().message);
    const Recording recording = sampleRecording(kMostSteps, kBeams);
    std::size_t next = 0;
    Result<void> written;
    while (written && next < recording.slices.size())
        written = writer->write(recording.slices[next++]);
    --next;
    if (written)
        give("the disk was never full");
    std::printf("full: %s\n", written.error().message.c_str());
    for (int again = 0; again < 3; ++again) {
        if (writer->write(recording.slices[next]))
            give("a full disk took a slice");
    }
    std::filesystem::remove(ballast);
    for (const std::size_t end = next + 3; next < end; ++next) {
        if (const auto more = writer->write(recording.slices[next]); !more)
            give(more.error().message);
    }
    if (const auto closed = writer->close(ScanState::Complete); !closed)
        give(closed.error().message);
    const auto read = readRecordingPwscan(path);
    if (!read)
        give(read.error().message);
    if (read->read.damaged || read->read.recording.slices.size() != next || std::filesystem::exists(path + "-wal"))
        give("slices are missing");
    std::printf("all slices are there\n");
}

}  // namespace

/// record_slices record FILE | edit FILE | fill FOLDER: what the tests of the writer kill and starve.
int main(int argc, char** argv)
{
    const std::string what = argc == 3 ? argv[1] : "";
    if (what == "record")
        recordForEver(argv[2]);
    else if (what == "edit")
        editForEver(argv[2]);
    else if (what == "fill")
        recordOverAFullDisk(argv[2]);
    else
        give("usage: record_slices record FILE | edit FILE | fill FOLDER");
    return 0;
}
