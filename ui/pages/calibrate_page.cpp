// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate_page.h"

#include "core/calibration/calibration_record.h"
#include "ui/pages/calibrate_baseline.h"
#include "ui/pages/calibrate_check.h"
#include "ui/pages/calibrate_example.h"
#include "ui/pages/calibrate_sensors.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QKeyEvent>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

struct CalibratePage::Private {
    QTabBar* tabs = nullptr;
    QStackedWidget* stack = nullptr;
    CalibrateSensors* sensors = nullptr;
    CalibrateCheck* check = nullptr;
    CalibrateBaseline* baseline = nullptr;
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
    d->baseline = new CalibrateBaseline(bench, this);
    const std::pair<QWidget*, QString> parts[] = {
        {d->sensors, tr("Sensors")}, {d->check, tr("Spring check")}, {d->baseline, tr("Empty gripper")}};
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
    if (!d->active || shown != d->baseline)
        d->baseline->leave();
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

void CalibratePage::keyPressEvent(QKeyEvent* event)
{
    QWidget* shown = d->stack->currentWidget();
    if (event->isAutoRepeat() || (event->key() != Qt::Key_Space && event->key() != Qt::Key_Backspace))
        return Page::keyPressEvent(event);
    if (event->key() == Qt::Key_Backspace)
        return shown == d->sensors ? d->sensors->undo() : void();
    if (shown == d->check)
        d->check->act();
    else if (shown == d->baseline)
        d->baseline->act();
    else
        d->sensors->act();
}

void CalibratePage::prepareTour()
{
    workbench().ask<void>(this, storeExamples, [this](const Expected<void>& done) {
        if (!done)
            workbench().report(done.error().describe());
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
