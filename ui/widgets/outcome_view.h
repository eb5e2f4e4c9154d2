// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/inspection_outcome.h"
#include "core/session/inspect/inspect_session.h"

#include <QBrush>
#include <QColor>
#include <QFont>
#include <QRectF>
#include <QStringList>
#include <QWidget>

#include <optional>

class QPainter;

namespace gripscope {

/// The sign of an outcome in one colour: check, crossed arrows, question mark, ellipsis, warning triangle.
/// Five shapes that are told apart without colour.
void paintOutcomeSign(QPainter& painter, const QRectF& box, InspectionOutcome outcome, const QColor& color);

/// The same on a filled diamond where the measurement is in doubt, as a road sign that warns.
void paintJudgedSign(QPainter& painter, const QRectF& box, InspectionOutcome outcome, bool suspect);

/// The fill behind an outcome: a tint, or a pattern of its own where the theme has no tints.
[[nodiscard]] QBrush outcomeFill(InspectionOutcome outcome);
/// The stripes over the fill of a verdict on a suspect measurement, in every theme.
[[nodiscard]] QBrush suspectStripes();

/// The verdict as it is read from 3 m: a sign, a headline as large as the field allows, and the outcome in
/// words, on the outcome's own colour. The headline shrinks to its room, but not below 44 px: then it takes
/// two lines, and only what no two lines of 28 px hold is cut with an ellipsis.
class VerdictPanel : public QWidget {
    Q_OBJECT
public:
    explicit VerdictPanel(QWidget* parent = nullptr);
    /// `suspect`: the measurement is in doubt. Colour, stripes, sign and frame are then another, and the
    /// words are larger: what a clean verdict looks like is kept for clean ones.
    void showOutcome(InspectionOutcome outcome, const QString& headline, const QString& words,
                     bool suspect = false);
    /// No verdict yet: what to do instead.
    void showHint(const QString& headline, const QString& words);
    /// What the gripper is about to do by itself: as large as a verdict, on the accent.
    void showAlert(const QString& headline, const QString& words);
    /// A thin bar along the bottom while a squeeze runs; negative: none.
    void setProgress(double share);
    [[nodiscard]] std::optional<InspectionOutcome> outcome() const { return m_outcome; }
    [[nodiscard]] bool suspect() const { return m_outcome && m_suspect; }
    [[nodiscard]] QString headline() const { return m_headline; }
    [[nodiscard]] bool alerts() const { return m_alert; }
    /// What is behind a verdict, and the ink on it: the outcome's colour in full. In doubt, and where a theme
    /// tells outcomes apart by patterns, the plain field with the outcome's colour as ink.
    [[nodiscard]] bool filled() const;
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
    [[nodiscard]] QFont wordsFont(double room) const; ///< a third of the headline's, where there is room
    struct Words {
        QStringList lines;
        QFont font;
    };
    /// What stands below the headline: one line where it is read from afar, else as many as it takes and
    /// there is height for.
    [[nodiscard]] Words fittedWords(double room, double tall) const;
    [[nodiscard]] double signSize() const;
    [[nodiscard]] bool readFromAfar() const { return m_outcome || m_alert; }
    void paintWords(class QPainter& painter, double left, const QColor& color) const;
    void setWords(const QString& headline, const QString& words);
    std::optional<InspectionOutcome> m_outcome;
    bool m_suspect = false, m_alert = false;
    QString m_headline, m_words;
    double m_progress = -1;
};

} // namespace gripscope
