// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/simulator_form.h"

#include <array>
#include <span>

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QRegularExpressionValidator>

#include "core/simulation/scene.h"
#include "core/simulation/simulation_noise.h"
#include "ui/panels/plain_fields.h"

namespace planewright {

namespace {

QString sceneText(std::string_view ascii)
{
    return QString::fromLatin1(ascii.data(), static_cast<qsizetype>(ascii.size()));
}

struct Words {
    const char* name;
    const char* shown;
};
constexpr std::array<Words, 9> kScenes{{{"corridor", "Corridor"},
                                        {"office", "Office"},
                                        {"hall", "Hall 20 × 25 m"},
                                        {"curved", "Curved wall"},
                                        {"stairs", "Stairs"},
                                        {"twelve", "Twelve planes"},
                                        {"clutter", "Clutter"},
                                        {"empty", "Empty"},
                                        {"hostile", "Hostile"}}};
constexpr std::array<Words, 5> kNoises{{{"none", "None: exact"},
                                        {"default", "Default: 8 mm, 1 mm/m"},
                                        {"P", "P: 3 mm/m"},
                                        {"S", "S: 10 mm, 30 mm far"},
                                        {"A", "A: 30 mm, 50 mm far"}}};

/// All that the simulator knows, those with words of their own by these.
void addNames(QComboBox* box, std::span<const std::string_view> names, std::span<const Words> words)
{
    for (const std::string_view name : names) {
        QString shown = sceneText(name);
        for (const Words& word : words) {
            if (name == word.name)
                shown = QString::fromUtf8(word.shown);
        }
        box->addItem(shown, sceneText(name));
    }
}

std::string chosen(const QComboBox* box)
{
    return box->currentData().toString().toStdString();
}

void choose(QComboBox* box, const std::string& name)
{
    box->setCurrentIndex(box->findData(QString::fromStdString(name)));
}

}  // namespace

void addSpeeds(QComboBox* box)
{
    for (const auto& [text, speed] : {std::pair{"¼ ×", 0.25},
                                      {"½ ×", 0.5},
                                      {"Real time", 1.0},
                                      {"2 ×", 2.0},
                                      {"5 ×", 5.0},
                                      {"10 ×", 10.0},
                                      {"As fast as possible", 0.0}})
        box->addItem(QString::fromUtf8(text), speed);
    box->setCurrentIndex(box->findData(1.0));
}

void chooseSpeed(QComboBox* box, double speed)
{
    if (box->findData(speed) < 0)
        box->addItem(QString::number(speed) + QStringLiteral(" ×"), speed);
    box->setCurrentIndex(box->findData(speed));
}

SimulatorForm::SimulatorForm(QWidget* parent)
    : QWidget(parent),
      scene_(new QuietComboBox(this)),
      seed_(new QLineEdit(this)),
      noise_(new QuietComboBox(this)),
      speed_(new QuietComboBox(this))
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins({});
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const auto add = [&](const QString& label, QWidget* field, const QString& name) {
        field->setObjectName(name);
        field->setAccessibleName(QString(label).remove('&'));
        form->addRow(label, field);
    };
    addNames(scene_, sceneNames(), kScenes);
    addNames(noise_, simulationNoiseNames(), kNoises);
    // Its numbers are to be read: where there is too little room its label goes above it.
    noise_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    addSpeeds(speed_);
    seed_->setValidator(new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{1,19}")), seed_));
    seed_->setToolTip(tr("The number that room and noise come from: the same number gives the same scan"));
    noise_->setToolTip(tr("Standard deviation of ranges; the pitch has 0.084°"));
    add(tr("&Scene"), scene_, QStringLiteral("scene"));
    add(tr("S&eed"), seed_, QStringLiteral("seed"));
    add(tr("&Noise"), noise_, QStringLiteral("noise"));
    firstTilt_ = addAngle(form, tr("Tilt from"), QStringLiteral("firstTilt"), -360.0, 360.0);
    lastTilt_ = addAngle(form, tr("Tilt to"), QStringLiteral("lastTilt"), -360.0, 360.0);
    tiltStep_ = addAngle(form, tr("Tilt step"), QStringLiteral("tiltStep"), -90.0, 90.0);
    firstBearing_ = addAngle(form, tr("Bearing from"), QStringLiteral("firstBearing"), -360.0, 360.0);
    lastBearing_ = addAngle(form, tr("Bearing to"), QStringLiteral("lastBearing"), -360.0, 360.0);
    bearingStep_ = addAngle(form, tr("Resolution"), QStringLiteral("bearingStep"), 0.001, 90.0);
    firstTilt_->setToolTip(tr("90° looks level, less looks down"));
    bearingStep_->setToolTip(tr("Angle between neighbouring points of a slice"));
    add(tr("S&peed"), speed_, QStringLiteral("speed"));
    setSetup({});
    for (const QComboBox* box : {scene_, noise_, speed_})
        connect(box, &QComboBox::currentIndexChanged, this, &SimulatorForm::changed);
    connect(seed_, &QLineEdit::textChanged, this, &SimulatorForm::changed);
}

QDoubleSpinBox* SimulatorForm::addAngle(QFormLayout* form, const QString& label, const QString& name, double lowest,
                                        double highest)
{
    auto* box = new PlainSpinBox(this);
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setDecimals(3);
    box->setRange(lowest, highest);
    box->setSuffix(QStringLiteral("°"));
    form->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SimulatorForm::changed);
    return box;
}

SimulationSetup SimulatorForm::setup() const
{
    return {.scene = chosen(scene_),
            .seed = seed_->text().toULongLong(),
            .noise = chosen(noise_),
            .firstTilt = firstTilt_->value(),
            .lastTilt = lastTilt_->value(),
            .tiltStep = tiltStep_->value(),
            .firstBearing = firstBearing_->value(),
            .lastBearing = lastBearing_->value(),
            .bearingStep = bearingStep_->value(),
            .speed = speed_->currentData().toDouble()};
}

void SimulatorForm::setSetup(const SimulationSetup& setup)
{
    choose(scene_, setup.scene);
    seed_->setText(QString::number(setup.seed));
    choose(noise_, setup.noise);
    firstTilt_->setValue(setup.firstTilt);
    lastTilt_->setValue(setup.lastTilt);
    tiltStep_->setValue(setup.tiltStep);
    firstBearing_->setValue(setup.firstBearing);
    lastBearing_->setValue(setup.lastBearing);
    bearingStep_->setValue(setup.bearingStep);
    chooseSpeed(speed_, setup.speed);
}

}  // namespace planewright
