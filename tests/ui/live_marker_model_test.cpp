// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/models/live_marker_model.h"

#include <QAbstractItemModelTester>
#include <QTest>

using namespace gripscope;
using MarkerColumn = LiveMarkerModel::Column;

class LiveMarkerModelTest : public QObject {
    Q_OBJECT

    static LiveMarker at(double time_s)
    {
        LiveMarker marker;
        marker.time_s = time_s;
        marker.when = QDateTime({2026, 3, 1}, {14, 5, 9, 250});
        return marker;
    }

private slots:
    void markersStandInOrderOfTimeAndKeepTheirNumbers()
    {
        LiveMarkerModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const double time_s : {5.0, 2.0, 9.0})
            model.add(at(time_s));
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(0, int(MarkerColumn::Number)).data().toInt(), 2);
        QCOMPARE(model.index(1, int(MarkerColumn::Number)).data().toInt(), 1);
        QCOMPARE(model.index(1, int(MarkerColumn::When)).data().toString(), QStringLiteral("14:05:09.250"));
        model.remove(1);
        model.add(at(6));
        QCOMPARE(model.index(1, int(MarkerColumn::Number)).data().toInt(), 4);
        model.clear();
        QCOMPARE(model.rowCount(), 0);
    }
    void onlyTheWordsCanBeChanged()
    {
        LiveMarkerModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.add(at(1));
        const QModelIndex words = model.index(0, int(MarkerColumn::Words));
        QVERIFY(words.flags() & Qt::ItemIsEditable);
        QVERIFY(!(model.index(0, int(MarkerColumn::When)).flags() & Qt::ItemIsEditable));
        QVERIFY(model.setData(words, QStringLiteral(" part\nturned "), Qt::EditRole));
        QCOMPARE(words.data().toString(), QStringLiteral("part turned"));
        QVERIFY(!model.setData(model.index(0, 0), 7, Qt::EditRole));
    }
    void theOldestGoWhenThereAreTooMany()
    {
        LiveMarkerModel model;
        for (int i = 0; i <= LiveMarkerModel::most; ++i)
            model.add(at(i));
        QCOMPARE(model.rowCount(), LiveMarkerModel::most);
        QCOMPARE(model.markers().front().time_s, 1.0);
    }
};

GRIPSCOPE_TEST(LiveMarkerModelTest)
#include "live_marker_model_test.moc"
