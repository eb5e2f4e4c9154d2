// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QWidget>

#include <optional>

namespace gripscope {

/// The verdict as it is read from 3 m: a sign, a headline of up to 72 px, and the outcome in words. The
/// headline shrinks to its room, but not below 44 px: then it takes two lines, and only what no two lines of
/// 28 px hold is cut with an ellipsis.
class VerdictPanel : public QWidget {
    Q_OBJECT
public:
    explicit VerdictPanel(QWidget* parent = nullptr);
    void showOutcome(InspectionOutcome outcome, const QString& headline, const QString& words);
    /// No verdict yet: what to do instead.
    void showHint(const QString& headline, const QString& words);
    /// A thin bar along the bottom while a squeeze runs; negative: none.
    void setProgress(double share);
    [[nodiscard]] std::optional<InspectionOutcome> outcome() const { return m_outcome; }
    [[nodiscard]] QString headline() const { return m_headline; }
    /// The headline as it is painted in this room: its lines and their size.
    struct Headline {
        QStringList lines;
        int pixels = 0;
    };
    [[nodiscard]] Headline fitted(double room, double tall) const;
    [[nodiscard]] QSize sizeHint() const override { return {560, 152}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 92}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintWords(class QPainter& painter, double left, const QColor& color) const;
    void setWords(const QString& headline, const QString& words);
    std::optional<InspectionOutcome> m_outcome;
    QString m_headline, m_words;
    double m_progress = -1;
};

} // namespace gripscope
