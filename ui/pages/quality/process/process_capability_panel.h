// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/quality/conformity/part_limits.h"
#include "core/session/process/process_session.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QLineEdit;
class QTabBar;

namespace gripscope {

class HistogramPlot;

/// Beside the charts: the quantity that is chosen against its tolerance limits, which are the type's own
/// until others are typed; indices with their intervals, what they are worth, and the histogram.
class ProcessCapabilityPanel : public QWidget {
    Q_OBJECT
public:
    explicit ProcessCapabilityPanel(QWidget* parent = nullptr);

    /// Those of the type, as it keeps them, times `factor` in the units of the values.
    void setOwnLimits(const PartLimits& limits, double factor);
    /// In force: what was typed, else the type's own.
    [[nodiscard]] std::array<std::optional<ToleranceLimits>, 3> limits() const;
    void show(std::shared_ptr<const ProcessPicture> picture);
    void choose(std::size_t quantity);
    [[nodiscard]] std::size_t quantity() const;

signals:
    void limitsChanged();

private:
    [[nodiscard]] QWidget* makeLimits();
    void refresh();
    void fillFields();
    void fillNumbers(const ProcessCapability& capability);
    void takeTyped();
    [[nodiscard]] ShownUnit unit() const;

    std::shared_ptr<const ProcessPicture> m_picture;
    std::array<std::optional<ToleranceLimits>, 3> m_own, m_typed;
    std::array<bool, 3> m_isTyped{};
    QTabBar* m_tabs;
    HistogramPlot* m_histogram;
    QLineEdit *m_lower, *m_upper;
    QLabel *m_lowerUnit, *m_upperUnit, *m_source, *m_problem, *m_words;
    QGridLayout* m_numbers;
    QWidget* m_numbersBox;
};

} // namespace gripscope
