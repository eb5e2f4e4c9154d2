// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/signal/measured_can.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/quality/shift/shift_views.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

/// What moved, and types on another gripper, by click and key.
namespace gripscope::test::shifting {

using namespace Qt::StringLiterals;

constexpr double pageGain = 1.05; ///< the second gripper finds so much more of everything

inline StudySession& transferStudy(WindowFixture& f)
{
    return f.bench->study();
}

/// A recording of this part is judged and in the library.
inline void judgePart(WindowFixture& f, const MeasuredCan& part)
{
    InspectSession& inspection = f.bench->inspection();
    QVERIFY(inspection.judgeRecording(part.make(), u"file"_s));
    QTRY_VERIFY_WITH_TIMEOUT(inspection.state() == InspectSession::State::Ready && !inspection.storing(),
                             longEnough_ms);
}

/// So many parts of A, those after the first six by 30 % of everything more.
inline void judgeMovedParts(WindowFixture& f, int all, int asEnrolled = 6)
{
    MeasuredCan can;
    f.bench->inspection().setExpectedType(u"A"_s);
    for (int i = 0; i < all; ++i) {
        MeasuredCan one = can;
        one.seed = std::uint64_t(i + 1);
        if (i >= asEnrolled)
            for (double* const value : {&one.truth.m, &one.truth.b, &one.truth.k})
                *value *= 1.3;
        judgePart(f, one);
    }
}

inline void openView(WindowFixture& f, const char* button)
{
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>(button));
}

/// A and C are chosen, so many squeezes of each.
inline void beginTransfer(WindowFixture& f, int trials)
{
    openView(f, "beginTransfer");
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QCheckBox*>(u"transferType-A"_s), longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("transferSituation")->text().contains(u"VG-5"_s), longEnough_ms);
    for (const char* const other : {"transferType-B", "transferType-D"})
        f.find<QCheckBox>(other)->click();
    f.find<QSpinBox>("transferTrials")->setValue(trials);
    f.clickWhenEnabled(f.find<QPushButton>("transferBegin"));
    QTRY_VERIFY_WITH_TIMEOUT(transferStudy(f).state() == StudySession::State::Waiting, longEnough_ms);
    QTRY_VERIFY(f.find<QLabel>("transferPart")->isVisible());
}

/// The gripper holds a part of the type that is asked for (or another), and finds a twentieth too much.
inline void putPartIn(WindowFixture& f, std::optional<QString> type = {})
{
    const QString wanted = type.value_or(transferStudy(f).study()->plan.part(*transferStudy(f).nextRow()));
    const MassDampingStiffness part = wanted == u"A"_s   ? MassDampingStiffness{0.0396, 43.0, 9990}
                                      : wanted == u"B"_s ? MassDampingStiffness{0.031, 52, 13500}
                                                         : MassDampingStiffness{0.0301, 37.1, 3562};
    f.connectTo(u"virtual:?object=%1,%2,%3&seed=5&speed=0&part=%4&part-spread=0.01"_s.arg(pageGain * part.m)
                    .arg(pageGain * part.b)
                    .arg(pageGain * part.k)
                    .arg(transferStudy(f).study()->measurements.size() + 1));
    auto* arm = f.find<QPushButton>("transferArm");
    QTRY_VERIFY_WITH_TIMEOUT(arm->isVisible() && arm->isEnabled(), longEnough_ms);
    f.click(arm);
}

inline void squeezeOne(WindowFixture& f)
{
    const std::size_t before = transferStudy(f).progress().done;
    putPartIn(f);
    auto* act = f.find<QPushButton>("transferAct");
    QTRY_VERIFY_WITH_TIMEOUT(act->isVisible() && act->isEnabled(), longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->focusWidget() == act, longEnough_ms);
    QTest::keyClick(act, Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(transferStudy(f).progress().done, before + 1, longEnough_ms);
    QTRY_VERIFY_WITH_TIMEOUT(transferStudy(f).state() == StudySession::State::Waiting, longEnough_ms);
}

inline bool isLookedAt(WindowFixture& f, int squeezes)
{
    const auto* view = f.window->findChild<TransferView*>();
    return QTest::qWaitFor(
        [&] {
            return !view->watch().busy() && view->watch().look() &&
                   view->watch().look()->squeezes == squeezes;
        },
        longEnough_ms);
}

inline void answer(WindowFixture& f, const char* question, const QString& text)
{
    const auto asked = [&] { return f.window->findChild<TextQuestion*>(QLatin1StringView(question)); };
    QTRY_VERIFY_WITH_TIMEOUT(asked() != nullptr, longEnough_ms);
    QTest::keyClicks(asked()->field(), text);
    QTest::keyClick(asked()->field(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(asked() == nullptr, longEnough_ms);
    f.makeActive();
}

} // namespace gripscope::test::shifting
