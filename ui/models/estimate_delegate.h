// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace gripscope {

/// Two lines a row of EstimateTableModel: name over verdict, value over the half width of its 95 % interval,
/// simulation fit over prediction fit; a third one for the cubic spring of an estimator that has one.
class EstimateDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    struct Lines {
        QString first, second, third;
    };
    [[nodiscard]] static Lines linesOf(const QModelIndex& index);
};

} // namespace gripscope
