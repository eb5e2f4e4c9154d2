// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/enroll_steps.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/enroll/enroll_picture_field.h"
#include "ui/pages/part_picture.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::enterTypeName;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using Step = EnrollSession::Step;
using Activity = EnrollSession::Activity;

namespace {

template <typename T>
T ask(WindowFixture& f, std::function<Expected<T>(Library&)> work)
{
    return f.bench->library().run<T>(std::move(work)).get().value();
}

std::vector<EnrollmentDraft> drafts(WindowFixture& f)
{
    return ask<std::vector<EnrollmentDraft>>(f, [](Library& l) { return l.drafts(); });
}

void goToSqueezes(WindowFixture& f, const QString& name)
{
    enterTypeName(f, name);
    QTest::keyClick(f.window->focusWidget(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), Step::Squeeze, gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("enrollArmButton"));
}

void squeeze(WindowFixture& f, Activity then)
{
    auto* button = f.find<QPushButton>("enrollSqueezeButton");
    QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), gripscope::test::longEnough_ms);
    const std::size_t before = f.bench->enrollment().squeezes().size();
    f.click(button);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().squeezes().size(), before + 1,
                              gripscope::test::longEnough_ms);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().activity(), then, gripscope::test::longEnough_ms);
}

/// Half red, half blue, with a note that the camera was held on its side.
QByteArray sidewaysPhotograph(const QSize& size)
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::red);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "jpeg");
    // An Exif block with one entry: orientation 6, to be turned by 90 degrees.
    const QByteArray exif = QByteArray::fromHex("ffe1002245786966000049492a0008000000010012010300010000000600"
                                                "000000000000");
    return bytes.left(2) + exif + bytes.mid(2);
}

void write(const QString& name, const QByteArray& bytes)
{
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

} // namespace

/// Interrupting and going on, undo, pictures, and squeezes that are accepted by themselves; by click and key.
class EnrollFlowTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsLeftForLaterIsGoneOnWith();
    void aDiscardedEnrolmentCanBeBroughtBack();
    void goodSqueezesAreAcceptedByThemselvesAndUndone();
    void theSqueezeUnderWayShowsWhatIsKnownSoFar();
    void theRecipesCrushLimitHolds();
    void aPictureIsDroppedPastedAndStoredWithTheType();
    void aPictureIsTurnedAndMadeSmaller();
    void aFileThatIsNoPictureIsToldWithTheReason_data();
    void aFileThatIsNoPictureIsToldWithTheReason();
    void enterWalksThroughTheFormsAndNeverArmsOrSqueezes();
};

void EnrollFlowTest::whatIsLeftForLaterIsGoneOnWith()
{
    WindowFixture f(false, unhurriedA);
    goToSqueezes(f, u"Cola 330 ml"_s);
    squeeze(f, Activity::Waiting); // accepted by itself
    f.find<QCheckBox>("acceptByItself")->click();
    squeeze(f, Activity::Deciding);
    f.click(f.find<QPushButton>("leaveForLater"));
    QTRY_COMPARE(f.bench->enrollment().step(), Step::Name);
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QPushButton*>(u"goOnWithDraft"_s),
                             gripscope::test::longEnough_ms);
    QCOMPARE(drafts(f).front().squeezes, 1);
    bool told = false;
    for (const QLabel* label : f.page(u"enroll"_s)->findChildren<QLabel*>())
        told |= label->text().contains(u"Squeezes so far: 1, and one to decide on"_s);
    QVERIFY(told);
    f.click(f.find<QPushButton>("goOnWithDraft"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().activity(), Activity::Deciding,
                              gripscope::test::longEnough_ms);
    QCOMPARE(f.bench->enrollment().typeName(), u"Cola 330 ml"_s);
    QCOMPARE(f.bench->enrollment().acceptedCount(), 1);
    auto* accept = f.find<QPushButton>("acceptButton");
    QTRY_VERIFY(accept->isVisible() && accept->isEnabled());
    f.click(accept);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 2, gripscope::test::longEnough_ms);
    QCOMPARE(ask<std::vector<TypeRecord>>(f, [](Library& l) { return l.types(); })[0].squeezes, 2);
}

void EnrollFlowTest::aDiscardedEnrolmentCanBeBroughtBack()
{
    WindowFixture f(false);
    enterTypeName(f, u"Cola"_s);
    f.click(f.find<QPushButton>("leaveForLater"));
    QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QPushButton*>(u"discardDraft"_s),
                             gripscope::test::longEnough_ms);
    f.click(f.find<QPushButton>("discardDraft"));
    auto* undo = f.find<QPushButton>("undoStep");
    QTRY_VERIFY_WITH_TIMEOUT(undo->isEnabled(), gripscope::test::longEnough_ms);
    QVERIFY(drafts(f).empty());
    f.click(undo);
    QTRY_VERIFY_WITH_TIMEOUT(!undo->isEnabled(), gripscope::test::longEnough_ms);
    QCOMPARE(drafts(f).front().name, u"Cola"_s);
    QTRY_VERIFY(f.window->findChild<QPushButton*>(u"goOnWithDraft"_s));
}

void EnrollFlowTest::goodSqueezesAreAcceptedByThemselvesAndUndone()
{
    WindowFixture f(false, unhurriedA);
    goToSqueezes(f, u"Can"_s);
    squeeze(f, Activity::Waiting);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);
    Page* page = f.page(u"enroll"_s);
    f.makeActive();
    QTest::keyClick(page, Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().activity(), Activity::Deciding,
                              gripscope::test::longEnough_ms);
    QTest::qWait(300);
    QCOMPARE(f.bench->enrollment().activity(), Activity::Deciding); // it is not accepted again by itself
    QCOMPARE(f.bench->enrollment().acceptedCount(), 0);
    f.click(f.find<QPushButton>("undoStep")); // the squeeze itself
    QTRY_VERIFY(f.bench->enrollment().squeezes().empty());
    f.click(f.find<QPushButton>("redoStep"));
    QTRY_COMPARE(f.bench->enrollment().activity(), Activity::Deciding);
    f.click(f.find<QPushButton>("redoStep"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);
    const auto changes = ask<std::vector<LibraryChange>>(f, [](Library& l) { return l.changes(10); });
    QVERIFY(changes[0].kind == ChangeKind::Undrop && changes[1].kind == ChangeKind::Drop);
}

void EnrollFlowTest::theSqueezeUnderWayShowsWhatIsKnownSoFar()
{
    WindowFixture f(false);
    goToSqueezes(f, u"Can"_s);
    auto* button = f.find<QPushButton>("enrollSqueezeButton");
    QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), gripscope::test::longEnough_ms);
    f.click(button);
    const auto* words = f.find<QLabel>("squeezeWords");
    QTRY_VERIFY_WITH_TIMEOUT(words->text().contains(u"so far"_s), gripscope::test::longEnough_ms);
    QVERIFY(f.bench->enrollment().activity() == Activity::Squeezing);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);
}

void EnrollFlowTest::theRecipesCrushLimitHolds()
{
    WindowFixture f(false);
    enterTypeName(f, u"Fragile"_s);
    QDoubleSpinBox* limit = nullptr;
    for (QDoubleSpinBox* field : f.page(u"enroll"_s)->findChildren<QDoubleSpinBox*>())
        if (field->accessibleName() == u"Crush limit"_s)
            limit = field;
    QVERIFY(limit);
    QTRY_VERIFY(limit->isVisible()); // the page follows the session with the next poll
    limit->setFocus();
    limit->selectAll();
    QTest::keyClicks(limit, u"25"_s); // 20 + 10 N are asked for
    QTRY_VERIFY(!f.find<QPushButton>("recipeNext")->isEnabled());
    QTest::keyClick(limit, Qt::Key_Return);
    QCOMPARE(f.bench->enrollment().step(), Step::Recipe);
    const QString told = f.page(u"enroll"_s)->findChild<QLabel*>(u"recipeSummary"_s)->text();
    QVERIFY2(told.contains(u"25"_s), qPrintable(told));
    limit->selectAll();
    QTest::keyClicks(limit, u"33"_s);
    QTest::keyClick(limit, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), Step::Squeeze, gripscope::test::longEnough_ms);
    QTRY_COMPARE(drafts(f).front().recipe.maxForce_N, 33.0);
}

void EnrollFlowTest::aPictureIsDroppedPastedAndStoredWithTheType()
{
    WindowFixture f(false);
    f.window->showPage(u"enroll"_s);
    auto* field = f.find<EnrollPictureField>("pictureField");
    auto* view = f.find<PartPictureView>("pictureView");
    // Dropped: a file.
    const QTemporaryDir folder;
    const QString photograph = folder.filePath(u"can.jpg"_s);
    write(photograph, sidewaysPhotograph({300, 200}));
    QMimeData dropped;
    dropped.setUrls({QUrl::fromLocalFile(photograph)});
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QVERIFY(QCoreApplication::sendEvent(field, &enter) && enter.isAccepted());
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(field, &drop);
    QTRY_VERIFY_WITH_TIMEOUT(view->hasPicture(), gripscope::test::longEnough_ms);
    QCOMPARE(f.bench->enrollment().picture()->format, u"jpeg"_s);
    // Pasted over it: a picture.
    QImage image(40, 30, QImage::Format_RGB32);
    image.fill(Qt::blue);
    QGuiApplication::clipboard()->setImage(image);
    f.click(f.find<QPushButton>("pastePicture"));
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().picture()->format, u"png"_s,
                              gripscope::test::longEnough_ms);
    goToSqueezes(f, u"Can"_s);
    squeeze(f, Activity::Waiting);
    QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().acceptedCount(), 1, gripscope::test::longEnough_ms);
    const auto picture = ask<std::optional<PartPicture>>(f, [](Library& l) {
        return l.types().and_then([&l](const auto& types) { return l.typePicture(types[0].id); });
    });
    QVERIFY(picture);
    QCOMPARE(QSize(picture->width, picture->height), QSize(40, 30));
    QCOMPARE(shownPicture(*picture, 100).pixelColor(5, 5), QColor(Qt::blue));
}

void EnrollFlowTest::aPictureIsTurnedAndMadeSmaller()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(u"large.jpg"_s);
    write(name, sidewaysPhotograph({3000, 2000}));
    const Expected<PartPicture> picture = readPartPicture(name);
    QVERIFY(picture);
    QCOMPARE(QSize(picture->width, picture->height), QSize(682, 1024));
    QVERIFY(picture->bytes.size() < 500'000);
}

void EnrollFlowTest::aFileThatIsNoPictureIsToldWithTheReason_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("word");
    QTest::newRow("text") << QByteArray("k = 9990") << u"neither a PNG nor a JPEG"_s;
    QTest::newRow("empty") << QByteArray() << u"neither a PNG nor a JPEG"_s;
    QTest::newRow("another kind") << QByteArray("GIF89a\1\0\1\0\0\0\0;", 14) << u"neither a PNG nor a JPEG"_s;
    QTest::newRow("cut off") << QByteArray::fromHex("89504e470d0a1a0a0000000d49484452") << u"damaged"_s;
}

void EnrollFlowTest::aFileThatIsNoPictureIsToldWithTheReason()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, word);
    WindowFixture f(false);
    f.window->showPage(u"enroll"_s);
    const QTemporaryDir folder;
    const QString name = folder.filePath(u"picture.png"_s);
    write(name, bytes);
    f.find<EnrollPictureField>("pictureField")->readFile(name);
    const auto* words = f.find<QLabel>("pictureWords");
    QTRY_VERIFY2_WITH_TIMEOUT(words->text().contains(word), qPrintable(words->text()),
                              gripscope::test::longEnough_ms);
    QVERIFY(words->text().contains(name));
    QVERIFY(!f.bench->enrollment().picture());
}

void EnrollFlowTest::enterWalksThroughTheFormsAndNeverArmsOrSqueezes()
{
    WindowFixture f(false);
    goToSqueezes(f, u"Can"_s);
    QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), gripscope::test::longEnough_ms);
    f.bench->stop();
    QTRY_VERIFY(!f.bench->connection().armed());
    for (int i = 0; i < 3; ++i) {
        QWidget* focus = f.window->focusWidget();
        QTest::keyClick(focus ? focus : f.window.get(), Qt::Key_Return);
    }
    QTest::qWait(100);
    QVERIFY(!f.bench->connection().armed());
    QCOMPARE(f.bench->enrollment().activity(), Activity::Waiting);
}

GRIPSCOPE_TEST(EnrollFlowTest)
#include "enroll_flow_test.moc"
