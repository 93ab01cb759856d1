// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QColor>
#include <QLineEdit>

namespace planewright {

/// A line of text, part of which may be underlined by a wavy line as wrong.
class UnderlinedEdit : public QLineEdit {
    Q_OBJECT

public:
    explicit UnderlinedEdit(QWidget* parent = nullptr) : QLineEdit(parent) {}

    /// Underlines so many characters from a place on; a length of 0 underlines none.
    void underline(int position, int length);

    bool isUnderlined() const { return length_ > 0; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int position_ = 0;
    int length_ = 0;
};

/// The colour of what is wrong, 4.5 : 1 at least against the background of the palette.
QColor wrongColour(const QPalette& palette);

}  // namespace planewright
