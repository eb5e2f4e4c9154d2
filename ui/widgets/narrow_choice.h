// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace gripscope {

/// A choice in less room than its entries need: what is chosen ends in an ellipsis then, with the whole as
/// tool tip, and the list that opens is as wide as it needs.
class NarrowChoice : public QComboBox {
    Q_OBJECT
public:
    explicit NarrowChoice(int leastLetters, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString shownText(const QStyleOptionComboBox& option) const;
};

} // namespace gripscope
