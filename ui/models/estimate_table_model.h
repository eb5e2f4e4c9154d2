// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/result/determined_parameters.h"
#include "ui/models/row_table_model.h"

#include <QStringList>
#include <QStyledItemDelegate>

#include <array>

namespace gripscope {

/// The estimators of one identification against each other. Numbers are raw, in the units of the header (SI
/// with a prefix where the channels allow it); EstimateDelegate words them.
class EstimateTableModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Estimator, Mass, Damping, Stiffness, SimulationFit, PredictionFit, Verdict };
    static constexpr int columns = 7;
    enum Role {
        SortRole = Qt::UserRole, ///< the raw number
        HalfWidthRole,           ///< half the 95 % interval, same unit; invalid when there is none
        /// What the estimator has besides m, b and k, each "k3 = 3.80 ± 0.05 N/mm³"; invalid where there is
        /// nothing.
        FurtherRole,
    };

    using RowTableModel::RowTableModel;

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);
    void clear();
    [[nodiscard]] std::optional<Estimator> estimatorAt(int row) const;
    [[nodiscard]] int rowOf(Estimator estimator) const; ///< -1: not there
    /// Header, units and full precision, for a spreadsheet: SI where the channels allow it.
    [[nodiscard]] QString toTsv() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int section, int role) const override;

    struct Row {
        Estimator estimator = Estimator::OutputError;
        QString verdict;
        std::array<std::optional<double>, 3> parameters, halfWidths; ///< SI where the channels allow it
        std::vector<DeterminedParameter> further;
        Fit fit;
    };
    [[nodiscard]] QVariant number(const Row& row, Column column) const;
    [[nodiscard]] std::vector<DeterminedParameter> furtherColumns() const;

    std::vector<Row> m_rows;
    std::array<QString, 3> m_units, m_shownUnits;
    Eigen::Vector3d m_factors = Eigen::Vector3d::Ones(); ///< from m_units to m_shownUnits
};

/// Two lines a row of EstimateTableModel: name over verdict, value over the half width of its 95 % interval,
/// simulation fit over prediction fit; below them a line for each that an estimator has besides m, b and k.
/// Verdicts and those break where the column is too narrow: a number that is cut looks like another one.
class EstimateDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    struct Lines {
        QString first;
        QStringList small; ///< below the first, one at the least
    };
    [[nodiscard]] static Lines linesOf(const QModelIndex& index);
    [[nodiscard]] static QStringList brokenTo(int width, const QStringList& lines);
};

} // namespace gripscope
