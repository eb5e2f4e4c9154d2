// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/validation/validation.h"
#include "core/signal/recording/recording.h"

#include <QObject>
#include <QWidget>

#include <optional>

class QGridLayout;
class QLabel;
class QMenu;

namespace gripscope {

struct FitSubject;
class RecordingOpener;
class TimePlot;
class Workbench;

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

/// Offers squeezes to hold the Fit page's estimate against: a recording (CSV) or a stored squeeze of any type
/// in the library; fetches the one chosen and validates in the pool. Errors go to the message bar.
class ValidationChooser : public QObject {
    Q_OBJECT
public:
    /// Fills `menu`, anew whenever it opens.
    ValidationChooser(Workbench& workbench, QMenu* menu, QWidget* page);

    /// What is to be validated; an answer for an older one is dropped.
    void setSubject(const std::optional<FitSubject>& subject);
    void useFile(const QString& file);
    void useStored(const QString& graspId, const QString& name);

signals:
    void started();
    void validated(const gripscope::Validation& validation);
    void failed();

private:
    void fillMenu();
    void addStored();
    void chooseFile();
    void hold(Expected<Recording> other, const QString& name, int generation);

    Workbench* m_workbench;
    QMenu* m_menu;
    QWidget* m_page;
    RecordingOpener* m_opener;
    std::optional<Estimate> m_estimate;
    Recording m_recording;
    int m_generation = 0;
};

} // namespace gripscope
