// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <istream>
#include <utility>

#include "core/formats/problem_list.h"
#include "core/formats/recording_csv.h"
#include "core/formats/recording_csv_header.h"
#include "core/formats/recording_csv_row.h"
#include "core/formats/text_lines.h"

namespace planewright {

namespace {

/// One pass over a recording file, for its contents or for its problems.
class RecordingPass {
public:
    RecordingPass(std::istream& in, ProblemList& problems, bool keepsSlices)
        : lines_(in), problems_(problems), keepsSlices_(keepsSlices)
    {
    }

    void run()
    {
        const auto header = readRecordingHeader(lines_, problems_, result.warnings);
        if (header) {
            result.recording.description = header->description;
            readRows(*header);
        }
        if (!lines_.problem().empty())
            problems_.add(lines_.problem(), lines_.problemLine());
    }

    ReadRecording result;

private:
    void readRows(const RecordingHeader& header);
    bool fits(const RecordingHeader& header);
    void tellCut(std::size_t line, std::string_view what);

    TextLines lines_;
    ProblemList& problems_;
    bool keepsSlices_;
    std::size_t slices_ = 0;
};

/// True while the limits allow one more slice.
bool RecordingPass::fits(const RecordingHeader& header)
{
    const auto beams = static_cast<std::size_t>(header.description.beams);
    if (slices_ == static_cast<std::size_t>(kMaxSlices))
        problems_.add("more than " + std::to_string(kMaxSlices) + " slices; split the recording", lines_.number());
    else if ((slices_ + 1) * beams > kMaxRanges)
        problems_.add("more than " + std::to_string(kMaxRanges) + " ranges; split the recording", lines_.number());
    else
        return true;
    return false;
}

void RecordingPass::tellCut(std::size_t line, std::string_view what)
{
    result.damaged = true;
    result.warnings.push_back(placeInFile(problems_.fileName(), line) + std::string{what});
}

void RecordingPass::readRows(const RecordingHeader& header)
{
    RowReader rows{header};
    std::size_t blankLine = 0;
    bool anyRow = false;
    while (const auto line = lines_.next()) {
        if (line->empty()) {
            blankLine = blankLine == 0 ? lines_.number() : blankLine;
            continue;
        }
        if (blankLine != 0)
            problems_.add("there is a blank line between rows; remove it", std::exchange(blankLine, 0));
        anyRow = true;
        if (!fits(header))
            return;
        // Where compressed data stop, even the last number may lack digits.
        const bool mayBeCut = lines_.cutShort();
        const auto outcome = rows.read(*line, lines_.terminated(), lines_.number(), problems_);
        if (outcome == RowReader::Outcome::CutShort || (mayBeCut && outcome == RowReader::Outcome::Slice)) {
            tellCut(lines_.number(), "the last row was cut short and is dropped; the rows before it are used");
            result.slicesLeftOut = 1;
            break;
        }
        if (outcome == RowReader::Outcome::Slice) {
            ++slices_;
            if (keepsSlices_)
                result.recording.slices.push_back(rows.slice());
        }
        if (problems_.endsReading())
            return;
    }
    if (lines_.cutShort() && !result.damaged)
        tellCut(lines_.number(), "the compressed file was cut short after this line; the rows up to here are used");
    if (slices_ != 0 || !problems_.empty() || !lines_.problem().empty())
        return;
    problems_.add(anyRow || result.damaged ? "the file was cut short and holds no complete row; get the whole file"
                                           : "there is no slice; a recording has a row for each",
                  lines_.number());
}

}  // namespace

Result<ReadRecording> readRecordingCsv(std::istream& in, const std::string& fileName)
{
    ProblemList problems{fileName, 1};
    RecordingPass pass{in, problems, true};
    pass.run();
    if (!problems.empty())
        return fail(ErrorCode::Unreadable, problems.texts().front());
    return std::move(pass.result);
}

RecordingProblems recordingProblems(std::istream& in, const std::string& fileName)
{
    ProblemList problems{fileName, kMaxListedProblems};
    RecordingPass pass{in, problems, false};
    pass.run();
    return {problems.texts(), problems.more(), std::move(pass.result.warnings), pass.result.damaged};
}

}  // namespace planewright
