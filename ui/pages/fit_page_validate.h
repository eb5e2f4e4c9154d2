// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/identification/validation.h"
#include "core/signal/recording.h"

#include <QObject>

#include <optional>

class QMenu;
class QWidget;

namespace gripscope {

class Workbench;
struct FitSubject;

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
    std::optional<Estimate> m_estimate;
    Recording m_recording;
    int m_generation = 0;
};

} // namespace gripscope
