// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/context/navigator.h"

#include <QStringList>
#include <QWidget>

#include <cstddef>
#include <vector>

class QLabel;
class QToolButton;

namespace gripscope {

class RecordingOpener;
class Workbench;

/// The recordings that a person opened together, one of them in view: two arrows with "2 of 5" between them
/// (Alt and an arrow up or down). Reads file after file; who listens identifies each and hands it back by
/// add() or skip(), which reads the next. Hidden with fewer than two, or when another squeeze is in view.
class OpenedRecordings : public QWidget {
    Q_OBJECT
public:
    OpenedRecordings(Workbench& workbench, QWidget* page);

    void choose(); ///< files, by a dialog
    /// In place of those that were opened before. Of tables of other programs the first of each layout is
    /// asked about.
    void open(const QStringList& files);
    void cancel();                ///< those that are not read yet
    void add(FitSubject subject); ///< the last that was opened, identified
    void skip();                  ///< it was not identified after all
    void follow(const FitSubject& shown);
    [[nodiscard]] bool isReading() const { return m_reading; }

signals:
    void stateChanged(const QString& words); ///< empty: nothing is being read
    void opened(const QString& name, const gripscope::Recording& recording);
    void chosen(const gripscope::FitSubject& subject); ///< to be shown

private:
    [[nodiscard]] QToolButton* addArrow(const QString& icon, const QString& words, int by);
    void readNext();
    void go(int by);
    void refresh();

    RecordingOpener* m_opener;
    QWidget* m_page;
    QToolButton *m_previous, *m_next;
    QLabel* m_place;
    QStringList m_waiting;
    qsizetype m_all = 0; ///< opened together
    bool m_reading = false;
    std::vector<FitSubject> m_subjects;
    std::size_t m_at = 0;
};

} // namespace gripscope
