// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "core/session/process/fixed_limits.h"
#include "tests/core/signal/measured_can.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "tests/ui/shifting.h"

#include <QLabel>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test::inspecting;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;

/// A part that has moved since its enrolment is told on Inspect, in a sentence that is there whole.
class InspectDriftPageTest : public QObject {
    Q_OBJECT
private slots:
    void whatMovedIsToldWhole()
    {
        WindowFixture f(true, gripscope::test::unhurriedA);
        f.window->showPage(u"inspect"_s);
        f.window->resize(1024, 640);
        const auto* label = f.find<QLabel>("driftLabel");
        QVERIFY(label->isHidden());
        gripscope::test::MeasuredCan stiffer;
        for (double* const value : {&stiffer.truth.m, &stiffer.truth.b, &stiffer.truth.k})
            *value *= 1.05; // still recognised
        InspectSession& inspection = f.bench->inspection();
        QTRY_VERIFY_WITH_TIMEOUT(inspection.state() == InspectSession::State::Ready, longEnough_ms);
        inspection.setExpectedType(u"A"_s);
        for (std::uint64_t seed = 1; seed <= 16; ++seed) {
            stiffer.seed = seed;
            gripscope::test::shifting::judgePart(f, stiffer);
        }
        QTRY_VERIFY_WITH_TIMEOUT(label->isVisible() && label->text().contains(u"A has moved"_s),
                                 longEnough_ms);
        QVERIFY(label->height() >= label->heightForWidth(label->width()));
        QVERIFY(label->toolTip().contains(label->text())); // with how far, there
    }
    /// Limits that somebody fixed on the charts of the type: the part that is beyond them is told at once.
    void whatAFixedChartSignalsIsTold()
    {
        WindowFixture f(true, gripscope::test::unhurriedA);
        f.window->showPage(u"inspect"_s);
        const auto* label = f.find<QLabel>("driftLabel");
        InspectSession& inspection = f.bench->inspection();
        QTRY_VERIFY_WITH_TIMEOUT(inspection.state() == InspectSession::State::Ready, longEnough_ms);
        gripscope::test::MeasuredCan can;
        FixedLimits fixed;
        fixed.quantities[2] = {can.truth.k, 0.02 * can.truth.k};
        const auto fix = [&f](const QString& limits) {
            bool done = false;
            f.bench->background().ask<void>(
                nullptr,
                [limits](Library& library) { return library.fixProcessLimits(u"A"_s, limits, u"Ada"_s); },
                [&done](const Expected<void>& stored) { done = stored.has_value(); });
            QTRY_VERIFY_WITH_TIMEOUT(done, longEnough_ms);
        };
        fix(toText(fixed));
        inspection.setExpectedType(u"A"_s);
        gripscope::test::shifting::judgePart(f, can);
        QVERIFY(label->isHidden());
        fixed.quantities[2]->centre = 0.9 * can.truth.k; // what is usual is five sigma above
        fix(toText(fixed));
        gripscope::test::shifting::judgePart(f, can);
        QTRY_VERIFY_WITH_TIMEOUT(label->isVisible(), longEnough_ms);
        QVERIFY2(label->text().contains(u"The charts of A signal."_s) &&
                     label->text().contains(u"above the upper limit"_s),
                 qPrintable(label->text()));
    }
};

GRIPSCOPE_TEST(InspectDriftPageTest)
#include "inspect_drift_page_test.moc"
