// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/gaussian.h"
#include "tests/core/library/process_inspections.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/quality/process/process_view.h"

#include <QComboBox>
#include <QPushButton>

/// Control charts and capability on the Quality page, by click and key.
namespace gripscope::test::charting {

using namespace Qt::StringLiterals;

/// Normal parts of A; the last ones are stiffer by four deviations.
inline void storeParts(WindowFixture& f, int count, int moved = 0)
{
    bool done = false;
    f.bench->background().ask<void>(
        nullptr,
        [count, moved](Library& library) -> Expected<void> {
            GaussianNoise noise(4);
            const QDateTime start(QDate(2026, 5, 4), QTime(8, 0), Qt::UTC);
            for (int i = 0; i < count; ++i)
                addPart(library, {.parameters = {0.04 + 1e-4 * noise(), 43 + 0.2 * noise(),
                                                 9990 + 20 * noise() + (i >= count - moved ? 80 : 0)},
                                  .operatorName = i % 2 == 0 ? u"Ada"_s : u"Bob"_s,
                                  .gripper = i % 3 == 0 ? u"0001"_s : u"0002"_s,
                                  .time = start.addSecs(60 * i)});
            return {};
        },
        [&done](const Expected<void>& stored) { done = stored.has_value(); });
    QTRY_VERIFY_WITH_TIMEOUT(done, longEnough_ms);
    f.bench->tellLibraryChanged();
}

inline ProcessView& view(WindowFixture& f)
{
    return *f.window->findChild<ProcessView*>();
}

inline void openProcess(WindowFixture& f)
{
    f.window->showPage(u"quality"_s);
    f.clickWhenEnabled(f.find<QPushButton>("openProcess"));
    QTRY_VERIFY(view(f).isVisible());
}

/// Charts of so many inspections are there.
inline void waitFor(WindowFixture& f, std::size_t inspections)
{
    QTRY_VERIFY_WITH_TIMEOUT(view(f).session().state() == ProcessSession::State::Shown &&
                                 view(f).session().picture() &&
                                 view(f).session().picture()->rows.size() == inspections,
                             longEnough_ms);
}

/// As a person does, by its words.
inline void choose(WindowFixture& f, const char* box, const QString& words)
{
    auto* combo = f.find<QComboBox>(box);
    const int index = combo->findText(words);
    QVERIFY2(index >= 0, qPrintable(words));
    combo->setFocus();
    while (combo->currentIndex() != index)
        QTest::keyClick(combo, combo->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
}

} // namespace gripscope::test::charting
