// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/signal/recording/recording.h"

#include <QObject>
#include <QString>

#include <optional>

namespace gripscope {

/// A squeeze with what was found in it: what the Fit page shows.
struct FitSubject {
    QString title; ///< "Inspection 12", "A, squeeze 3"
    Recording recording;
    Identification identification;
    QString backTo = {}; ///< id of the page it was chosen on; empty: it came by itself
};

/// The way from one page to another, and what it takes along.
class Navigator : public QObject {
    Q_OBJECT
public:
    /// Brings another page into view, by its id.
    void showPage(const QString& id) { emit pageRequested(id); }
    /// What can be done to the enrolled types, over the page in view.
    void manageTypes() { emit typesAsked(); }
    /// Another library, or this one anew, in place of the one that is open; `words` tell it then.
    void openLibrary(const QString& file, const QString& words) { emit libraryAsked(file, words); }
    /// Puts a squeeze on the Fit page and shows that page.
    void showInFit(FitSubject subject);
    /// Puts a squeeze on the Fit page without leaving this one.
    void setFitSubject(FitSubject subject);
    [[nodiscard]] const std::optional<FitSubject>& fitSubject() const { return m_fitSubject; }

signals:
    void pageRequested(const QString& id);
    void typesAsked();
    void libraryAsked(const QString& file, const QString& words);
    void fitSubjectChanged(); ///< a new one; the page need not be in view

private:
    std::optional<FitSubject> m_fitSubject;
};

} // namespace gripscope
