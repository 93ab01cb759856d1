// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/parameter_options.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sys/stat.h>

#include "app/cli/console.h"
#include "app/cli/text.h"
#include "app/files/input_file.h"
#include "core/formats/preset_file.h"
#include "core/params/presets.h"
#include "core/params/registry.h"

namespace planewright {

namespace {

bool exists(const std::string& path)
{
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0;
}

/// Where the user keeps a preset of this name; a user without a home has none.
std::optional<std::string> ownPreset(const std::string& name)
{
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const std::string own = "/planewright/presets/" + name + ".json";
    if (config != nullptr && *config == '/')
        return config + own;
    if (home != nullptr && *home == '/')
        return home + ("/.config" + own);
    return std::nullopt;
}

std::vector<std::string_view> namesOf(const std::vector<Preset>& presets)
{
    std::vector<std::string_view> names;
    names.reserve(presets.size());
    for (const Preset& preset : presets)
        names.push_back(preset.name);
    return names;
}

Result<void> applyNamed(const std::string& name, const std::vector<Preset>& known, const std::string& option,
                        Parameters& parameters)
{
    if (const Preset* preset = findPreset(known, name)) {
        apply(*preset, parameters);
        return {};
    }
    const auto own = name.find('/') == std::string::npos ? ownPreset(name) : std::nullopt;
    const std::string path = own && exists(*own) ? *own : name;
    if (!exists(path))
        return fail(ErrorCode::Usage,
                    option + ": '" + name + "' is neither a known name (" + joined(namesOf(known)) + ") nor a file");
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return readPresetFile(**input, path, parameters);
}

/// What was given on the command line beside the preset, in its order.
Result<void> applySensorAndAssignments(const ParameterOptions& options, Parameters& parameters)
{
    if (!options.sensor.empty()) {
        if (auto done = applyNamed(options.sensor, sensorPresets(), "--sensor", parameters); !done)
            return done;
    }
    for (const std::string& assignment : options.assignments) {
        if (const auto done = setParameter(parameters, assignment); !done)
            return fail(done.error().code, "-P: " + done.error().message);
    }
    return {};
}

}  // namespace

void addParameterOptions(CLI::App& command, ParameterOptions& options)
{
    command.add_option("--preset", options.preset, "method: " + joined(namesOf(methodPresets())) + " or a preset file")
        ->type_name("NAME|FILE")
        ->default_str(std::string{methodPresets().front().name});
    command
        .add_option("--sensor", options.sensor,
                    "noise of the scanner: " + joined(namesOf(sensorPresets())) +
                        " or a file (default: by the scanner that the recording names)")
        ->type_name("NAME|FILE");
    command.add_option("-P", options.assignments, "sets one parameter, repeatable; 'planewright-cli params' lists all")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

Result<Parameters> parametersInForce(const ParameterOptions& options, std::string_view scanner)
{
    Parameters parameters;
    const std::string preset = options.preset.empty() ? std::string{methodPresets().front().name} : options.preset;
    if (findPreset(methodPresets(), preset) == nullptr)
        apply(methodPresets().front(), parameters);  // a file changes the default
    if (const auto done = applyNamed(preset, methodPresets(), "--preset", parameters); !done)
        return tl::unexpected{done.error()};
    if (options.sensor.empty()) {
        if (const Preset* sensor = sensorOfScanner(scanner))
            apply(*sensor, parameters);
        else if (!scanner.empty())
            printWarning("the recording's scanner '" + std::string{scanner} +
                         "' is not known; the noise of the preset is used, give --sensor (" +
                         joined(namesOf(sensorPresets())) + " or a file)");
    }
    if (const auto done = applySensorAndAssignments(options, parameters); !done)
        return tl::unexpected{done.error()};
    return parameters;
}

Result<std::vector<ParametersFrom>> parametersInForce(const ParameterOptions& options, std::string_view scanner,
                                                      std::vector<ParametersFrom> stored)
{
    if (stored.empty() || !options.preset.empty()) {
        return parametersInForce(options, scanner).map([](const Parameters& parameters) {
            return std::vector<ParametersFrom>{{0, parameters}};
        });
    }
    for (ParametersFrom& from : stored) {
        if (const auto done = applySensorAndAssignments(options, from.parameters); !done)
            return tl::unexpected{done.error()};
    }
    return stored;
}

Result<MappingParameters> takeMappingParameters(ParameterOptions& options)
{
    const auto rest =
        std::stable_partition(options.assignments.begin(), options.assignments.end(),
                              [](const std::string& assignment) { return !assignment.starts_with(kMappingPart); });
    MappingParameters parameters;
    for (auto assignment = rest; assignment != options.assignments.end(); ++assignment) {
        if (const auto done = setParameter(parameters, *assignment); !done)
            return fail(done.error().code, "-P: " + done.error().message);
    }
    options.assignments.erase(rest, options.assignments.end());
    return parameters;
}

}  // namespace planewright
