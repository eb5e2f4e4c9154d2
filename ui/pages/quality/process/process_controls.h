// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_session.h"

#include <QWidget>

class QComboBox;
class QDateEdit;
class QPushButton;
class QSpinBox;

namespace gripscope {

/// What is charted, and how: type, chart, quantity, rules; and folded away what the inspections are narrowed
/// by.
class ProcessControls : public QWidget {
    Q_OBJECT
public:
    explicit ProcessControls(QWidget* parent = nullptr);

    [[nodiscard]] ProcessQuery query() const;
    [[nodiscard]] ProcessFilter filter() const;
    /// Chart, rules and subgroups; limits are put in by others.
    [[nodiscard]] ProcessOptions options() const;
    [[nodiscard]] std::size_t quantity() const; ///< ProcessNames::allQuantities: all three
    [[nodiscard]] bool hasType() const;

    /// The one chosen stays; else the first is.
    void setTypes(const QStringList& types);
    void setGrippers(const QStringList& grippers);
    void setChoices(const ProcessValues& values); ///< stations, operators and batches of what was read
    void focusType();

signals:
    void queryChanged();
    void filterChanged();
    void optionsChanged();
    void quantityChanged();

private:
    [[nodiscard]] QWidget* makeFirst();
    [[nodiscard]] QWidget* makeSecond();
    void connectAll();
    void refresh();

    QComboBox *m_type, *m_kind, *m_quantity, *m_rules;
    QSpinBox* m_size;
    QPushButton* m_more;
    QWidget* m_second;
    QComboBox *m_station, *m_gripper, *m_operator, *m_batch, *m_period;
    QDateEdit *m_from, *m_to;
};

} // namespace gripscope
