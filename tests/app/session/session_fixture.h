// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <QtTest>

#include "app/session/scan_session.h"
#include "core/params/presets.h"
#include "tests/app/session/loops/batch.h"
#include "tests/app/session/loops/fakes.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

/// Options for a session with small simulated scans.
inline SessionOptions smallOptions(const Clock* clock = nullptr)
{
    SessionOptions options;
    options.simulation.settings = smallScan();
    options.clock = clock;
    return options;
}

/// What a simulated scan of `sim:corridor?seed=3` records.
inline Recording smallCorridor()
{
    return asRecorded(simulate(*makeScene("corridor", 3), smallScan(), *simulationNoise("default"), 3).recording);
}

/// The default method with the noise of the simulated scanner.
inline Parameters defaultParametersOfTheSimulation()
{
    Parameters parameters;
    apply(methodPresets().front(), parameters);
    apply(*sensorOfScanner("UTM-30LX"), parameters);
    return parameters;
}

/// True where an error is a refusal with a reason.
inline bool isRefusal(const Result<void>& result)
{
    return !result && result.error().code == ErrorCode::Usage && result.error().message.ends_with('.');
}

}  // namespace planewright

// Macros, so that a failure names the line of the test.
#define WAIT_FOR(session, wanted) QTRY_COMPARE_WITH_TIMEOUT((session).state(), SessionState::wanted, 60'000)
#define OPEN_ROOM(session, options)                         \
    QVERIFY((session).open("sim:corridor?seed=3" options)); \
    WAIT_FOR(session, Ready)
