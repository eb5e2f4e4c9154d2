// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/inspecting.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/models/history_model.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/inspection_widgets.h"

#include <QTableView>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test::inspecting;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;

/// One squeeze has one length, whoever tells it.
class SqueezeLengthTest : public QObject {
    Q_OBJECT
private slots:
    void oneLengthWhereverItIsTold_data()
    {
        QTest::addColumn<bool>("early");
        QTest::newRow("ended when it was decided") << true;
        QTest::newRow("through") << false;
    }
    void oneLengthWhereverItIsTold()
    {
        QFETCH(bool, early);
        Armed armed;
        WindowFixture& f = armed.f;
        f.bench->inspection().setEarlyEnd(early);
        squeezeBySpace(f);
        const InspectSession::Result& result = *f.bench->inspection().result();
        QCOMPARE(result.seconds, lengthSeconds(result.recording));
        const QString length = formatLength(result.seconds);

        const QString facts = f.find<ElidedLabel>("factsLabel")->accessibleName();
        QVERIFY2(facts.contains(u"length "_s + length), qPrintable(facts));
        QVERIFY(facts.contains(u"when it was decided"_s) == result.earlyEnd.has_value());
        QVERIFY(!facts.contains(u"decided after"_s)); // a time of its own
        const auto* list = f.find<InspectionList>("inspectionList");
        QTRY_COMPARE_WITH_TIMEOUT(list->lineModel().lines().size(), std::size_t(1), longEnough_ms);
        QCOMPARE(formatLength(list->lineModel().lines().front().seconds), length);

        f.window->showPage(u"fit"_s);
        const auto* fit = f.find<ElidedLabel>("fitFacts");
        QTRY_VERIFY_WITH_TIMEOUT(fit->accessibleName().startsWith(u"length "_s + length), longEnough_ms);
        QVERIFY(fit->accessibleName().contains(u" samples "_s));

        f.window->showPage(u"history"_s);
        const auto* table = f.find<QTableView>("historyTable");
        const auto cell = [table] {
            return HistoryDelegate::text(table->model()->index(0, int(HistoryColumn::Seconds)));
        };
        QTRY_COMPARE_WITH_TIMEOUT(cell(), length, longEnough_ms);
        SqueezeDetails details;
        details.entry.seconds = result.seconds;
        const std::vector<Fact> told = HistoryWords::facts(details);
        QVERIFY(std::any_of(told.begin(), told.end(), [&length](const Fact& fact) {
            return fact.name == u"Length"_s && fact.text == length;
        }));
    }
};

GRIPSCOPE_TEST(SqueezeLengthTest)
#include "squeeze_length_test.moc"
