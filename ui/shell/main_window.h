// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

class QButtonGroup;
class QScrollBar;
class QStackedWidget;

namespace gripscope {

class HeaderBar;
class ManualWindow;
class MessageBar;
class Page;
class Workbench;

/// The one window: navigation rail, header with Stop, message bar, the page, status line. Stop is
/// in reach whatever is open (WindowGuard); Ctrl+1... choose a page, Ctrl+, opens the settings.
class MainWindow : public QWidget {
    Q_OBJECT
public:
    explicit MainWindow(Workbench& workbench, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] const std::vector<Page*>& pages() const { return m_pages; }
    [[nodiscard]] Page* currentPage() const;
    void showPage(int index);
    void showPage(const QString& id);
    void showHelp();                      ///< the manual, at the page about the screen
    void showHelpOn(const QString& page); ///< at this page; at the one about the screen where it is empty
    void showSettings();
    [[nodiscard]] QString message() const; ///< the one in the message bar
    /// Those that another window still shows, which this one replaces.
    void takeMessages(const MainWindow& other);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void askWhetherToLose();
    bool m_closesAnyway = false; ///< though inspections are not stored
    void addPages();
    void makeRoom();
    void tellDisarmed(); ///< why, though nobody asked for it; until it is armed again
    QWidget* makeRail();
    void showAbout();
    void makeShortcuts();
    Workbench* m_workbench;
    std::vector<Page*> m_pages;
    QStackedWidget* m_stack;
    HeaderBar* m_header;
    MessageBar* m_messages;
    QWidget* m_foot; ///< the status line and what parts it from the page
    QButtonGroup* m_rail;
    QPointer<ManualWindow> m_manual;
};

/// Gives the pages at least the height that they need: where a message leaves less of a low window, they are
/// scrolled, and the window stays as large as it is. By hand, since a QScrollArea would ask for the height
/// that they like best.
class PageView : public QWidget {
    Q_OBJECT
public:
    PageView(QStackedWidget& pages, QWidget* parent);
    ~PageView() override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void place();
    void reveal(const QWidget& widget); ///< that the keyboard came to
    QStackedWidget* m_pages;
    QScrollBar* m_bar; ///< over their margin: they keep their width
};

} // namespace gripscope
