// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/device_form.h"

#include <algorithm>

#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/device_details.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/problem_label.h"

namespace planewright {

namespace {

/// Sign and words of a check; the sign alone does not tell, for those who do not see colours.
QString lineOf(const DeviceCheck& check)
{
    const QString name = QString::fromStdString(check.name).toHtmlEscaped();
    const QString detail = QString::fromStdString(check.detail).toHtmlEscaped();
    const QString tail = detail.isEmpty() ? QString{} : QStringLiteral(": ") + detail;
    switch (check.state) {
        case DeviceCheck::State::Waiting:
            return QStringLiteral("○ ") + name;
        case DeviceCheck::State::Running:
            return QStringLiteral("◌ ") + name + (detail.isEmpty() ? QStringLiteral("…") : tail);
        case DeviceCheck::State::Passed:
            return QStringLiteral("✔ ") + name + tail;
        case DeviceCheck::State::Failed:
            break;
    }
    return QStringLiteral("<b>✘ ") + name + QStringLiteral("</b>") + tail;
}

QLabel* textLabel(const QString& name, const QString& accessible, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setAccessibleName(accessible);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->hide();
    return label;
}

}  // namespace

DeviceForm::DeviceForm(QWidget* parent)
    : QWidget(parent),
      trouble_(new ProblemLabel(this)),
      copyCure_(new QPushButton(tr("&Copy the command"), this)),
      mode_(new QuietComboBox(this)),
      buttons_(new QWidget(this)),
      search_(new QPushButton(tr("&Find devices"), buttons_)),
      test_(new QPushButton(tr("&Test"), buttons_)),
      home_(new QPushButton(tr("Move to &level"), buttons_)),
      recovery_(new QWidget(this)),
      recover_(new QPushButton(tr("&Release the tilt unit"), recovery_)),
      details_(new DeviceDetails(this)),
      checks_(textLabel(QStringLiteral("deviceChecks"), tr("Checks of the devices"), this)),
      facts_(textLabel(QStringLiteral("deviceFacts"), tr("Health of the devices"), this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    layout->addLayout(form);
    laser_ = addAddress(form, tr("L&aser"), QStringLiteral("laser"), tr("usb:  or  tcp:192.168.0.10:10940"));
    unit_ = addAddress(form, tr("Tilt &unit"), QStringLiteral("tiltUnit"), tr("dynamixel:usb:  or  board:usb:"));
    trouble_->setObjectName(QStringLiteral("deviceTrouble"));
    trouble_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    form->addRow(trouble_);
    copyCure_->setObjectName(QStringLiteral("copyCure"));
    copyCure_->setToolTip(tr("To be pasted into a terminal, once"));
    copyCure_->hide();
    form->addRow(copyCure_);
    mode_->setObjectName(QStringLiteral("scanMode"));
    mode_->setAccessibleName(tr("Motion"));
    mode_->addItems({tr("Sweep"), tr("Step and stare")});
    mode_->setToolTip(
        tr("A sweep takes a slice with each turn of the mirror while the head moves on; or the head stands "
           "still for each slice"));
    form->addRow(tr("&Motion"), mode_);
    firstTilt_ = addAngle(form, tr("Tilt from"), QStringLiteral("deviceFirstTilt"), -360.0, 360.0);
    lastTilt_ = addAngle(form, tr("Tilt to"), QStringLiteral("deviceLastTilt"), -360.0, 360.0);
    tiltStep_ = addAngle(form, tr("Tilt step"), QStringLiteral("deviceTiltStep"), -90.0, 90.0);
    firstBearing_ = addAngle(form, tr("Bearing from"), QStringLiteral("deviceFirstBearing"), -180.0, 360.0);
    lastBearing_ = addAngle(form, tr("Bearing to"), QStringLiteral("deviceLastBearing"), -180.0, 360.0);
    firstTilt_->setToolTip(tr("90° looks level, less looks down"));
    tiltStep_->setToolTip(tr("Steps of a servo with 1023 counts over 300° are multiples of 0.293°"));
    layout->addWidget(details_);
    addButtons(layout);
    addRecovery(layout);
    layout->addWidget(checks_);
    layout->addWidget(facts_);
    setSetup({});
    for (QComboBox* box : {laser_, unit_})
        connect(box, &QComboBox::editTextChanged, this, &DeviceForm::changed);
    connect(mode_, &QComboBox::currentIndexChanged, this, &DeviceForm::changed);
    connect(details_, &DeviceDetails::changed, this, &DeviceForm::changed);
    connect(this, &DeviceForm::changed, this, &DeviceForm::check);
    setTestable(true);
}

void DeviceForm::addButtons(QVBoxLayout* layout)
{
    auto* lines = new QVBoxLayout(buttons_);
    lines->setContentsMargins({});
    auto* buttons = new QHBoxLayout;
    search_->setObjectName(QStringLiteral("findDevices"));
    search_->setToolTip(tr("Looks for what is connected, and asks lasers for their number"));
    test_->setObjectName(QStringLiteral("testDevices"));
    home_->setObjectName(QStringLiteral("homeDevices"));
    buttons->addWidget(search_);
    buttons->addWidget(test_);
    lines->addLayout(buttons);
    lines->addWidget(home_);
    layout->addWidget(buttons_);
    connect(search_, &QPushButton::clicked, this, &DeviceForm::searchRequested);
    connect(test_, &QPushButton::clicked, this, &DeviceForm::testRequested);
    connect(home_, &QPushButton::clicked, this, &DeviceForm::homeRequested);
    connect(copyCure_, &QPushButton::clicked, this, [this] {
        const DeviceChoice* choice = troubled(laser_) != nullptr ? troubled(laser_) : troubled(unit_);
        if (choice != nullptr)
            QGuiApplication::clipboard()->setText(QString::fromStdString(choice->cure));
    });
}

/// What a person does before a unit that has turned itself off may move again.
void DeviceForm::addRecovery(QVBoxLayout* layout)
{
    auto* steps = new QLabel(tr("<b>▲ The tilt unit waits for you.</b><br>1. Take away what blocks or pulls the "
                                "head.<br>2. Let the motor cool, until you can touch it.<br>3. Keep your hands away, "
                                "and release it: it then holds where it stands, and moves only when a test or a scan "
                                "is started."),
                             recovery_);
    steps->setObjectName(QStringLiteral("recoverySteps"));
    steps->setWordWrap(true);
    recover_->setObjectName(QStringLiteral("recoverDevices"));
    recover_->setToolTip(tr("Turns its torque on again where it stands; moves nothing"));
    auto* lines = new QVBoxLayout(recovery_);
    lines->setContentsMargins({});
    lines->addWidget(steps);
    lines->addWidget(recover_);
    recovery_->hide();
    layout->addWidget(recovery_);
    connect(recover_, &QPushButton::clicked, this, &DeviceForm::recoverRequested);
}

void DeviceForm::check()
{
    const bool hasUnit = !unit_->currentText().trimmed().isEmpty();
    const QString wrong = problem();
    test_->setEnabled(wrong.isEmpty() && isTestable_);
    test_->setToolTip(wrong.isEmpty() ? tr("Opens both, takes a slice, and moves the head by 5° and back") : wrong);
    home_->setEnabled(canGoHome());
    home_->setToolTip(canGoHome() || details_->problem().isEmpty()
                          ? tr("Brings the head to level, slowly, and holds it there; Stop motion holds it at once")
                          : details_->problem());
    recover_->setEnabled(hasUnit && isTestable_);
    search_->setEnabled(isTestable_);
    const DeviceChoice* choice = troubled(laser_) != nullptr ? troubled(laser_) : troubled(unit_);
    trouble_->tell(choice != nullptr ? QString::fromStdString(choice->problem) : searchProblem_);
    copyCure_->setVisible(choice != nullptr && !choice->cure.empty());
}

QComboBox* DeviceForm::addAddress(QFormLayout* form, const QString& label, const QString& name, const QString& hint)
{
    auto* box = new QuietComboBox(this);
    box->setObjectName(name);
    box->setAccessibleName(QString(label).remove('&'));
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    box->lineEdit()->setPlaceholderText(hint);
    form->addRow(label, box);
    // Of an address that is longer than the field its beginning tells more than its end.
    connect(box, &QComboBox::editTextChanged, this, [box](const QString& text) {
        box->setToolTip(text);
        if (!box->lineEdit()->hasFocus())
            box->lineEdit()->setCursorPosition(0);
    });
    // The list shows names, the field addresses.
    connect(box, &QComboBox::activated, this, [box](int index) { box->setEditText(box->itemData(index).toString()); });
    return box;
}

QDoubleSpinBox* DeviceForm::addAngle(QFormLayout* form, const QString& label, const QString& name, double lowest,
                                     double highest)
{
    auto* box = new PlainSpinBox(this);
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setDecimals(3);
    box->setRange(lowest, highest);
    box->setSuffix(QStringLiteral("°"));
    form->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &DeviceForm::changed);
    return box;
}

DeviceSetup DeviceForm::setup() const
{
    DeviceSetup setup{.laser = laser_->currentText().trimmed().toStdString(),
                      .tiltUnit = unit_->currentText().trimmed().toStdString(),
                      .stepAndStare = mode_->currentIndex() == 1,
                      .firstTilt = firstTilt_->value(),
                      .lastTilt = lastTilt_->value(),
                      .tiltStep = tiltStep_->value(),
                      .firstBearing = firstBearing_->value(),
                      .lastBearing = lastBearing_->value()};
    details_->writeTo(setup);
    return setup;
}

void DeviceForm::setSetup(const DeviceSetup& setup)
{
    laser_->setEditText(QString::fromStdString(setup.laser));
    unit_->setEditText(QString::fromStdString(setup.tiltUnit));
    mode_->setCurrentIndex(setup.stepAndStare ? 1 : 0);
    firstTilt_->setValue(setup.firstTilt);
    lastTilt_->setValue(setup.lastTilt);
    tiltStep_->setValue(setup.tiltStep);
    firstBearing_->setValue(setup.firstBearing);
    lastBearing_->setValue(setup.lastBearing);
    details_->setSetup(setup);
}

void DeviceForm::setChoices(const std::vector<DeviceChoice>& choices)
{
    choices_ = choices;
    for (QComboBox* box : {laser_, unit_}) {
        const QString typed = box->currentText();
        const QSignalBlocker quiet(box);
        box->clear();
        for (const DeviceChoice& choice : choices_) {
            if (box == laser_ ? !choice.isLaser : !choice.isTiltUnit)
                continue;
            const QString address = QString::fromStdString(choice.address);
            box->addItem(choice.name.empty() ? address : QString::fromStdString(choice.name) + " – " + address,
                         address);
        }
        // Where nothing was chosen yet, the only one that there is.
        box->setEditText(typed.isEmpty() && box->count() == 1 ? box->itemData(0).toString() : typed);
    }
    emit changed();
}

/// What was chosen, if it cannot be used, as far as is known.
const DeviceChoice* DeviceForm::troubled(const QComboBox* box) const
{
    const std::string address = box->currentText().trimmed().toStdString();
    const auto choice = std::find_if(choices_.begin(), choices_.end(),
                                     [&](const DeviceChoice& c) { return c.address == address && !c.problem.empty(); });
    return choice == choices_.end() ? nullptr : &*choice;
}

void DeviceForm::setChecks(const std::vector<DeviceCheck>& checks)
{
    QStringList lines;
    for (const DeviceCheck& check : checks)
        lines += lineOf(check);
    checks_->setText(lines.join(QStringLiteral("<br>")));
    checks_->setVisible(!lines.isEmpty());
}

/// Troubles first, in lines of their own; then a table of names and values.
void DeviceForm::setFacts(const std::vector<DeviceFact>& facts)
{
    QString lines;
    QString rows;
    for (const DeviceFact& fact : facts) {
        const QString name = QString::fromStdString(fact.name).toHtmlEscaped();
        const QString value = QString::fromStdString(fact.value).toHtmlEscaped();
        if (fact.name.empty())
            lines += QStringLiteral("<b>▲ %1</b><br>").arg(value);
        else if (fact.isTrouble)
            rows += QStringLiteral("<tr><td><b>▲ %1</b></td><td><b>%2</b></td></tr>").arg(name, value);
        else
            rows += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>").arg(name, value);
    }
    const QString text = facts.empty() ? QString{}
                                       : tr("<b>Health</b>") + QStringLiteral("<br>") + lines +
                                             QStringLiteral("<table cellpadding=\"1\" width=\"100%\">") + rows +
                                             QStringLiteral("</table>");
    // What has not changed stays selected.
    if (text != facts_->text())
        facts_->setText(text);
    facts_->setVisible(!facts.empty());
}

void DeviceForm::setTestable(bool testable)
{
    isTestable_ = testable;
    emit changed();
}

void DeviceForm::setConnectedHead(bool isThere)
{
    hasConnectedHead_ = isThere;
    emit changed();
}

bool DeviceForm::canGoHome() const
{
    return hasConnectedHead_ ||
           (isTestable_ && !unit_->currentText().trimmed().isEmpty() && details_->problem().isEmpty());
}

bool DeviceForm::canRecover() const
{
    return isRecoverable_ && isTestable_ && !unit_->currentText().trimmed().isEmpty();
}

void DeviceForm::setRecoverable(bool recoverable)
{
    isRecoverable_ = recoverable;
    recovery_->setVisible(recoverable);
    emit changed();
}

void DeviceForm::setSearchProblem(const QString& problem)
{
    searchProblem_ = problem;
    emit changed();
}

/// Limits that the address itself gives are looked at by whoever opens it.
QString DeviceForm::limitProblem() const
{
    const DeviceSetup now = setup();
    const bool saysItself =
        now.tiltUnit.find("lowest=") != std::string::npos || now.tiltUnit.find("highest=") != std::string::npos;
    const auto [low, high] = std::minmax(now.firstTilt, now.lastTilt);
    if (saysItself || (low >= now.lowest && high <= now.highest))
        return {};
    return tr("Tilt: give angles from %1° to %2°, or wider limits below.").arg(now.lowest).arg(now.highest);
}

QString DeviceForm::problem() const
{
    if (laser_->currentText().trimmed().isEmpty())
        return tr("Choose a laser, or type its address.");
    if (unit_->currentText().trimmed().isEmpty())
        return tr("Choose a tilt unit, or type its address.");
    const QString details = details_->problem();
    return details.isEmpty() ? limitProblem() : details;
}

}  // namespace planewright
