// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/comparison_table_model.h"

#include "core/base/csv.h"
#include "core/base/words.h"
#include "ui/format/number_format.h"

#include <QCoreApplication>
#include <QHash>

namespace gripscope {

using namespace Qt::StringLiterals;

void ComparisonTableModel::setComparison(const ModelComparison& comparison)
{
    beginResetModel();
    m_rows.clear();
    m_criterion = comparison.criterion;
    for (const ComparedModel& model : comparison.ranked)
        m_rows.push_back({model.id, model.words.describe(), model.delta, model.weight, model.change,
                          model.estimate.fit.simulationPercent});
    endResetModel();
}

QString ComparisonTableModel::text(const Row& row, Column column) const
{
    switch (column) {
    case Column::Model:
        return modelName(row.id);
    case Column::Delta:
        return row.delta > 0 ? u"+%L1"_s.arg(row.delta, 0, 'f', row.delta < 10 ? 1 : 0) : tr("best");
    case Column::Weight:
        return formatPercent(100 * row.weight, 0);
    case Column::Change:
        return row.change > 999 ? u"> 999"_s : Words::number(row.change, 'f', row.change < 10 ? 1 : 0);
    case Column::SimulationFit:
        return row.simulationPercent ? formatNumber(*row.simulationPercent, std::nullopt, {}, 3).value
                                     : QString(QChar(0x2013));
    }
    return {};
}

QVariant ComparisonTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= int(m_rows.size()))
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    const auto column = Column(index.column());
    if (role == Qt::DisplayRole)
        return text(row, column);
    if (role == Qt::ToolTipRole)
        return row.words;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (column == Column::Model ? Qt::AlignLeft : Qt::AlignRight)));
    return {};
}

QVariant ComparisonTableModel::head(int section, int role) const
{
    const auto column = Column(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (column == Column::Model ? Qt::AlignLeft : Qt::AlignRight)));
    if (role == Qt::ToolTipRole && column == Column::Delta)
        return tr(
            "How much worse the information criterion is than the best model's; below 10 decides nothing");
    if (role == Qt::ToolTipRole && column == Column::Change)
        return tr("Largest change of m, b or k from the linear model's, in its standard errors");
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case Column::Model:
        return tr("Model");
    case Column::Delta:
        return m_criterion.isEmpty() ? tr("criterion") : m_criterion;
    case Column::Weight:
        return tr("weight");
    case Column::Change:
        return tr("change\nsd");
    case Column::SimulationFit:
        return tr("sim.\n%");
    }
    return {};
}

QString ComparisonTableModel::toTsv() const
{
    QString text = u"model\t%1 above the best\tweight\tchange (standard errors)\tsimulation fit (%)\n"_s.arg(
        m_criterion);
    for (const Row& row : m_rows)
        text += QStringList{row.id, exactText(row.delta), exactText(row.weight), exactText(row.change),
                            exactText(row.simulationPercent)}
                    .join(u'\t') +
                u'\n';
    return text;
}

QString modelName(const QString& id)
{
    static const QHash<QString, const char*> names{
        {u"linear"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "Linear")},
        {u"cubic_spring"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "Cubic spring")},
        {u"without_offset"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "Without offset")},
        {u"with_offset"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "With offset")},
        {u"delay"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "With a delay")},
        {u"other_hold"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "Other force hold")},
        {u"smooth_force"_s, QT_TRANSLATE_NOOP("gripscope::ComparisonTableModel", "Smooth force")},
    };
    const char* name = names.value(id, nullptr);
    return name ? QCoreApplication::translate("gripscope::ComparisonTableModel", name) : id;
}

} // namespace gripscope
