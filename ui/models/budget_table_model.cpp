// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/budget_table_model.h"

#include "core/base/csv.h"
#include "core/signal/recording/units.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>
#include <QHash>
#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

void BudgetTableModel::setBudget(const UncertaintyBudget& budget, const QString& forceUnit,
                                 const QString& positionUnit)
{
    beginResetModel();
    m_rows.clear();
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    const double factor = si.value_or(1);
    const ParameterUnits units = comparableUnits(forceUnit, positionUnit);
    m_units = {units.m, units.b, units.k};
    for (const BudgetLine& line : budget.lines) {
        Row row{line.id, effectName(line.id), line.words.describe(), false, {}, {}};
        const Eigen::Vector3d uncertainties = line.standardUncertainties() * factor;
        for (int i = 0; i < 3; ++i) {
            row.uncertainties[std::size_t(i)] = uncertainties[i];
            row.shares[std::size_t(i)] = line.share[i];
        }
        m_rows.push_back(std::move(row));
    }
    if (budget.parameters) {
        Row combined{u"combined"_s, tr("Combined"), tr("standard uncertainty"), true, {}, {}};
        const QString coverage = QString::number(std::lround(100 * budget.coverage));
        Row expanded{
            u"expanded"_s, tr("Expanded"), tr("half of the %1 % interval").arg(coverage), true, {}, {}};
        const Eigen::Vector3d values = budget.parameters->vector() * factor;
        for (std::size_t i = 0; i < 3; ++i) {
            combined.uncertainties[i] = budget.combined[i].standardUncertainty * factor;
            expanded.uncertainties[i] = (budget.intervals[i].upper - budget.intervals[i].lower) / 2 * factor;
            const ShownUnit shown = shownUnit(m_units[i], std::abs(values[Eigen::Index(i)]));
            m_shownUnits[i] = shown.unit;
            m_factors[i] = shown.factor;
        }
        m_rows.push_back(std::move(combined));
        m_rows.push_back(std::move(expanded));
    }
    endResetModel();
}

void BudgetTableModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

QVariant BudgetTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= int(m_rows.size()))
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    if (role == WordsRole)
        return row.words;
    if (role == SumRole)
        return row.sum;
    if (role == Qt::ToolTipRole)
        return row.words;
    if (Column(index.column()) == Column::Effect)
        return role == Qt::DisplayRole ? QVariant(row.name) : QVariant();
    const auto at = std::size_t(index.column() - int(Column::Mass));
    if (role == ShareRole)
        return row.sum ? QVariant() : QVariant(row.shares[at]);
    if (role == Qt::DisplayRole || role == SortRole)
        return row.uncertainties[at] * m_factors[at];
    return {};
}

QVariant BudgetTableModel::head(int column, int role) const
{
    const bool effect = Column(column) == Column::Effect;
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (effect ? Qt::AlignLeft : Qt::AlignRight)));
    if (role == Qt::ToolTipRole && !effect)
        return tr("Standard uncertainty; the bar is the effect's share of the variance");
    if (role != Qt::DisplayRole)
        return {};
    if (effect)
        return tr("Effect");
    const auto at = std::size_t(column - int(Column::Mass));
    const QString name = u"u(%1)"_s.arg(u"mbk"_s[qsizetype(at)]);
    return m_shownUnits[at].isEmpty() ? name : name + u'\n' + m_shownUnits[at];
}

QString BudgetTableModel::toTsv() const
{
    const QString names = u"mbk"_s;
    QStringList header{u"effect"_s};
    for (std::size_t i = 0; i < 3; ++i)
        header << u"u(%1)"_s.arg(names[qsizetype(i)]) +
                      (m_units[i] == u"1" ? QString() : u" (%1)"_s.arg(m_units[i]));
    for (const QChar name : names)
        header << u"share of the variance of %1"_s.arg(name);
    QString text = header.join(u'\t') + u'\n';
    for (const Row& row : m_rows) {
        QStringList cells{row.id};
        for (const double value : row.uncertainties)
            cells << exactText(value);
        for (const double value : row.shares)
            cells << (row.sum ? QString() : exactText(value));
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

QString effectName(const QString& id)
{
    static const QHash<QString, const char*> names{
        {u"noise"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Noise")},
        {u"position_noise"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Position noise")},
        {u"force_noise"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Force noise")},
        {u"quantization"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Steps of the position")},
        {u"lag"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Lag of the channels")},
        {u"hold"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Force between samples")},
        {u"friction"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Friction")},
        {u"jitter"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Times of the samples")},
        {u"calibration"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Calibration")},
        {u"frame_compliance"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Give of the frame")},
        {u"baseline"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Empty gripper")},
        {u"model_discrepancy"_s, QT_TRANSLATE_NOOP("gripscope::BudgetTableModel", "Model")},
    };
    const char* name = names.value(id, nullptr);
    return name ? QCoreApplication::translate("gripscope::BudgetTableModel", name) : id;
}

namespace {

using BudgetColumn = BudgetTableModel::Column;

constexpr int side = 5, barHeight = 4, leastBar = 44;

bool isEffect(const QModelIndex& index)
{
    return BudgetColumn(index.column()) == BudgetColumn::Effect;
}

QString textOf(const QModelIndex& index)
{
    if (isEffect(index))
        return index.data().toString();
    const double value = index.data(BudgetTableModel::SortRole).toDouble();
    return value > 0 ? formatNumber(value, std::nullopt, {}, 2).value : QString(QChar(0x2013));
}

} // namespace

QSize BudgetDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    const bool sum = index.data(BudgetTableModel::SumRole).toBool();
    const QFontMetrics font(Theme::font(metrics::fontBase, sum));
    const int text = font.horizontalAdvance(textOf(index));
    return {(isEffect(index) ? text : std::max(text, leastBar)) + 2 * side,
            font.height() + (sum ? 6 : 10 + barHeight)};
}

void BudgetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const bool sum = index.data(BudgetTableModel::SumRole).toBool();
    painter->save();
    Theme::paintRow(*painter, option.rect, option.state & QStyle::State_Selected);
    const QRect box = option.rect.adjusted(side, 3, -side, -3);
    const QFont font = Theme::font(metrics::fontBase, sum);
    const QFontMetrics measures(font);
    painter->setFont(font);
    painter->setPen(tokens.text);
    painter->drawText(QRect(box.left(), box.top(), box.width(), measures.height()),
                      int(Qt::AlignVCenter | (isEffect(index) ? Qt::AlignLeft : Qt::AlignRight)),
                      elided(measures, textOf(index), box.width()));
    if (const QVariant share = index.data(BudgetTableModel::ShareRole); share.isValid()) {
        const QRectF groove(box.right() + 1 - leastBar, box.bottom() - barHeight + 1, leastBar, barHeight);
        painter->setPen(Qt::NoPen);
        painter->setBrush(Theme::mix(tokens.surface, tokens.line, 0.8));
        painter->drawRect(groove);
        painter->setBrush(tokens.accent);
        const double part = std::clamp(share.toDouble(), 0.0, 1.0) * groove.width();
        painter->drawRect(QRectF(groove.left(), groove.top(), part, groove.height()));
    }
    painter->restore();
}

} // namespace gripscope
