// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QWidget>

#include <deque>

namespace gripscope {

/// The last fifty outcomes as one bar each, newest on the right: height and sign tell them apart as well as
/// colour.
class YieldStrip : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t length = 50;
    explicit YieldStrip(QWidget* parent = nullptr);
    void setOutcomes(std::deque<InspectionOutcome> outcomes); ///< oldest first; the last fifty are shown
    [[nodiscard]] QSize sizeHint() const override { return {260, 48}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::deque<InspectionOutcome> m_outcomes;
};

} // namespace gripscope
