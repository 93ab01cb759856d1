// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_trials.h"

#include <utility>

#include "app/sources/device_checks.h"
#include "app/sources/device_opener.h"
#include "app/sources/unit_tasks.h"

namespace planewright {

namespace {

Result<std::string> bringHome(const std::string& tiltUnit, const std::stop_token& stop)
{
    DeviceOpener opener(steadyClock());
    return parseDeviceAddress(tiltUnit).and_then(
        [&](const DeviceAddress& unit) { return bringUnitHome(opener, unit, steadyClock(), stop); });
}

Result<std::string> recoverUnit(const std::string& tiltUnit, const std::stop_token& stop)
{
    DeviceOpener opener(steadyClock());
    return parseDeviceAddress(tiltUnit).and_then(
        [&](const DeviceAddress& unit) { return releaseUnit(opener, unit, stop); });
}

}  // namespace

DeviceTrials::DeviceTrials(QObject* parent) : QObject(parent) {}

DeviceTrials::~DeviceTrials()
{
    stopMotion();
}

void DeviceTrials::stopMotion()
{
    stop_.request_stop();
}

void DeviceTrials::test(const std::string& laser, const NoddingSetup& setup)
{
    run({kDeviceChecks.begin(), kDeviceChecks.end()}, [this, laser, setup](const std::stop_token& stop) {
        DeviceOpener opener(steadyClock(),
                            {setup.dialogueFolder, [this](const std::string& line) { tellWaiting(line); }});
        checkDevices(
            opener, laser, setup, steadyClock(),
            [this](std::size_t check, const std::optional<Result<std::string>>& result) { tell(check, result); }, stop);
    });
}

void DeviceTrials::home(const std::string& tiltUnit)
{
    run({"Move to level"}, [this, tiltUnit](const std::stop_token& stop) {
        tell(0, std::nullopt);
        tell(0, bringHome(tiltUnit, stop));
    });
}

void DeviceTrials::recover(const std::string& tiltUnit)
{
    run({"Release the tilt unit"}, [this, tiltUnit](const std::stop_token& stop) {
        tell(0, std::nullopt);
        tell(0, recoverUnit(tiltUnit, stop));
    });
}

void DeviceTrials::run(std::vector<std::string> checks, Work work)
{
    if (work_.isBusy())
        return;
    checks_.clear();
    for (std::string& check : checks)
        checks_.push_back({std::move(check), DeviceCheck::State::Waiting, {}});
    emit checksChanged(checks_);
    stop_ = {};
    work_.start<bool>(
        [work = std::move(work), stop = stop_.get_token()] {
            work(stop);
            return true;
        },
        [this](bool& /*done*/) { emit busyChanged(); });
    emit busyChanged();
}

void DeviceTrials::tell(std::size_t check, const std::optional<Result<std::string>>& result)
{
    QMetaObject::invokeMethod(
        this,
        [this, check, result] {
            DeviceCheck& row = checks_.at(check);
            row.state = !result   ? DeviceCheck::State::Running
                        : *result ? DeviceCheck::State::Passed
                                  : DeviceCheck::State::Failed;
            row.detail = !result ? "" : *result ? **result : result->error().message;
            emit checksChanged(checks_);
            if (result && !*result)
                emit failed(result->error());
            if (result && *result && check + 1 == checks_.size())
                emit passed();
        },
        Qt::QueuedConnection);
}

void DeviceTrials::tellWaiting(const std::string& line)
{
    QMetaObject::invokeMethod(
        this,
        [this, line] {
            for (DeviceCheck& row : checks_) {
                if (row.state == DeviceCheck::State::Running)
                    row.detail = line;
            }
            emit checksChanged(checks_);
        },
        Qt::QueuedConnection);
}

}  // namespace planewright
