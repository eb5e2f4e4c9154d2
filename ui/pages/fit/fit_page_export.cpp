// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_export.h"

#include "core/base/bounded_file.h"
#include "ui/charts/plot_frame.h"
#include "ui/charts/plot_stack.h"
#include "ui/context/workbench.h"
#include "ui/windows/file_dialog.h"

#include <QActionGroup>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMetaMethod>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The reason why it could not be written, or nothing.
QString writeFile(const QString& file, const QByteArray& bytes)
{
    const Expected<void> written = writeWhole(file, bytes);
    return written ? QString() : written.error().argument(1);
}

QString suffixOf(PlotFormat format)
{
    switch (format) {
    case PlotFormat::Png:
        return u"png"_s;
    case PlotFormat::Svg:
        return u"svg"_s;
    case PlotFormat::Csv:
        return u"csv"_s;
    }
    return {};
}

} // namespace

FitExporter::FitExporter(Workbench& workbench, QWidget* page)
    : QObject(page), m_workbench(&workbench), m_page(page)
{
}

void FitExporter::addStack(PlotStack* stack)
{
    addPlot(stack, stack);
    for (PlotFrame* plot : stack->plots())
        addPlot(plot, stack, true);
}

void FitExporter::addPlot(QWidget* widget, ExportablePlot* plot, bool part)
{
    m_entries.push_back({widget, plot, part});
    widget->setContextMenuPolicy(Qt::CustomContextMenu);
    widget->installEventFilter(this);
    connect(widget, &QWidget::customContextMenuRequested, this,
            [this, widget, plot](QPoint at) { popUp(widget, plot, at); });
}

bool FitExporter::eventFilter(QObject* object, QEvent* event)
{
    // Not every platform makes a context menu event of these keys.
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool asked = key->key() == Qt::Key_Menu ||
                           (key->key() == Qt::Key_F10 && key->modifiers() == Qt::ShiftModifier);
        for (const Entry& entry : m_entries)
            if (asked && entry.widget == object) {
                popUp(entry.widget, entry.plot, entry.widget->rect().center());
                return true;
            }
    }
    return QObject::eventFilter(object, event);
}

void FitExporter::popUp(QWidget* widget, ExportablePlot* plot, QPoint at)
{
    if (widget->findChild<QMenu*>(u"plotMenu"_s, Qt::FindDirectChildrenOnly))
        return; // the key's own event and the platform's are one wish
    auto* menu = new QMenu(widget);
    menu->setObjectName(u"plotMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool widths = std::any_of(m_entries.begin(), m_entries.end(), [widget](const Entry& entry) {
        return entry.widget == widget && entry.widths;
    });
    widths ? fillFigure(menu, plot) : fillForPlot(menu, plot);
    menu->popup(widget->mapToGlobal(at));
}

void FitExporter::fill(QMenu* menu)
{
    menu->addAction(tr("Everything into a folder…"), this, [this] { askForFolder(); });
    menu->addAction(tr("All numbers as JSON…"), this, [this] {
        askForFile(baseName(tr("numbers")), u"json"_s, tr("JSON (*.json)"),
                   [this](const QString& file) { saveNumbers(file); });
    });
    fillWidths(menu->addMenu(tr("Width of pictures")));
    menu->addSeparator();
    for (const Entry& entry : m_entries)
        if (!entry.part)
            fillForPlot(menu->addMenu(entry.plot->plotName()), entry.plot);
}

void FitExporter::fillWidths(QMenu* menu)
{
    auto* group = new QActionGroup(menu);
    const auto add = [&](const QString& words, FigureWidth width) {
        QAction* action = menu->addAction(words, this, [this, width] { setFigureWidth(width); });
        action->setCheckable(true);
        action->setChecked(width == m_width);
        group->addAction(action);
    };
    add(tr("As on the screen"), FigureWidth::Screen);
    add(tr("One journal column (85 mm)"), FigureWidth::OneColumn);
    add(tr("Two journal columns (175 mm)"), FigureWidth::TwoColumns);
}

void FitExporter::fillForPlot(QMenu* menu, ExportablePlot* plot)
{
    menu->addAction(tr("Copy picture"), this, [this, plot] {
        copyPicture(plot);
        tell(tr("picture copied"), tr("Picture copied"));
    });
    const auto save = [&](const QString& text, PlotFormat format, const QString& filter) {
        menu->addAction(text, this, [this, plot, format, filter] {
            askForFile(baseName(plot->fileName()), suffixOf(format), filter,
                       [this, plot, format](const QString& file) { savePlot(plot, format, file); });
        });
    };
    save(tr("Save picture as PNG…"), PlotFormat::Png, tr("PNG (*.png)"));
    save(tr("Save picture as SVG…"), PlotFormat::Svg, tr("SVG (*.svg)"));
    save(tr("Save data as CSV…"), PlotFormat::Csv, tr("CSV (*.csv)"));
}

void FitExporter::fillFigure(QMenu* menu, ExportablePlot* plot)
{
    fillForPlot(menu, plot);
    fillWidths(menu->addMenu(tr("Width of pictures")));
}

void FitExporter::copyPicture(ExportablePlot* plot)
{
    QGuiApplication::clipboard()->setImage(toImage(*plot));
}

FitExporter::Job FitExporter::jobFor(ExportablePlot* plot, PlotFormat format, const QString& file) const
{
    const FigureLayout layout(*plot, m_width);
    switch (format) {
    case PlotFormat::Png:
        return {file, [image = toImage(*plot, figureScale(m_width))] { return toPng(image); }};
    case PlotFormat::Svg:
        return {file, [svg = toSvg(*plot)] { return svg; }};
    case PlotFormat::Csv:
        return {file, [table = plot->numbers()] { return toCsv(table); }};
    }
    return {};
}

void FitExporter::savePlot(ExportablePlot* plot, PlotFormat format, const QString& file)
{
    write({jobFor(plot, format, file)});
}

void FitExporter::saveNumbers(const QString& file)
{
    write({{file, [json = m_numbers()] { return json; }}});
}

void FitExporter::saveAll(const QString& folder)
{
    const QDir to(folder);
    const auto path = [&](const QString& name, const QString& suffix) {
        return to.filePath(u"%1.%2"_s.arg(baseName(name), suffix));
    };
    std::vector<Job> jobs;
    for (const Entry& entry : m_entries) {
        if (entry.part)
            continue;
        for (const PlotFormat format : {PlotFormat::Png, PlotFormat::Svg, PlotFormat::Csv})
            jobs.push_back(jobFor(entry.plot, format, path(entry.plot->fileName(), suffixOf(format))));
    }
    jobs.push_back({path(u"numbers"_s, u"json"_s), [json = m_numbers()] { return json; }});
    write(std::move(jobs));
}

QString FitExporter::baseName(const QString& what) const
{
    QString name;
    for (const QChar letter : m_subject.endsWith(u".csv") ? m_subject.chopped(4) : m_subject)
        name += letter.isLetterOrNumber() || letter == u'.' || letter == u'_' ? letter : QChar(u'-');
    while (name.contains(u"--"_s))
        name.replace(u"--"_s, u"-"_s);
    return name.isEmpty() ? what : u"%1-%2"_s.arg(name, what);
}

void FitExporter::askForFile(const QString& name, const QString& suffix, const QString& filter,
                             std::function<void(QString)> then)
{
    auto* dialog = new FileDialog(m_page, tr("Save %1").arg(name), QString(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(u"%1.%2"_s.arg(name, suffix));
    connect(dialog, &QFileDialog::fileSelected, this, std::move(then));
    dialog->open();
}

void FitExporter::askForFolder()
{
    auto* dialog = new FileDialog(m_page, tr("Save everything into a folder"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) { saveAll(folder); });
    dialog->open();
}

void FitExporter::write(std::vector<Job> jobs)
{
    ++m_pending;
    emit told(tr("saving…"));
    const QFileInfo first(jobs.front().file);
    const auto count = int(jobs.size());
    const QString success =
        count == 1 ? tr("saved %1").arg(first.fileName()) : tr("saved %n file(s)", nullptr, count);
    const QString message = count == 1 ? tr("Saved as %1").arg(QDir::toNativeSeparators(first.filePath()))
                                       : tr("Saved in %1").arg(QDir::toNativeSeparators(first.path()));
    const auto work = [jobs = std::move(jobs)]() -> QString {
        for (const Job& job : jobs)
            if (const QString problem = writeFile(job.file, job.make()); !problem.isEmpty())
                return u"%1: %2"_s.arg(QDir::toNativeSeparators(job.file), problem);
        return {};
    };
    m_workbench->background().compute<QString>(this, work, [this, success, message](const QString& problem) {
        --m_pending;
        if (problem.isEmpty()) {
            tell(success, message);
            return;
        }
        emit told({});
        m_workbench->messages().report(
            tr("Not saved: %1. Choose a folder that you may write to and that has room, "
               "then save again.")
                .arg(problem));
    });
}

void FitExporter::tell(const QString& words, const QString& message)
{
    if (isSignalConnected(QMetaMethod::fromSignal(&FitExporter::told)))
        emit told(words);
    else
        m_workbench->messages().tell(message);
}

} // namespace gripscope
