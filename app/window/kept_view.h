// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/window/view_text.h"
#include "app/window/window_parts.h"

namespace planewright {

/// A `.pwscan` opens as it was left: with the same camera, layers and selection, which are rows of it. Only what
/// somebody has changed is written, a moment after they have stopped.
class KeptView : public QObject {
    Q_OBJECT

public:
    explicit KeptView(WindowParts& parts);

    /// Whether changes are written; they are read in any case.
    void setWrites(bool writes) { writes_ = writes; }
    /// Writes what has changed now, before the file is left.
    void save();

signals:
    void layersRead(const planewright::LayerSettings& layers);

private:
    enum Row { kCamera, kLayerStyles, kSelection, kRows };

    void load();
    void takeShown();
    std::array<QString, kRows> texts() const;
    std::optional<QString> stored(Row row);

    WindowParts& parts_;
    bool writes_ = true;
    bool loaded_ = false;  ///< what the file says is in force, and changes after that are the user's
    std::array<QString, kRows> written_;
    std::optional<ChosenParts> chosen_;  ///< until there are planes to be chosen
    QTimer rest_;
};

}  // namespace planewright
