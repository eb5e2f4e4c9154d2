// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/workbench_fixture.h"

#include <QCheckBox>
#include <QPushButton>

namespace gripscope::test {

// The steps of an enrolment by click and key, as tests of the Enroll page go through them.

/// The name that is proposed gives way to this one.
inline void enterTypeName(WindowFixture& f, const QString& name)
{
    f.window->showPage(QStringLiteral("enroll"));
    auto* field = f.find<QLineEdit>("typeName");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(f.bench->enrollment().step(), EnrollSession::Step::Recipe);
}

/// With the recipe that is proposed; each squeeze is then decided on.
inline void pageAtSqueezes(WindowFixture& f, const QString& name)
{
    enterTypeName(f, name);
    f.click(f.find<QPushButton>("recipeNext"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Squeeze, longEnough_ms);
    f.find<QCheckBox>("acceptByItself")->setChecked(false);
}

inline void squeezeAndAccept(WindowFixture& f)
{
    auto* squeeze = f.find<QPushButton>("enrollSqueezeButton");
    QTRY_VERIFY_WITH_TIMEOUT(squeeze->isEnabled(), longEnough_ms);
    const int before = f.bench->enrollment().acceptedCount();
    f.click(squeeze);
    auto* accept = f.find<QPushButton>("acceptButton");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isVisible(), longEnough_ms);
    QVERIFY2(accept->isEnabled(), qPrintable(f.bench->enrollment().squeezes().back().reason));
    f.click(accept);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), before + 1, longEnough_ms);
}

} // namespace gripscope::test
