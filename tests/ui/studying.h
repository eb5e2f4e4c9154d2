// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/workbench_fixture.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

/// Studies on the Quality page, by click and key.
namespace gripscope::test::studying {

using namespace Qt::StringLiterals;
using State = StudySession::State;

inline StudySession& study(WindowFixture& f)
{
    return f.bench->study();
}

/// The virtual gripper holds the part that the plan asks for, in the hands of its operator.
inline void putIn(WindowFixture& f, const PlanRow& row)
{
    f.connectTo(u"virtual:?object=0.04,43,9990&seed=5&speed=0&part=%1&operator=%2&trial=%3&part-spread=0.05&"
                "operator-spread=0.002&repeat-spread=0.004"_s.arg(row.part + 1)
                    .arg(row.operators + 1)
                    .arg(row.trial + 1));
    auto* arm = f.find<QPushButton>("studyArm");
    QTRY_VERIFY_WITH_TIMEOUT(arm->isVisible() && arm->isEnabled(), longEnough_ms);
    f.click(arm);
}

inline void pressSpaceOn(WindowFixture& f, const char* button)
{
    auto* act = f.find<QPushButton>(button);
    QTRY_VERIFY_WITH_TIMEOUT(act->isVisible() && act->isEnabled(), longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->focusWidget() == act, longEnough_ms);
    QTest::keyClick(act, Qt::Key_Space);
}

inline void squeezeNext(WindowFixture& f)
{
    const std::size_t before = study(f).progress().done;
    putIn(f, study(f).study()->plan.rows[*study(f).nextRow()]);
    pressSpaceOn(f, "studyAct");
    QTRY_COMPARE_WITH_TIMEOUT(study(f).progress().done, before + 1, longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
}

/// From the button on the list to the first squeeze.
inline void beginStudy(WindowFixture& f, int parts, const QString& people, int trials)
{
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>("begin-gauge"));
    f.find<QSpinBox>("studyParts")->setValue(parts);
    f.find<QSpinBox>("studyTrials")->setValue(trials);
    auto* operators = f.find<QLineEdit>("studyOperators");
    operators->selectAll();
    QTest::keyClicks(operators, people);
    QTest::keyClick(operators, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
    QTRY_VERIFY(f.find<QLabel>("studyPart")->isVisible());
}

/// 3 parts, 2 operators, 2 trials.
inline void beginSmallStudy(WindowFixture& f)
{
    beginStudy(f, 3, u"Anna, Ben"_s, 2);
}

inline QString nextPart(WindowFixture& f)
{
    return study(f).study()->plan.part(*study(f).nextRow());
}

/// The program ends, and is started again on that library.
inline void startAgainOn(WindowFixture& f, const QString& file)
{
    f.window.reset();
    f.bench.reset();
    f.bench = std::make_unique<Workbench>(file);
    f.bench->setOperatorName(u"Mai"_s);
    f.bench->setLinkLimits(patientLimits());
    f.window = std::make_unique<MainWindow>(*f.bench);
    f.window->resize(1024, 640);
    f.window->show();
    f.makeActive();
}

inline void startAgain(WindowFixture& f)
{
    startAgainOn(f, QString(f.bench->library().file()));
}

inline void goOnWithStudy(WindowFixture& f)
{
    f.window->showPage(u"quality"_s);
    QPushButton* goOn = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((goOn = f.window->findChild<QPushButton*>(u"goOnWithStudy"_s)) != nullptr,
                             longEnough_ms);
    f.clickWhenEnabled(goOn);
    QTRY_VERIFY_WITH_TIMEOUT(study(f).state() == State::Waiting, longEnough_ms);
}

/// The result is worked out and shown; gives its first sentence.
inline QString shownVerdict(WindowFixture& f)
{
    auto* verdict = f.find<QLabel>("studyVerdict");
    if (!QTest::qWaitFor(
            [&] { return verdict->isVisible() && study(f).result() && study(f).state() == State::Ended; },
            longEnough_ms))
        qFatal("there is no result");
    QCoreApplication::processEvents();
    return verdict->text();
}

} // namespace gripscope::test::studying
