// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate/calibrate_page.h"

#include "core/calibration/calibration_plan.h"
#include "core/calibration/calibration_record.h"
#include "core/math/gaussian.h"
#include "ui/context/workbench.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/widgets/controls.h"

#include <QKeyEvent>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

SensorCalibration exampleCalibration()
{
    SensorCalibration calibration;
    calibration.gripperSerial = u"VG-1"_s;
    calibration.gripperName = u"Virtual gripper"_s;
    calibration.unit = u"N"_s;
    calibration.reference = {u"Weights M1, set 4711"_s, u"D-K-17 2026-03"_s, 0.002, 0};
    calibration.operatorName = u"Mai"_s;
    calibration.takenUtc = QDateTime::currentDateTimeUtc();
    calibration.due = calibration.takenUtc.date().addYears(1);
    calibration.reference.due = calibration.due.addYears(1);
    calibration.conditions.ambient_C = 21.5;
    calibration.conditions.tolerance = 0.2;
    calibration.foundCorrection = u""_s;
    CalibrationPlan plan;
    plan.runs = 3;
    GaussianNoise noise(4);
    constexpr double noise_N = 0.01;
    constexpr double hysteresis_N = 0.02;
    const double full = plan.loads.back();
    for (const PlannedPoint& point : plannedPoints(plan)) {
        const double sag =
            point.ascending ? 0 : 4 * hysteresis_N * point.load / full * (1 - point.load / full);
        calibration.points.push_back({point.load, 0.05 + 1.012 * point.load + sag + noise_N * noise()});
    }
    return calibration;
}

ReferenceObject exampleReference()
{
    ReferenceObject reference;
    reference.gripperSerial = u"VG-1"_s;
    reference.name = u"Spring S-12"_s;
    reference.certificate = u"F-0815 2026-02"_s;
    reference.stated[2] = ReferenceQuantity{9990, 25, 300};
    reference.operatorName = u"Mai"_s;
    return reference;
}

Expected<void> storeExamples(Library& library)
{
    RETURN_IF_ERROR(library.addCalibration(exampleCalibration()));
    const ReferenceObject reference = exampleReference();
    RETURN_IF_ERROR(library.addReferenceObject(reference));
    ASSIGN_OR_RETURN(const CalibrationsInForce standing,
                     library.calibrationsInForce(reference.gripperSerial));
    for (const double stiffness : {9952.0, 10010.0, 9973.0, 10021.0}) {
        ReferenceCheck check;
        check.gripperSerial = reference.gripperSerial;
        check.referenceId = standing.reference->reference.id;
        check.measured[2] = MeasuredQuantity{stiffness, 30};
        check.verdict = judgeCheck(reference, check.measured);
        check.squeezes = reference.squeezes;
        check.operatorName = reference.operatorName;
        RETURN_IF_ERROR(library.addReferenceCheck(check));
    }
    return {};
}

struct CalibratePage::Private {
    QTabBar* tabs = nullptr;
    QStackedWidget* stack = nullptr;
    CalibrateSensors* sensors = nullptr;
    CalibrateCheck* check = nullptr;
    CalibrateGripper* gripper = nullptr;
    bool active = false;
};

CalibratePage::CalibratePage(Workbench& bench, QWidget* parent)
    : Page(bench, parent), d(std::make_unique<Private>())
{
    d->tabs = new QTabBar(this);
    d->tabs->setObjectName("calibrateTabs");
    d->tabs->setAccessibleName(tr("Parts of this page"));
    d->tabs->setDrawBase(false);
    d->tabs->setExpanding(false);
    d->stack = new QStackedWidget(this);
    d->sensors = new CalibrateSensors(bench, this);
    d->check = new CalibrateCheck(bench, this);
    d->gripper = new CalibrateGripper(bench, this);
    const std::pair<QWidget*, QString> parts[] = {
        {d->sensors, tr("Sensors")}, {d->check, tr("Spring check")}, {d->gripper, tr("This gripper")}};
    for (const auto& [part, name] : parts) {
        d->tabs->addTab(name);
        d->stack->addWidget(part);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 4, 16, 16);
    column->setSpacing(4);
    column->addWidget(d->tabs);
    column->addWidget(d->stack, 1);
    setFocusPolicy(Qt::StrongFocus);
    connect(d->tabs, &QTabBar::currentChanged, this, &CalibratePage::show);
    // While points are taken, the whole page is for them.
    connect(d->sensors, &CalibrateSensors::takingChanged, this,
            [this](bool taking) { d->tabs->setVisible(!taking); });
}

CalibratePage::~CalibratePage() = default;

QString CalibratePage::id() const
{
    return u"calibrate"_s;
}

QString CalibratePage::title() const
{
    return tr("Calibrate");
}

QString CalibratePage::iconName() const
{
    return u"measure"_s;
}

void CalibratePage::show(int part)
{
    d->stack->setCurrentIndex(part);
    QWidget* shown = d->stack->currentWidget();
    // Nobody looks at it any more: nothing moves on.
    if (!d->active || shown != d->check)
        d->check->leave();
    if (!d->active || shown != d->gripper)
        d->gripper->leave();
    d->sensors->setActive(d->active && shown == d->sensors);
    d->check->setActive(d->active && shown == d->check);
}

void CalibratePage::setActive(bool active)
{
    d->active = active;
    show(d->tabs->currentIndex());
    if (active)
        setFocus();
}

bool CalibratePage::underWay() const
{
    return d->sensors->underWay() || d->check->underWay() || d->gripper->underWay();
}

void CalibratePage::keyPressEvent(QKeyEvent* event)
{
    QWidget* shown = d->stack->currentWidget();
    if (event->isAutoRepeat() || (event->key() != Qt::Key_Space && event->key() != Qt::Key_Backspace))
        return Page::keyPressEvent(event);
    if (event->key() == Qt::Key_Backspace)
        return shown == d->sensors ? d->sensors->undo() : void();
    if (shown == d->check)
        d->check->act();
    else if (shown == d->gripper)
        d->gripper->act();
    else
        d->sensors->act();
}

void CalibratePage::prepareTour()
{
    workbench().background().ask<void>(this, storeExamples, [this](const Expected<void>& done) {
        if (!done)
            workbench().messages().report(done.error().describe());
        d->sensors->reload();
        workbench().connectTo(u"virtual:"_s);
    });
}

bool CalibratePage::tourReady() const
{
    return d->sensors->loaded() &&
           workbench().connection().calibration().record(SensorChannel::Force) != nullptr;
}

} // namespace gripscope
