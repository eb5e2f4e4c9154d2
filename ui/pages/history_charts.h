// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/type_model.h"
#include "core/store/history.h"

#include <QWidget>

#include <memory>

class QPushButton;

namespace gripscope {

class TrendView;

/// m, b and k of the squeezes that the filters let through, over time or one after another, with the types'
/// signs named above.
class HistoryCharts : public QWidget {
    Q_OBJECT
public:
    explicit HistoryCharts(QWidget* parent = nullptr);

    void setPoints(std::shared_ptr<const HistoryPoints> points, const TypeModels& models);
    void select(const QString& key);
    [[nodiscard]] TrendView* view() const { return m_view; }

signals:
    void chosen(const QString& key);

private:
    class Legend;
    void refresh();

    std::shared_ptr<const HistoryPoints> m_points;
    TypeModels m_models;
    TrendView* m_view;
    Legend* m_legend;
    QPushButton *m_byTime, *m_byPlace;
};

} // namespace gripscope
