// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/validation.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QMenu;

namespace gripscope {

class TimePlot;

/// The model on data it was not found from: a sentence, measured against model, the numbers, and a button to
/// choose another squeeze.
class ValidationPanel : public QWidget {
    Q_OBJECT
public:
    explicit ValidationPanel(QWidget* parent = nullptr);

    void setValidation(const Validation& validation, const QString& positionUnit);
    [[nodiscard]] TimePlot* plot() const { return m_plot; }
    /// Of the button; whoever has squeezes to offer fills it.
    [[nodiscard]] QMenu* choices() const { return m_choices; }

private:
    QLabel* m_sentence;
    TimePlot* m_plot;
    QGridLayout* m_facts;
    QMenu* m_choices;
};

} // namespace gripscope
