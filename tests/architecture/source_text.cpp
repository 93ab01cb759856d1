// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/architecture/source_text.h"

#include <cctype>
#include <regex>

namespace planewright::architecture {

namespace {

bool belongsToAName(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Where a literal that opens at `quote` ends: the place after its last character.
std::size_t endOfLiteral(std::string_view source, std::size_t quote)
{
    if (source[quote] == '"' && quote > 0 && source[quote - 1] == 'R') {
        const std::size_t bracket = source.find('(', quote);
        if (bracket == std::string_view::npos)
            return source.size();
        const std::string closing = ")" + std::string{source.substr(quote + 1, bracket - quote - 1)} + "\"";
        const std::size_t end = source.find(closing, bracket);
        return end == std::string_view::npos ? source.size() : end + closing.size();
    }
    for (std::size_t i = quote + 1; i < source.size() && source[i] != '\n'; ++i) {
        if (source[i] == '\\')
            ++i;
        else if (source[i] == source[quote])
            return i + 1;
    }
    return quote + 1;
}

/// Where the comment that opens at `slash` ends, or `slash` where none opens.
std::size_t endOfComment(std::string_view source, std::size_t slash)
{
    const std::string_view opening = source.substr(slash, 2);
    if (opening == "//")
        return std::min(source.find('\n', slash), source.size());
    if (opening == "/*") {
        const std::size_t end = source.find("*/", slash + 2);
        return end == std::string_view::npos ? source.size() : end + 2;
    }
    return slash;
}

bool onlyIncludesBefore(std::string_view source, std::size_t quote)
{
    const std::size_t lineStart = source.rfind('\n', quote) + 1;  // npos + 1 is 0
    static const std::regex kStart(R"(\s*#\s*include\s*)");
    return std::regex_match(source.begin() + static_cast<std::ptrdiff_t>(lineStart),
                            source.begin() + static_cast<std::ptrdiff_t>(quote), kStart);
}

/// The source with comments and literals replaced by blanks; line ends stay where they are.
std::string withoutCommentsAndLiterals(std::string_view source)
{
    std::string code{source};
    std::size_t i = 0;
    while (i < source.size()) {
        std::size_t end = endOfComment(source, i);
        // An apostrophe inside a number, as in 1'000, opens no literal.
        const bool literal = source[i] == '"' || (source[i] == '\'' && (i == 0 || !belongsToAName(source[i - 1])));
        if (end == i && literal)
            end = onlyIncludesBefore(source, i) ? i + source.substr(i).find('\n') : endOfLiteral(source, i);
        if (end == i || end > source.size()) {
            ++i;
            continue;
        }
        if (!(literal && onlyIncludesBefore(source, i))) {
            for (std::size_t k = i; k < end; ++k)
                code[k] = code[k] == '\n' ? '\n' : ' ';
        }
        i = end;
    }
    return code;
}

}  // namespace

std::vector<std::string> codeLinesOf(std::string_view source)
{
    const std::string code = withoutCommentsAndLiterals(source);
    std::vector<std::string> lines;
    std::size_t start = 0;
    while (start < code.size()) {
        const std::size_t end = std::min(code.find('\n', start), code.size());
        lines.push_back(code.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

std::vector<Include> includesOf(std::string_view source)
{
    static const std::regex kLine(R"(\s*#\s*include(_next)?\b\s*(.*))");
    static const std::regex kHeader(R"(["<]([^">]+)[">].*)");
    std::vector<Include> includes;
    int number = 0;
    for (const std::string& line : codeLinesOf(source)) {
        ++number;
        std::smatch parts;
        if (!std::regex_match(line, parts, kLine))
            continue;
        const std::string rest = parts[2];
        std::smatch header;
        const bool named = std::regex_match(rest, header, kHeader);
        includes.push_back({number, named ? header[1].str() : "", rest.starts_with('"')});
    }
    return includes;
}

bool holdsWord(std::string_view line, std::string_view word)
{
    for (std::size_t at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !belongsToAName(line[at - 1])) && (end == line.size() || !belongsToAName(line[end])))
            return true;
    }
    return false;
}

}  // namespace planewright::architecture
