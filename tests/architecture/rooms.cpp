// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/architecture/rooms.h"

#include <algorithm>
#include <array>

namespace planewright::architecture {

namespace {

using Names = std::vector<std::string_view>;

const Names kNumbers{"Eigen/", "tl/expected.hpp"};
/// Sockets, serial lines and waiting for them.
const Names kSystem{"arpa/",   "asm/termbits.h", "fcntl.h", "grp.h", "ifaddrs.h", "linux/serial.h", "net/",
                    "netdb.h", "netinet/",       "poll.h",  "sys/",  "termios.h", "unistd.h"};

Names operator+(Names names, const Names& more)
{
    names.insert(names.end(), more.begin(), more.end());
    return names;
}

}  // namespace

std::span<const Room> rooms()
{
    static const std::vector<Room> all{
        {"core/types", {}, kNumbers},
        {"core/params", {"core/types"}, kNumbers},
        {"core/geometry", {"core/types", "core/params"}, kNumbers + Names{"polyclipping/"}},
        {"core/segments", {"core/types", "core/params", "core/geometry"}, kNumbers},
        {"core/clusters", {"core/types", "core/params", "core/geometry", "core/segments"}, kNumbers},
        {"core/planes", {"core/types", "core/params", "core/geometry", "core/segments", "core/clusters"}, kNumbers},
        {"core/pipeline",
         {"core/types", "core/params", "core/geometry", "core/segments", "core/clusters", "core/planes"},
         kNumbers},
        // Calibration asks the planes that an extraction has found, and extracts again with what they tell.
        {"core/calibration", {"core/types", "core/params", "core/geometry", "core/pipeline"}, kNumbers},
        {"core/mapping",
         {"core/types", "core/params", "core/geometry", "core/segments", "core/clusters", "core/planes"},
         kNumbers + Names{"ceres/"}},
        {"core/simulation", {"core/types", "core/params", "core/geometry"}, kNumbers},
        {"core/formats",
         {"core/types", "core/params", "core/geometry"},
         kNumbers + Names{"sqlite3.h", "zlib.h", "nlohmann/", "dime/"}},
        {"core/evaluation", {"core/types", "core/params", "core/geometry"}, kNumbers},

        {"devices/transport", {"core/types", "devices/clock.h"}, kNumbers + kSystem + Names{"libusb", "QSerialPort"}},
        {"devices/emulated", {"core/types", "core/simulation", "devices", "devices/transport"}, kNumbers + kSystem},
        {"devices/replay", {"core/types", "core/formats", "devices"}, kNumbers},
        {"devices", {"core/types", "devices/transport"}, kNumbers},

        {"ui/common", {"core"}, kNumbers},
        {"ui/models", {"core", "ui/common"}, kNumbers + Names{"Q"}},
        {"ui/scene", {"core", "ui/common"}, kNumbers + Names{"vtk"}},
        {"ui/opengl", {"core/types"}, Names{"tl/expected.hpp", "vtk", "GL/", "EGL/", "dlfcn.h"}},
        {"ui", {"core", "ui/common", "ui/models", "ui/opengl", "ui/scene"}, kNumbers + Names{"Q", "vtk"}},

        {"app/process", {}, Names{"cstdlib", "malloc.h"}},
        {"app/files", {"core"}, kNumbers + Names{"unistd.h", "sys/", "fcntl.h"}},
        {"app/mapping", {"core", "app/files"}, kNumbers},
        {"app/sources",
         {"core", "devices", "devices/transport", "devices/emulated", "devices/replay", "app/files"},
         kNumbers},
        // What a session's threads do knows no Qt, so that the thread sanitizer sees all of it.
        {"app/session/loops", {"core", "devices"}, kNumbers},
        {"app/session",
         {"core", "devices", "app/sources", "app/session/loops"},
         kNumbers + Names{"QObject", "QString", "QThread", "QTimer", "QDateTime", "QMetaObject"}},
        // The command line links no widget and no picture.
        {"app/cli",
         {"core", "devices", "devices/transport", "devices/emulated", "devices/replay", "app/files", "app/mapping",
          "app/sources", "app/process", "app/session", "app/session/loops"},
         kNumbers + Names{"CLI/", "spdlog/", "nlohmann/", "Qt", "unistd.h", "sys/", "fcntl.h"}},
        {"app",
         {"core", "devices", "devices/transport", "devices/emulated", "devices/replay", "ui", "ui/common", "ui/models",
          "ui/opengl", "ui/scene", "app/cli", "app/files", "app/mapping", "app/process", "app/sources", "app/session",
          "app/session/loops"},
         {""}},
    };
    return all;
}

std::span<const Restriction> restrictedHeaders()
{
    static const std::vector<Restriction> all = [] {
        std::vector<Restriction> rules;
        const auto close = [&rules](const Names& headers, const Names& under, const Names& except,
                                    std::string_view reason) {
            for (const std::string_view header : headers)
                rules.push_back({header, under, except, reason});
        };
        close({"thread", "mutex", "shared_mutex", "future", "condition_variable", "semaphore", "latch", "barrier",
               "stop_token", "atomic"},
              {"core"}, {}, "core has no thread and no lock");
        close({"thread", "future"}, {"devices", "ui"}, {"devices/transport"},
              "only app and devices/transport start threads");
        close({"iostream", "syncstream", "cstdio", "stdio.h", "fstream", "filesystem"}, {"core"}, {},
              "core has no console and opens no file");
        close({"istream", "ostream", "sstream", "streambuf", "ios", "iosfwd", "iomanip"}, {"core"}, {"core/formats"},
              "in core only core/formats knows streams");
        close({"ctime", "time.h", "csignal", "signal.h", "locale", "clocale", "locale.h"}, {"core"}, {},
              "core has no clock, no signal and no locale");
        close({"random"}, {"core"}, {"core/simulation"}, "in core only core/simulation draws random numbers");
        return rules;
    }();
    return all;
}

std::span<const Restriction> restrictedWords()
{
    static const std::vector<Restriction> all = [] {
        std::vector<Restriction> rules;
        const auto close = [&rules](const Names& words, std::string_view reason) {
            for (const std::string_view word : words)
                rules.push_back({word, {"core"}, {}, reason});
        };
        close({"system_clock", "steady_clock", "high_resolution_clock", "utc_clock", "clock_gettime"},
              "core has no clock: times come from the caller's");
        close({"random_device", "rand", "srand", "default_random_engine"}, "core has no global random state");
        close({"uniform_real_distribution", "uniform_int_distribution", "normal_distribution", "bernoulli_distribution",
               "discrete_distribution"},
              "results of std's distributions differ between libraries");
        close({"getenv", "setlocale", "strtod", "strtof", "atof", "stod", "stof", "scanf", "sscanf", "printf",
               "snprintf", "thread_local"},
              "core does the same on every machine, under every locale and in every thread");
        return rules;
    }();
    return all;
}

const Room* roomOf(std::string_view path)
{
    const auto all = rooms();
    const auto room = std::find_if(all.begin(), all.end(), [&](const Room& r) { return liesIn(path, r.folder); });
    return room == all.end() ? nullptr : &*room;
}

bool hasDoorTo(const Room& room, std::string_view header)
{
    const Room* other = roomOf(header);
    if (other == nullptr)
        return false;
    const auto isRoom = [](std::string_view folder) {
        return std::any_of(rooms().begin(), rooms().end(), [&](const Room& r) { return r.folder == folder; });
    };
    return other->folder == room.folder ||
           std::any_of(room.opensTo.begin(), room.opensTo.end(), [&](std::string_view folder) {
               return folder == other->folder || (!isRoom(folder) && liesIn(header, folder));
           });
}

bool liesIn(std::string_view path, std::string_view folder)
{
    return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

bool isStandardHeader(std::string_view header)
{
    static constexpr auto kNames = std::to_array<std::string_view>({"algorithm",
                                                                    "any",
                                                                    "array",
                                                                    "atomic",
                                                                    "barrier",
                                                                    "bit",
                                                                    "bitset",
                                                                    "cassert",
                                                                    "cctype",
                                                                    "cerrno",
                                                                    "cfenv",
                                                                    "cfloat",
                                                                    "charconv",
                                                                    "chrono",
                                                                    "cinttypes",
                                                                    "climits",
                                                                    "clocale",
                                                                    "cmath",
                                                                    "codecvt",
                                                                    "compare",
                                                                    "complex",
                                                                    "concepts",
                                                                    "condition_variable",
                                                                    "coroutine",
                                                                    "csetjmp",
                                                                    "csignal",
                                                                    "cstdarg",
                                                                    "cstddef",
                                                                    "cstdint",
                                                                    "cstdio",
                                                                    "cstdlib",
                                                                    "cstring",
                                                                    "ctime",
                                                                    "cuchar",
                                                                    "cwchar",
                                                                    "cwctype",
                                                                    "deque",
                                                                    "exception",
                                                                    "execution",
                                                                    "filesystem",
                                                                    "format",
                                                                    "forward_list",
                                                                    "fstream",
                                                                    "functional",
                                                                    "future",
                                                                    "initializer_list",
                                                                    "iomanip",
                                                                    "ios",
                                                                    "iosfwd",
                                                                    "iostream",
                                                                    "istream",
                                                                    "iterator",
                                                                    "latch",
                                                                    "limits",
                                                                    "list",
                                                                    "locale",
                                                                    "map",
                                                                    "memory",
                                                                    "memory_resource",
                                                                    "mutex",
                                                                    "new",
                                                                    "numbers",
                                                                    "numeric",
                                                                    "optional",
                                                                    "ostream",
                                                                    "queue",
                                                                    "random",
                                                                    "ranges",
                                                                    "ratio",
                                                                    "regex",
                                                                    "scoped_allocator",
                                                                    "semaphore",
                                                                    "set",
                                                                    "shared_mutex",
                                                                    "source_location",
                                                                    "span",
                                                                    "sstream",
                                                                    "stack",
                                                                    "stdexcept",
                                                                    "stop_token",
                                                                    "streambuf",
                                                                    "string",
                                                                    "string_view",
                                                                    "syncstream",
                                                                    "system_error",
                                                                    "thread",
                                                                    "tuple",
                                                                    "type_traits",
                                                                    "typeindex",
                                                                    "typeinfo",
                                                                    "unordered_map",
                                                                    "unordered_set",
                                                                    "utility",
                                                                    "valarray",
                                                                    "variant",
                                                                    "vector",
                                                                    "version",
                                                                    "assert.h",
                                                                    "errno.h",
                                                                    "limits.h",
                                                                    "locale.h",
                                                                    "math.h",
                                                                    "signal.h",
                                                                    "stddef.h",
                                                                    "stdint.h",
                                                                    "stdio.h",
                                                                    "stdlib.h",
                                                                    "string.h",
                                                                    "time.h"});
    return std::find(kNames.begin(), kNames.end(), header) != kNames.end();
}

}  // namespace planewright::architecture
