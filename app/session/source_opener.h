// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QThread>

#include "app/sources/open_source.h"

namespace planewright {

/// Opens sources on threads of their own, the last that was asked for.
class SourceOpener : public QObject {
    Q_OBJECT

public:
    explicit SourceOpener(const Clock& clock) : clock_(clock) {}
    /// Waits for what is being read: CSV ends soon, a `.pwscan` when it has been read.
    ~SourceOpener() override;

    void open(const SourceAddress& address, const SourceSetup& setup);
    /// What is being opened will not come.
    void cancel();

signals:
    /// What became of the last open(), which somebody takes out of it.
    void opened(const std::shared_ptr<planewright::Result<planewright::OpenedSource>>& result);

private:
    void forgetEnded();

    const Clock& clock_;
    std::stop_source stop_;
    int number_ = 0;  ///< of the last open(); cancelled ones go nowhere
    std::vector<std::unique_ptr<QThread>> threads_;
};

}  // namespace planewright
