// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace gripscope {

/// A few words as large as their place allows, to be read from afar.
class FittedLabel : public QLabel {
    Q_OBJECT
public:
    explicit FittedLabel(int height, QWidget* parent = nullptr);
    [[nodiscard]] int fontPixels() const; ///< as it is painted now
    [[nodiscard]] QSize sizeHint() const override { return {least, height()}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {least, height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    static constexpr int least = 80;
};

} // namespace gripscope
