// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "ui/models/fact.h"

#include <QFrame>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace gripscope {

/// All that is known of the squeeze that is chosen.
class HistoryDetails : public QFrame {
    Q_OBJECT
public:
    explicit HistoryDetails(QWidget* parent = nullptr);

    void show(const SqueezeDetails& details);
    void clear();

private:
    void addHeading(QVBoxLayout* column, const QString& text);
    void addFacts(QVBoxLayout* column, const std::vector<Fact>& facts);
    void addOutcome(QVBoxLayout* column, const HistoryEntry& entry);
    void addEstimates(QVBoxLayout* column, const SqueezeDetails& details);
    void addBudget(QVBoxLayout* column, const SqueezeDetails& details);

    QScrollArea* m_scroll;
};

} // namespace gripscope
