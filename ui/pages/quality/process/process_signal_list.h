// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_session.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace gripscope {

/// A signal of a picture as a line: what, which inspection, since when.
struct SignalLine {
    QString quantity, what, since;
    qint64 number = 0;     ///< the inspection at which it was told
    std::uint32_t row = 0; ///< its place in the values
    std::size_t point = 0;
    QString time;
};
/// Newest first, of the quantities that are shown (3: all); at most so many of them.
[[nodiscard]] std::vector<SignalLine> signalLines(const ProcessPicture& picture, std::size_t quantity,
                                                  std::size_t most);
[[nodiscard]] std::size_t countSignals(const ProcessPicture& picture, std::size_t quantity);
[[nodiscard]] std::size_t countPoints(const ProcessPicture& picture,
                                      std::size_t quantity); ///< on those charts

/// What the charts signal, in words. A line leads to its inspection.
class ProcessSignalList : public QWidget {
    Q_OBJECT
public:
    explicit ProcessSignalList(QWidget* parent = nullptr);
    void show(const std::shared_ptr<const ProcessPicture>& picture, std::size_t quantity);

signals:
    void pointShown(qsizetype point); ///< a line was chosen
    void rowChosen(quint32 row);      ///< and opened

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QString verdict(const ProcessPicture& picture, std::size_t quantity, std::size_t all) const;
    QLabel* m_verdict;
    QTableWidget* m_table;
    std::vector<SignalLine> m_lines;
};

} // namespace gripscope
