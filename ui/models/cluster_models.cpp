// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/cluster_models.h"

#include "ui/format/number_format.h"
#include "ui/theme/theme.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

void ClusterTableModel::setTable(const QStringList& types, const std::vector<std::vector<int>>& rows)
{
    beginResetModel();
    m_types = types;
    m_rows = rows;
    endResetModel();
}

int ClusterTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int ClusterTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_types.size());
}

QVariant ClusterTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != SortRole)
        return {};
    const std::vector<int>& row = m_rows[std::size_t(index.row())];
    const auto column = std::size_t(index.column());
    return column < row.size() && row[column] > 0 ? QVariant(row[column]) : QVariant();
}

QVariant ClusterTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    if ((role != Qt::DisplayRole && role != Qt::ToolTipRole) || section < 0)
        return {};
    if (orientation == Qt::Horizontal)
        return section < m_types.size() ? QVariant(m_types[section]) : QVariant();
    return section + 1;
}

void ClusterCountsModel::setAgreement(const ClusterAgreement& agreement)
{
    beginResetModel();
    m_agreement = agreement;
    endResetModel();
}

int ClusterCountsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_agreement.counts.rows());
}

int ClusterCountsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_agreement.counts.cols());
}

QVariant ClusterCountsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int count = m_agreement.counts(index.row(), index.column());
    switch (role) {
    case SortRole:
        return count;
    case Qt::DisplayRole: // an empty cell shows the pattern better than a nought
        return count > 0 ? QVariant(formatCount(count)) : QVariant();
    case Qt::TextAlignmentRole:
        return int(Qt::AlignCenter);
    default:
        return {};
    }
}

QVariant ClusterCountsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (section < 0 || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    if (orientation == Qt::Vertical)
        return section < m_agreement.truths.size() ? QVariant(m_agreement.truths[section]) : QVariant();
    return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant(tr("Cluster %1").arg(section + 1));
}

namespace {

constexpr QChar adviceDash(0x2013);

/// A true minus sign instead of a hyphen.
QString withMinus(QString number)
{
    return number.replace(u'-', QChar(0x2212));
}

/// The column a criterion has.
AdviceTableModel::Column columnOf(ClusterCriterion criterion)
{
    switch (criterion) {
    case ClusterCriterion::Silhouette:
        return AdviceTableModel::Column::Silhouette;
    case ClusterCriterion::CalinskiHarabasz:
        return AdviceTableModel::Column::CalinskiHarabasz;
    case ClusterCriterion::DaviesBouldin:
        return AdviceTableModel::Column::DaviesBouldin;
    case ClusterCriterion::Gap:
        return AdviceTableModel::Column::Gap;
    case ClusterCriterion::Bic:
        return AdviceTableModel::Column::Bic;
    }
    return AdviceTableModel::Column::Clusters;
}

} // namespace

void AdviceTableModel::setAdvice(const ClusterAdvice& advice)
{
    beginResetModel();
    m_advice = advice;
    endResetModel();
}

std::optional<double> AdviceTableModel::value(const ClusterFigures& figures, Column column) const
{
    switch (column) {
    case Column::Clusters:
        return figures.clusters;
    case Column::Silhouette:
        return figures.silhouette;
    case Column::CalinskiHarabasz:
        return figures.calinskiHarabasz;
    case Column::DaviesBouldin:
        return figures.daviesBouldin;
    case Column::Gap:
        return figures.gap ? std::optional(figures.gap->value) : std::nullopt;
    case Column::Bic:
        return std::min(figures.bicTied, figures.bicFull);
    }
    return {};
}

bool AdviceTableModel::best(const ClusterFigures& figures, Column column) const
{
    if (column == Column::Clusters)
        return figures.clusters == m_advice.clusters;
    return std::any_of(m_advice.votes.begin(), m_advice.votes.end(), [&](const ClusterVote& vote) {
        return columnOf(vote.criterion) == column && vote.clusters == figures.clusters;
    });
}

QString AdviceTableModel::text(const ClusterFigures& figures, Column column) const
{
    const std::optional<double> number = value(figures, column);
    if (!number || !std::isfinite(*number))
        return adviceDash;
    const QLocale locale;
    switch (column) {
    case Column::Clusters:
        return locale.toString(figures.clusters);
    case Column::CalinskiHarabasz:
    case Column::Bic:
        return withMinus(locale.toString(*number, 'f', std::abs(*number) < 10 ? 1 : 0));
    default:
        return withMinus(locale.toString(*number, 'f', 2));
    }
}

QVariant AdviceTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const ClusterFigures& figures = m_advice.figures[std::size_t(index.row())];
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(figures, column);
    case SortRole: {
        const std::optional<double> number = value(figures, column);
        return number ? QVariant(*number) : QVariant();
    }
    case BestRole:
        return best(figures, column);
    case Qt::FontRole:
        return Theme::font(metrics::fontSmall, best(figures, column));
    case Qt::TextAlignmentRole:
        return int(Qt::AlignCenter);
    case Qt::ToolTipRole:
        return best(figures, column) && column != Column::Clusters
                   ? QVariant(tr("The best by this criterion"))
                   : QVariant();
    default:
        return {};
    }
}

QVariant AdviceTableModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    struct Words {
        QString name, meaning;
    };
    const std::array<Words, columns> words{{
        {tr("K"), tr("Number of clusters")},
        {tr("Silh."), tr("Silhouette: how much nearer a squeeze is to its own cluster than to the next. "
                         "High is good.")},
        {tr("C-H"), tr("Calinski-Harabasz: variance between the clusters over that within. High is good.")},
        {tr("D-B"), tr("Davies-Bouldin: the worst overlap of each cluster with another, on average. Low is "
                       "good.")},
        {tr("Gap"), tr("Gap: how much tighter the clusters are than those of squeezes spread evenly. Its "
                       "best is the smallest within an error of the first maximum.")},
        {tr("BIC"), tr("Bayesian information criterion of Gaussian mixtures, the better of tied and full. "
                       "Low is good.")},
    }};
    const Words& one = words[std::size_t(column)];
    if (role == Qt::ToolTipRole)
        return one.meaning;
    return role == Qt::DisplayRole ? QVariant(one.name) : QVariant();
}

QString AdviceTableModel::toTsv() const
{
    QStringList lines;
    QStringList names;
    for (int section = 0; section < columns; ++section)
        names << headerData(section, Qt::Horizontal, Qt::DisplayRole).toString();
    lines << names.join(u'\t');
    for (const ClusterFigures& figures : m_advice.figures) {
        QStringList cells;
        for (int section = 0; section < columns; ++section) {
            const std::optional<double> number = value(figures, Column(section));
            cells << (number ? QString::number(*number, 'g', 12) : QString());
        }
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace gripscope
