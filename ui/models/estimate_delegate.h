// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QStyledItemDelegate>

namespace gripscope {

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
