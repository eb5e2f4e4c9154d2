// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/support/test_registry.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/painted_outside.h"
#include "tests/ui/painted_text.h"
#include "ui/charts/type_map.h"
#include "ui/theme/theme.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

int pixelsOf(TypeMap& map, const QColor& color)
{
    const QImage image = toImage(map, 1);
    int pixels = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            pixels += image.pixelColor(x, y).rgb() == color.rgb() ? 1 : 0;
    return pixels;
}

} // namespace

class TypeMapTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void cleanup() { DisplayUnits::choose({}); }
    void squeezesArePointsAndTheOwnTypesStandOut()
    {
        const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
        const TypeModels models = fitTypeModels(squeezes);
        TypeMap map;
        map.resize(500, 400);
        map.setTypes(models);
        const QColor color = Theme::typeColor(models.types[0].place);
        const int without = pixelsOf(map, color);
        map.setSqueezes(squeezes, models.types[0].name);
        const int own = pixelsOf(map, color);
        map.setSqueezes(squeezes, models.types[1].name);
        const int others = pixelsOf(map, color);
        QVERIFY2(own > without + 50, qPrintable(u"%1, %2"_s.arg(own).arg(without))); // ten filled points
        QVERIFY2(others < own - 50, qPrintable(u"%1, %2"_s.arg(own).arg(others)));
        map.setSqueezes({{u"of no type here"_s, {0.04, 40, 1e4}}, {models.types[0].name, {0.04, -1, 1e4}}},
                        models.types[0].name);
        QCOMPARE(pixelsOf(map, color), without);
    }
    /// Types alike in k and b, such as foams that yield unlike, in the least window: no words over others.
    void namesOfTypesAlikeStandApart_data() { test::languageRows(); }
    void namesOfTypesAlikeStandApart()
    {
        const test::RowLanguage language;
        std::vector<TypeSqueeze> squeezes;
        for (const QString& name : {u"Foam, quick"_s, u"Foam, slow"_s, u"Foam, third"_s, u"Can B"_s})
            for (const double e : {0.96, 0.98, 1.0, 1.03, 1.05})
                squeezes.push_back({name, {0.04, 43 / e, (name == u"Can B"_s ? 1.05e4 : 1e4) * e}});
        TypeMap map;
        map.setTypes(fitTypeModels(squeezes));
        map.setPart(MassDampingStiffness{0.04, 43, 1e4}, {});
        for (const QSize size : {QSize(270, 165), QSize(240, 150), QSize(360, 200), QSize(640, 300)}) {
            map.resize(size);
            const std::vector<test::PaintedText> texts = test::textsPaintedBy(map);
            for (std::size_t i = 0; i < texts.size(); ++i)
                for (std::size_t j = i + 1; j < texts.size(); ++j)
                    QVERIFY2(!texts[i].ink.intersects(texts[j].ink),
                             qPrintable(u"%1 x %2: %3 over %4"_s.arg(size.width())
                                            .arg(size.height())
                                            .arg(texts[i].text, texts[j].text)));
        }
    }
    void aFigureKeepsToItsSize_data()
    {
        QTest::addColumn<FigureWidth>("width");
        QTest::newRow("screen") << FigureWidth::Screen;
        QTest::newRow("one column") << FigureWidth::OneColumn;
        QTest::newRow("two columns") << FigureWidth::TwoColumns;
    }
    void aFigureKeepsToItsSize()
    {
        QFETCH(FigureWidth, width);
        std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
        for (TypeSqueeze& squeeze : squeezes)
            squeeze.type += u", with a name that is far too long for a map"_s;
        TypeMap map;
        map.resize(300, 160);
        map.setTypes(fitTypeModels(squeezes));
        map.setSqueezes(squeezes, squeezes.front().type);
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        covariance.diagonal() = Eigen::Vector3d(1, 1e4, 1e9); // an edge far beyond the plot
        map.setPart(MassDampingStiffness{0.04, 30, 9000}, covariance);
        const FigureLayout layout(map, width);
        QCOMPARE(test::paintedOutside(map), 0);
        const QByteArray svg = toSvg(map);
        QVERIFY(svg.contains("stiffness (") && !svg.contains("<image"));
    }
    void itsTableHoldsAllThatIsDrawnInSi()
    {
        DisplayUnits::choose({DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch});
        const std::vector<TypeSqueeze> squeezes = paperSqueezesInSi();
        const TypeModels models = fitTypeModels(squeezes);
        TypeMap map;
        map.setTypes(models);
        map.setSqueezes(squeezes, {});
        map.setPart(squeezes[3].parameters, {});
        const PlotTable table = map.numbers();
        QCOMPARE(table[2].name, u"stiffness (N/m)"_s);
        QCOMPARE(table[3].name, u"damping (N s/m)"_s);
        const auto count = [&table](const QString& what) {
            return std::count(table[0].texts->begin(), table[0].texts->end(), what);
        };
        QCOMPARE(count(u"mean"_s), 4);
        QCOMPARE(count(u"squeeze"_s), 40);
        QCOMPARE(count(u"this part"_s), 1);
        QCOMPARE(count(u"edge of 95 %"_s), 4 * 64);
        QVERIFY(std::abs(table[2].values->back() / squeezes[3].parameters.k - 1) < 1e-12);
    }
};

GRIPSCOPE_TEST(TypeMapTest)
#include "type_map_test.moc"
