// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/estimate_words.h"
#include "ui/models/budget_table_model.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// The first group of every match in the sources of a folder.
QStringList inSources(const QString& folder, const QString& pattern)
{
    QSet<QString> found;
    const QDir place(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/") + folder);
    for (const QString& name : place.entryList({u"*.cpp"_s})) {
        QFile file(place.filePath(name));
        if (!file.open(QIODevice::ReadOnly))
            qFatal("%s", qPrintable(file.fileName()));
        const QString text = QString::fromUtf8(file.readAll());
        for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();)
            found.insert(match.next().captured(1));
    }
    return {found.begin(), found.end()};
}

} // namespace

/// What the numerics name by an id, a person reads by a name; one that was forgotten would be shown as it is
/// stored.
class EstimateNamesTest : public QObject {
    Q_OBJECT
private slots:
    void everyCheckHasAName()
    {
        const QStringList ids = inSources(u"core/identification/validity"_s,
                                          u"(?:check\\.id = |residualTest\\(\\s*)u\"([a-z_]+)\"_s"_s);
        QVERIFY2(ids.size() >= 15 && ids.contains(u"fit"_s) && ids.contains(u"residual_whiteness"_s),
                 qPrintable(ids.join(u' ')));
        for (const QString& id : ids)
            QVERIFY2(checkName(id) != id, qPrintable(id));
    }
    void everyStepOfThePreparationHasAName()
    {
        const QStringList ids =
            inSources(u"core/signal/preparation"_s, u"(?:return |PreparationStep)\\{\\s*u\"([a-z_]+)\"_s"_s);
        QVERIFY2(ids.size() >= 10 && ids.contains(u"force_noise"_s), qPrintable(ids.join(u' ')));
        for (const QString& id : ids)
            QVERIFY2(preparationName(id) != id, qPrintable(id));
    }
    void everyLineOfTheBudgetHasAName()
    {
        const QStringList ids =
            inSources(u"core/identification/uncertainty"_s, u"lineOf\\(\\s*u\"([a-z_]+)\"_s"_s);
        QVERIFY2(ids.size() >= 5 && ids.contains(u"calibration"_s), qPrintable(ids.join(u' ')));
        UncertaintyBudget budget;
        for (const QString& id : ids) {
            BudgetLine line;
            line.id = id;
            budget.lines = {line};
            BudgetTableModel model;
            model.setBudget(budget, u"N"_s, u"m"_s);
            const QString name = model.index(0, int(BudgetTableModel::Column::Effect)).data().toString();
            QVERIFY2(!name.isEmpty() && name != id, qPrintable(id));
        }
    }
};

GRIPSCOPE_TEST(EstimateNamesTest)
#include "estimate_names_test.moc"
