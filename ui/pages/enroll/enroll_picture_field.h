// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/part_picture.h"

#include <QWidget>

#include <functional>

class QLabel;
class QPushButton;

namespace gripscope {

class PartPictureView;
class Workbench;

/// The picture of a part, to be chosen from a file, dropped or pasted. Reading it is the pool's; a file that
/// is no picture is told with the reason, and the picture stays as it was.
class EnrollPictureField : public QWidget {
    Q_OBJECT
public:
    explicit EnrollPictureField(Workbench& workbench, QWidget* parent = nullptr);
    void showPicture(const std::optional<PartPicture>& picture);
    void clear(); ///< another part: what was said of a file goes, too
    void readFile(const QString& file);
    void paste();

signals:
    void chosen(const std::optional<gripscope::PartPicture>& picture);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void ask();
    void read(std::function<Expected<PartPicture>()> reading);
    Workbench* m_workbench;
    PartPictureView* m_view;
    QLabel* m_words;
    QPushButton *m_choose, *m_paste, *m_remove;
    std::optional<PartPicture> m_shown;
    int m_reading = 0; ///< the newest of those that are read
};

} // namespace gripscope
