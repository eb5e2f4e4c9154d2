// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFontInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace Qt::StringLiterals;
using namespace gripscope;

class ThemeTest : public QObject {
    Q_OBJECT
private slots:
    void contrastIsThatOfWcag();
    void everyWordReadsOnPageAndSurface_data();
    void everyWordReadsOnPageAndSurface();
    void typeColorsHoldThreeToOneOnLight();
    void outcomesDifferInEveryTheme();
    void whatIsDisabledLooksIt_data();
    void whatIsDisabledLooksIt();
    void aChoiceThatIsOffIsSeen_data();
    void aChoiceThatIsOffIsSeen();
    void aFocusedPrimaryButtonHasNoPatchInside();
    void aQuietButtonIsFramed_data();
    void aQuietButtonIsFramed();
    void titlesStandAboveTheirCells();
    void iconsTakeTheColorAskedFor();
    void styleSheetHasNoUnknownName_data();
    void styleSheetHasNoUnknownName();
    void fontIsNotoSans();
};

void ThemeTest::contrastIsThatOfWcag()
{
    QCOMPARE(Theme::contrastRatio(Qt::black, Qt::white), 21.0);
    // #767676 is the well-known lightest grey that holds 4.5 on white.
    QVERIFY(Theme::contrastRatio(QColor(u"#767676"_s), Qt::white) >= 4.5);
    QVERIFY(Theme::contrastRatio(QColor(u"#777777"_s), Qt::white) < 4.5);
}

void ThemeTest::everyWordReadsOnPageAndSurface_data()
{
    QTest::addColumn<ThemeKind>("kind");
    QTest::newRow("light") << ThemeKind::Light;
    QTest::newRow("dark") << ThemeKind::Dark;
    QTest::newRow("contrast") << ThemeKind::HighContrast;
}

void ThemeTest::everyWordReadsOnPageAndSurface()
{
    QFETCH(ThemeKind, kind);
    const ThemeTokens t = themeTokens(kind);
    const std::pair<const char*, QColor> words[] = {
        {"text", t.text},       {"secondText", t.secondText}, {"accent", t.accent},
        {"stop", t.stop},       {"asExpected", t.asExpected}, {"otherType", t.otherType},
        {"unknown", t.unknown}, {"notValid", t.notValid},     {"inconclusive", t.inconclusive},
        {"suspect", t.suspect}, {"force", t.force},           {"position", t.position},
        {"model", t.model}};
    for (const auto& [name, color] : words) {
        QVERIFY2(Theme::contrastRatio(color, t.page) >= 4.5, name);
        QVERIFY2(Theme::contrastRatio(color, t.surface) >= 4.5, name);
    }
    QVERIFY(Theme::contrastRatio(Theme::onColor(t.stop), t.stop) >= 4.5);
    QVERIFY(Theme::contrastRatio(Theme::onColor(t.accent), t.accent) >= 4.5);
}

void ThemeTest::typeColorsHoldThreeToOneOnLight()
{
    const ThemeTokens light = themeTokens(ThemeKind::Light);
    for (int i = 0; i < 8; ++i) {
        QVERIFY(Theme::contrastRatio(Theme::typeColor(i), light.surface) >= 3.0);
        for (int j = 0; j < i; ++j)
            QVERIFY(Theme::typeColor(i) != Theme::typeColor(j));
    }
    QCOMPARE(Theme::typeColor(8), Theme::typeColor(0));
}

void ThemeTest::outcomesDifferInEveryTheme()
{
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast}) {
        const ThemeTokens t = themeTokens(kind);
        const QList<QColor> colors{t.asExpected, t.otherType, t.unknown, t.inconclusive,
                                   t.notValid,   t.suspect,   t.stop};
        for (qsizetype i = 0; i < colors.size(); ++i)
            QCOMPARE(colors.indexOf(colors[i]), i);
    }
}

namespace {

QImage pictureOf(QWidget& widget)
{
    widget.ensurePolished();
    widget.resize(widget.sizeHint().expandedTo({120, 44}));
    QImage picture(widget.size(), QImage::Format_RGB32);
    picture.fill(Theme::instance().tokens().surface);
    widget.render(&picture, {}, {}, QWidget::DrawChildren | QWidget::DrawWindowBackground);
    return picture;
}

/// How much the strongest pixel stands out from what it lies on.
double strongest(const QImage& picture, const QColor& ground)
{
    double most = 1;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            most = std::max(most, Theme::contrastRatio(picture.pixelColor(x, y), ground));
    return most;
}

/// Everything with words or numbers in it that can be disabled, by the name of its kind.
QWidget* controlOf(const QString& kind)
{
    const auto button = [&](const char* role) {
        QPushButton* made = makeButton(u"Words"_s, {}, role);
        return made;
    };
    if (kind == u"button"_s)
        return button("");
    if (kind == u"primary"_s)
        return button("primary");
    if (kind == u"quiet"_s)
        return button("quiet");
    if (kind == u"check box"_s)
        return new QCheckBox(u"Words"_s);
    if (kind == u"radio button"_s)
        return new QRadioButton(u"Words"_s);
    if (kind == u"label"_s)
        return new QLabel(u"Words"_s);
    if (kind == u"field"_s)
        return new QLineEdit(u"Words"_s);
    if (kind == u"number"_s) {
        auto* number = new QSpinBox;
        number->setRange(0, 9999);
        number->setValue(8888); // ink enough for its own colour, without blending at edges
        return number;
    }
    if (kind == u"tool"_s) {
        auto* tool = new QToolButton;
        tool->setText(u"Words"_s);
        return tool;
    }
    auto* box = new QComboBox;
    box->addItem(u"Words"_s);
    return box;
}

void kindsInThemes(std::initializer_list<const char*> kinds)
{
    QTest::addColumn<ThemeKind>("theme");
    QTest::addColumn<QString>("kind");
    const std::pair<ThemeKind, const char*> themes[] = {
        {ThemeKind::Light, "light"}, {ThemeKind::Dark, "dark"}, {ThemeKind::HighContrast, "contrast"}};
    for (const auto& [theme, name] : themes)
        for (const char* kind : kinds)
            QTest::addRow("%s %s", name, kind) << theme << QString::fromLatin1(kind);
}

} // namespace

void ThemeTest::whatIsDisabledLooksIt_data()
{
    kindsInThemes({"button", "primary", "quiet", "check box", "radio button", "label", "field", "number",
                   "tool", "list"});
}

void ThemeTest::whatIsDisabledLooksIt()
{
    QFETCH(ThemeKind, theme);
    QFETCH(QString, kind);
    Theme::instance().apply(theme);
    const ThemeTokens& t = Theme::instance().tokens();
    const std::unique_ptr<QWidget> control(controlOf(kind));
    // The fill of the primary button is what stands out there.
    const double enabled = strongest(pictureOf(*control), t.surface);
    control->setEnabled(false);
    const double disabled = strongest(pictureOf(*control), t.surface);
    QVERIFY2(disabled > 1.3, qPrintable(QString::number(disabled)));
    // On light the accent itself is not much stronger than a grey that can be read.
    const double most = kind == u"primary"_s || kind == u"quiet"_s ? 1.15 : 0.75;
    QVERIFY2(disabled <= most * enabled, qPrintable(u"%1 of %2"_s.arg(disabled).arg(enabled)));
    control->setEnabled(true);
    const QImage on = pictureOf(*control);
    control->setEnabled(false);
    QVERIFY(pictureOf(*control) != on);
}

void ThemeTest::aChoiceThatIsOffIsSeen_data()
{
    kindsInThemes({"check box", "radio button"});
}

void ThemeTest::aChoiceThatIsOffIsSeen()
{
    QFETCH(ThemeKind, theme);
    QFETCH(QString, kind);
    Theme::instance().apply(theme);
    const ThemeTokens& t = Theme::instance().tokens();
    const std::unique_ptr<QWidget> control(controlOf(kind));
    auto* choice = qobject_cast<QAbstractButton*>(control.get());
    choice->setText({}); // the sign alone
    choice->setAutoExclusive(false);
    const QImage off = pictureOf(*control);
    QVERIFY(strongest(off, t.surface) >= 3); // WCAG 2.1, 1.4.11
    choice->setChecked(true);
    const QImage on = pictureOf(*control);
    QVERIFY(strongest(on, t.surface) >= 3);
    QVERIFY(on != off);
}

void ThemeTest::aFocusedPrimaryButtonHasNoPatchInside()
{
    Theme::instance().apply(ThemeKind::Light);
    const std::unique_ptr<QPushButton> button(makeButton({}, {}, "primary"));
    button->resize(160, 48);
    button->show();
    button->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(button.get()));
    button->setFocus(Qt::TabFocusReason);
    QVERIFY(button->hasFocus());
    const QImage picture = button->grab().toImage();
    const QColor accent = Theme::instance().tokens().accent;
    for (int y = 8; y < picture.height() - 8; ++y)
        for (int x = 8; x < picture.width() - 8; ++x)
            QCOMPARE(picture.pixelColor(x, y), accent);
}

void ThemeTest::aQuietButtonIsFramed_data()
{
    kindsInThemes({"quiet"});
}

/// Words alone are no button.
void ThemeTest::aQuietButtonIsFramed()
{
    QFETCH(ThemeKind, theme);
    Theme::instance().apply(theme);
    const std::unique_ptr<QWidget> quiet(controlOf(u"quiet"_s)), plain(controlOf(u"button"_s));
    for (const bool enabled : {true, false}) {
        quiet->setEnabled(enabled);
        plain->setEnabled(enabled);
        const QImage picture = pictureOf(*quiet), other = pictureOf(*plain);
        QCOMPARE(quiet->sizeHint(), plain->sizeHint());
        const QColor surface = Theme::instance().tokens().surface;
        int framed = 0;
        for (int y = 8; y < picture.height() - 8; ++y) { // between the round corners
            QCOMPARE(picture.pixelColor(0, y), other.pixelColor(0, y));
            framed += Theme::contrastRatio(picture.pixelColor(0, y), surface) > 1.3 ? 1 : 0;
        }
        QVERIFY2(framed >= (picture.height() - 16) / 3, qPrintable(QString::number(framed))); // dashes too
    }
}

void ThemeTest::titlesStandAboveTheirCells()
{
    Theme::instance().apply(ThemeKind::Light);
    QTableWidget table(1, 1);
    setUpRowList(&table, 36);
    table.setHorizontalHeaderLabels({u"H"_s});
    table.setItem(0, 0, new QTableWidgetItem(u"H"_s));
    table.resize(200, 120);
    table.show();
    QVERIFY(QTest::qWaitForWindowExposed(&table));
    const auto firstInk = [](const QImage& picture) {
        for (int x = 3; x < picture.width(); ++x)
            for (int y = 4; y < picture.height() - 4; ++y)
                if (Theme::contrastRatio(picture.pixelColor(x, y), Qt::white) > 2.5)
                    return x;
        return -1;
    };
    const int title = firstInk(table.horizontalHeader()->grab({0, 0, 60, 28}).toImage());
    const int cell = firstInk(table.viewport()->grab({0, 0, 60, 34}).toImage());
    QVERIFY2(title > 0 && std::abs(title - cell) <= 1, qPrintable(u"%1 %2"_s.arg(title).arg(cell)));
}

void ThemeTest::iconsTakeTheColorAskedFor()
{
    Theme::instance().apply(ThemeKind::Light);
    const QIcon icon = Theme::instance().icon(u"help-about"_s, QColor(Qt::magenta));
    QVERIFY(!icon.isNull());
    const QImage image = icon.pixmap(64, 64).toImage().convertToFormat(QImage::Format_ARGB32);
    int painted = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (c.alpha() < 250)
                continue;
            ++painted;
            QVERIFY(c.red() > 240 && c.green() < 15 && c.blue() > 240);
        }
    QVERIFY(painted > 100);
    QVERIFY(Theme::instance().icon(u"no such icon"_s).isNull());
}

void ThemeTest::styleSheetHasNoUnknownName_data()
{
    everyWordReadsOnPageAndSurface_data();
}

void ThemeTest::styleSheetHasNoUnknownName()
{
    QFETCH(ThemeKind, kind);
    Theme::instance().apply(kind);
    QVERIFY(!qApp->styleSheet().contains(QLatin1Char('@')));
    QVERIFY(!qApp->styleSheet().contains(u"none;\n"_s + u"QComboBox::down-arrow { image: none"_s));
    QVERIFY(qApp->styleSheet().contains(Theme::instance().tokens().accent.name()));
}

void ThemeTest::fontIsNotoSans()
{
    QCOMPARE(QFontInfo(Theme::font(metrics::fontBase)).family(), u"Noto Sans"_s);
}

GRIPSCOPE_TEST(ThemeTest)
#include "theme_test.moc"
