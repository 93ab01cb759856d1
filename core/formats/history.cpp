// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/history.h"

#include <chrono>
#include <ostream>
#include <string>

#include "core/formats/json_text.h"
#include "core/formats/written.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

struct OperandText {
    std::string operator()(const SegmentId& id) const
    {
        return std::to_string(id.step) + "." + std::to_string(id.index);
    }
    std::string operator()(PlaneRef plane) const { return "P" + std::to_string(plane.id); }
    std::string operator()(ClusterRef cluster) const { return "C" + std::to_string(cluster.id); }
    std::string operator()(const PieceRef& piece) const
    {
        return std::to_string(piece.step) + ":" + std::to_string(piece.firstBeam) + "-" +
               std::to_string(piece.lastBeam);
    }
};

void appendOperands(std::string& line, const std::vector<Operand>& operands)
{
    line += '[';
    for (std::size_t i = 0; i < operands.size(); ++i) {
        line += i == 0 ? "\"" : ",\"";
        line += std::visit(OperandText{}, operands[i]);
        line += '"';
    }
    line += ']';
}

void appendTest(std::string& line, const Test& test)
{
    line += R"({"name":)";
    appendJsonText(line, test.name);
    line += R"(,"value":)";
    appendJsonNumber(line, test.value);
    line += R"(,"op":")";
    line += name(test.comparison);
    line += R"(","limit":)";
    appendJsonNumber(line, test.limit);
    line += test.pass() ? R"(,"pass":true})" : R"(,"pass":false})";
}

void appendDecision(std::string& line, const Decision& decision)
{
    line += R"({"phase":")";
    line += name(decision.phase);
    line += R"(","kind":")";
    line += name(decision.kind);
    line += R"(","operands":)";
    appendOperands(line, decision.operands);
    line += R"(,"tests":[)";
    for (std::size_t i = 0; i < decision.tests.size(); ++i) {
        line += i == 0 ? "" : ",";
        appendTest(line, decision.tests[i]);
    }
    line += R"(],"result":)";
    appendOperands(line, decision.result);
    line += '}';
}

void appendCounts(std::string& line, const StepCounts& counts)
{
    char before = '{';
    const auto count = [&](const char* key, int value) {
        line += before;
        before = ',';
        line += "\"" + std::string{key} + "\":" + std::to_string(value);
    };
    count("returns", counts.returns);
    count("segments", counts.segments);
    count("assigned", counts.assigned);
    count("clustered", counts.clustered);
    count("fitted", counts.fitted);
    count("unfitted", counts.unfitted);
    count("clusters", counts.clusters);
    count("planes", counts.planes);
    line += '}';
}

void appendTimes(std::string& line, const StepReport& report)
{
    char before = '{';
    for (std::size_t phase = 0; phase < kPhases; ++phase) {
        line += before;
        before = ',';
        line += "\"" + std::string{kPhaseNames[phase]} + "\":";
        appendJsonNumber(line, std::chrono::duration<double, std::milli>(report.times[phase]).count());
    }
    line += '}';
}

}  // namespace

Result<void> writeHistoryHeader(std::ostream& out, const Parameters& parameters)
{
    std::string line = R"({"format":"planewright-history 1","parameters":)";
    appendJsonParameters(line, parameters);
    out << line << "}\n";
    return written(out);
}

Result<void> writeHistoryLine(std::ostream& out, const StepReport& report, bool times)
{
    std::string line = R"({"step":)" + std::to_string(report.step);
    if (report.step < 0)
        line += R"(,"phase":")" + std::string{name(Phase::Finish)} + "\"";
    line += R"(,"pitch_deg":)";
    appendJsonNumber(line, toDegrees(report.tilt));
    line += R"(,"counts":)";
    appendCounts(line, report.counts);
    if (times) {
        line += R"(,"times_ms":)";
        appendTimes(line, report);
    }
    line += R"(,"decisions":[)";
    for (std::size_t i = 0; i < report.decisions.size(); ++i) {
        line += i == 0 ? "" : ",";
        appendDecision(line, report.decisions[i]);
    }
    out << line << "]}\n";
    return written(out);
}

}  // namespace planewright
