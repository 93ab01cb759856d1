// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/edit_json.h"

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

class EditJsonTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindComesBack_data();
    void everyKindComesBack();
    void whatIsNoPayloadIsRefused_data();
    void whatIsNoPayloadIsRefused();
    void namesAreClean_data();
    void namesAreClean();
    void namesHaveAtMost120Characters();
};

void EditJsonTest::everyKindComesBack_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("payload");
    QTest::newRow("rename") << "rename"
                            << R"({"planes":[3],"text":"north \"wall\""})";
    QTest::newRow("rename away") << "rename"
                                 << R"({"planes":[3],"text":""})";
    QTest::newRow("classify") << "classify"
                              << R"({"planes":[3,4],"text":"door"})";
    QTest::newRow("hide") << "hide"
                          << R"({"planes":[3],"on":true})";
    QTest::newRow("show") << "hide"
                          << R"({"planes":[3],"on":false})";
    QTest::newRow("delete") << "delete"
                            << R"({"planes":[0,2147483647]})";
    QTest::newRow("merge") << "merge"
                           << R"({"planes":[3,7,5]})";
    QTest::newRow("split") << "split"
                           << R"({"planes":[4]})";
    QTest::newRow("lock") << "lock"
                          << R"({"planes":[4],"on":true})";
}

void EditJsonTest::everyKindComesBack()
{
    QFETCH(QString, kind);
    QFETCH(QString, payload);

    const auto edit = readEditJson(kind.toStdString(), payload.toStdString(), "here");

    QVERIFY2(edit, edit ? "" : edit.error().message.c_str());
    QCOMPARE(QString::fromStdString(std::string{name(edit->kind)}), kind);
    QCOMPARE(QString::fromStdString(editJson(*edit)), payload);
}

void EditJsonTest::whatIsNoPayloadIsRefused_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("payload");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* what, const char* kind, const QString& payload, const char* message) {
        QTest::newRow(what) << kind << payload << QString("here: ") + message;
    };
    row("an unknown kind", "explode", R"({"planes":[3]})", "there is no edit 'explode'");
    row("no JSON", "delete", "3", "the payload has no list 'planes'");
    row("no planes", "delete", "{}", "the payload has no list 'planes'");
    row("an empty list", "delete", R"({"planes":[]})", "'planes' is no list of 1 to 10000 plane numbers");
    row("a negative plane", "delete", R"({"planes":[-1]})", "'planes' holds something that is no plane number");
    row("half a plane", "delete", R"({"planes":[1.5]})", "'planes' holds something that is no plane number");
    row("a plane beyond int", "delete", R"({"planes":[2147483648]})",
        "'planes' holds something that is no plane number");
    row("a plane twice", "merge", R"({"planes":[3,3]})", "'planes' names plane 3 twice");
    row("a merge of one", "merge", R"({"planes":[3]})", "a merge needs two planes");
    row("a split of two", "split", R"({"planes":[3,4]})", "a split takes one plane");
    row("a name without text", "rename", R"({"planes":[3]})", "the payload has no 'text'");
    row("a name that is a number", "rename", R"({"planes":[3],"text":7})",
        "'text' does not belong into the payload of this edit, or is of a wrong type");
    row("something else", "delete", R"({"planes":[3],"why":"so"})",
        "'why' does not belong into the payload of this edit, or is of a wrong type");
    row("a key twice", "delete", R"({"planes":[3],"planes":[4]})",
        "the key 'planes' is there twice; remove one of the two");
    row("deep nesting", "delete", QString("[").repeated(100),
        "the file nests deeper than 64 levels; give a flatter one");
    row("a large payload", "delete", QString(" ").repeated((1 << 20) + 1), "the payload is larger than 1048576 bytes");
}

void EditJsonTest::whatIsNoPayloadIsRefused()
{
    QFETCH(QString, kind);
    QFETCH(QString, payload);
    QFETCH(QString, message);

    const auto edit = readEditJson(kind.toStdString(), payload.toStdString(), "here");

    QVERIFY(!edit);
    QVERIFY(edit.error().code == ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(edit.error().message), message);
}

void EditJsonTest::namesAreClean_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("clean");
    QTest::newRow("plain") << QByteArray("north wall") << QByteArray("north wall");
    QTest::newRow("other alphabets") << QByteArray("Wand Süd, стена 壁 🧱")
                                     << QByteArray("Wand Süd, стена 壁 🧱");
    QTest::newRow("blanks around") << QByteArray("  wall \t") << QByteArray("wall");
    QTest::newRow("line ends") << QByteArray("north\r\nwall") << QByteArray("north wall");
    QTest::newRow("escape sequences") << QByteArray("\x1b[31mred\x07") << QByteArray("[31mred");
    QTest::newRow("C1 controls") << QByteArray(
                                        "a\xc2\x9b"
                                        "b")
                                 << QByteArray("ab");
    QTest::newRow("turned writing") << QByteArray("\u202Etxt.exe\u202C \u2066x\u2069 \u200Fy\u061C")
                                    << QByteArray("txt.exe x y");
    QTest::newRow("no UTF-8") << QByteArray(
                                     "a\xff\xfe"
                                     "b\xe4")
                              << QByteArray("ab");
    QTest::newRow("zero byte") << QByteArray("a\0b", 3) << QByteArray("ab");
    QTest::newRow("nothing left") << QByteArray("\u202E\n") << QByteArray("");
}

void EditJsonTest::namesAreClean()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, clean);

    QCOMPARE(QByteArray::fromStdString(cleanName(text.toStdString())), clean);
}

void EditJsonTest::namesHaveAtMost120Characters()
{
    const std::string name = cleanName(QByteArray("ü").repeated(10'000).toStdString());

    QCOMPARE(QString::fromStdString(name), QString("ü").repeated(120));
}

PLANEWRIGHT_TEST(EditJsonTest)
#include "edit_json_test.moc"
