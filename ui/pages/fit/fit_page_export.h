// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "ui/charts/plot_export.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QMenu;
class QWidget;

namespace gripscope {

class PlotStack;
class Workbench;

enum class PlotFormat { Png, Svg, Csv };

/// Takes the plots and numbers of a page off the screen: menus, file dialogs, writing. Pictures are painted
/// on the screen's thread, as they must be; everything that grows with the recording, and the disk, is the
/// pool's. Errors go to the message bar, and what was done where a page has no line of its own for it.
class FitExporter : public QObject {
    Q_OBJECT
public:
    FitExporter(Workbench& workbench, QWidget* page);

    /// Gives the plot a context menu (right button, Menu key, Shift+F10).
    template <typename Plot>
    void add(Plot* plot)
    {
        addPlot(plot, plot);
    }
    /// The same with the width of pictures in its menu: where no button offers that.
    template <typename Plot>
    void addFigure(Plot* plot)
    {
        addPlot(plot, plot);
        m_entries.back().widths = true;
    }
    /// A figure of several plots: the menu comes up over each of them, too.
    void addStack(PlotStack* stack);
    /// What files are called after: the squeeze's name.
    void setSubject(const QString& title) { m_subject = title; }
    /// All numbers as one JSON document; asked for when they are saved.
    void setNumbers(std::function<QByteArray()> numbers) { m_numbers = std::move(numbers); }

    /// How wide pictures that are saved from now on are.
    void setFigureWidth(FigureWidth width) { m_width = width; }

    /// The entries of the page's Export button.
    void fill(QMenu* menu);
    void fillForPlot(QMenu* menu, ExportablePlot* plot);
    /// Of a button for one figure alone: with the width of its pictures.
    void fillFigure(QMenu* menu, ExportablePlot* plot);

    static void copyPicture(ExportablePlot* plot);
    void savePlot(ExportablePlot* plot, PlotFormat format, const QString& file);
    void saveNumbers(const QString& file);
    /// Every plot in every format and the numbers, each in a file of its own in `folder`.
    void saveAll(const QString& folder);
    [[nodiscard]] int pending() const { return m_pending; } ///< savings that are still under way

signals:
    /// "saved residuals.svg". Where nobody listens, the message bar tells what was done.
    void told(const QString& words);

private:
    void tell(const QString& words, const QString& message);
    void addPlot(QWidget* widget, ExportablePlot* plot, bool part = false);
    void popUp(QWidget* widget, ExportablePlot* plot, QPoint at);
    void askForFile(const QString& name, const QString& suffix, const QString& filter,
                    std::function<void(QString)> then);
    void askForFolder();
    [[nodiscard]] QString baseName(const QString& what) const;
    struct Job {
        QString file;
        std::function<QByteArray()> make; ///< run in the pool
    };
    [[nodiscard]] Job jobFor(ExportablePlot* plot, PlotFormat format, const QString& file) const;
    void fillWidths(QMenu* menu);
    void write(std::vector<Job> jobs);
    bool eventFilter(QObject* object, QEvent* event) override;

    struct Entry {
        QWidget* widget = nullptr;
        ExportablePlot* plot = nullptr;
        bool part = false;   ///< of another entry's plot, which is saved with that
        bool widths = false; ///< are chosen in its own menu
    };
    Workbench* m_workbench;
    QWidget* m_page;
    QString m_subject;
    FigureWidth m_width = FigureWidth::Screen;
    std::function<QByteArray()> m_numbers;
    std::vector<Entry> m_entries;
    int m_pending = 0;
};

/// Every number of an identification that belongs to no plot, for a spreadsheet: tab-separated blocks with a
/// header line each and an empty line between them; full precision, units in the headers. First the
/// estimators (as EstimateTableModel::toTsv()), then, of the recommended one, what follows from m, b and k,
/// the correlation matrix, the residual tests, the uncertainty budget and the other models; last the checks
/// on the measurement.
[[nodiscard]] QString fitNumbers(const Identification& identification, const QString& forceUnit,
                                 const QString& positionUnit);

} // namespace gripscope
