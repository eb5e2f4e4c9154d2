// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

class QKeyEvent;
class QWidget;

namespace gripscope {

/// Tells a barcode scanner from a person. A scanner is a keyboard that types fast and ends with Enter: what
/// comes that way anywhere in the page's window is one text. Fields where text is entered, and dialogs, keep
/// their keys.
///
/// A space may be the first character of a code. So Space on the page, or on one of its buttons, waits a
/// moment that nobody notices; only when nothing follows is it a person's key. Space and Enter within a code
/// press nothing.
class ScanReader : public QObject {
    Q_OBJECT
public:
    /// Scanners that are slow or on the air send a character each 30 ms; a person who is quick, each 80.
    static constexpr int longestGap_ms = 60;

    explicit ScanReader(QWidget* page);
    ~ScanReader() override;
    void setActive(bool active);

signals:
    void scanned(const QString& text);
    void spacePressed(); ///< by a person, and no button had the focus

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QWidget* focus() const;
    [[nodiscard]] bool listensTo(QObject* watched) const;
    [[nodiscard]] bool waitsForSpace() const;
    bool take(const QKeyEvent& key);
    bool takeEnd();
    void pressSpace();
    QWidget* m_page;
    bool m_active = false;
    QString m_typed;
    QElapsedTimer m_sinceKey, m_sinceScan;
    QTimer m_space;
};

} // namespace gripscope
