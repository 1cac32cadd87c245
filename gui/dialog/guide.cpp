// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/guide.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFile>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// In the order of the list, below the shortcuts.
constexpr std::array kPages{
    "desktop",        "ct",      "masks",    "parameters", "ports",           "surface",
    "quality",        "formats", "case",     "report",     "cfd-export",      "privacy",
    "other-programs", "method",  "phantoms", "evidence",   "evidence-tables", "command-line"};
constexpr int kNameRole = Qt::UserRole;

const QString kFolder = QStringLiteral(":/guide/");

QString textOf(const QString& name) {
  QFile file(kFolder + name + ".md");
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The first line of a page, which is its heading.
QString headingOf(const QString& name) {
  return textOf(name).section('\n', 0, 0).remove('#').trimmed();
}

/// Of a heading, as links in Markdown have it.
QString anchorOf(const QString& heading) {
  static const QRegularExpression kDropped("[^a-z0-9 -]");
  return heading.toLower().remove(kDropped).replace(' ', '-');
}

/// Keys and mouse buttons that are not actions of the window.
const std::vector<std::pair<const char*, const char*>>& paneShortcuts() {
  static const std::vector<std::pair<const char*, const char*>> table{
      {QT_TRANSLATE_NOOP("Shortcut", "Left drag on a slice"),
       QT_TRANSLATE_NOOP("Shortcut", "Window and level (Engineering: crosshair; Ctrl: fine)")},
      {QT_TRANSLATE_NOOP("Shortcut", "Left click"),
       QT_TRANSLATE_NOOP("Shortcut", "Crosshair in all panes; in 3D on the surface")},
      {QT_TRANSLATE_NOOP("Shortcut", "Middle drag"), QT_TRANSLATE_NOOP("Shortcut", "Pan")},
      {QT_TRANSLATE_NOOP("Shortcut", "Right drag"), QT_TRANSLATE_NOOP("Shortcut", "Zoom")},
      {QT_TRANSLATE_NOOP("Shortcut", "Wheel on a slice"),
       QT_TRANSLATE_NOOP("Shortcut", "Next or previous slice")},
      {QT_TRANSLATE_NOOP("Shortcut", "Ctrl+wheel"), QT_TRANSLATE_NOOP("Shortcut", "Zoom")},
      {QT_TRANSLATE_NOOP("Shortcut", "Alt+wheel"), QT_TRANSLATE_NOOP("Shortcut", "Slab thickness")},
      {QT_TRANSLATE_NOOP("Shortcut", "Shift+move"),
       QT_TRANSLATE_NOOP("Shortcut", "Crosshair in all panes")},
      {QT_TRANSLATE_NOOP("Shortcut", "Right click"),
       QT_TRANSLATE_NOOP("Shortcut",
                         "Menu: windows; cut the vessel there; on a port: flip, rename, delete")},
      {QT_TRANSLATE_NOOP("Shortcut", "Left drag on a port"),
       QT_TRANSLATE_NOOP("Shortcut", "Along the vessel (Shift: anywhere); by the arrow: tilt")},
      {QT_TRANSLATE_NOOP("Shortcut", "Double click"),
       QT_TRANSLATE_NOOP("Shortcut", "One pane at full size, and back")},
      {QT_TRANSLATE_NOOP("Shortcut", "Arrow keys over a slice"),
       QT_TRANSLATE_NOOP("Shortcut", "Next or previous slice (Shift: by 10)")},
      {QT_TRANSLATE_NOOP("Shortcut", "R"),
       QT_TRANSLATE_NOOP("Shortcut", "Reset the pane under the mouse")},
      {QT_TRANSLATE_NOOP("Shortcut", "A, P, L, Shift+R, S, I over 3D"),
       QT_TRANSLATE_NOOP("Shortcut", "Look from anterior, posterior, left, right, ...")}};
  return table;
}

}  // namespace

/// Markdown from the resources, with pictures that are no wider than the page.
class GuidePage : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    const QImage image(kFolder + name.path());
    if (image.isNull()) return {};
    const int room = viewport()->width() - 2 * static_cast<int>(document()->documentMargin());
    return image.width() > room && room > 0 ? image.scaledToWidth(room, Qt::SmoothTransformation)
                                            : image;
  }

  /// Into a document of its own: Qt's reader of Markdown fails in one that had tables before.
  void read(const QString& markdown) {
    auto page = std::make_unique<QTextDocument>(this);
    page->setMarkdown(markdown);
    setDocument(page.get());
    page_ = std::move(page);
  }

  void goTo(const QString& anchor) {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
      if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) {
        verticalScrollBar()->setValue(
            static_cast<int>(document()->documentLayout()->blockBoundingRect(block).top()));
        return;
      }
  }

 private:
  std::unique_ptr<QTextDocument> page_;
};

Guide::Guide(QWidget* window) : QDialog(window) {
  setObjectName("guide");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Guide"));
  resize(1000, 700);
  list_ = named(new QListWidget(this), "guidePages");
  list_->addItem(tr("Shortcuts"));
  for (const char* page : kPages) {
    auto* item = new QListWidgetItem(headingOf(page), list_);
    item->setData(kNameRole, QString::fromLatin1(page));
  }
  text_ = named(new GuidePage(this), "guideText");
  text_->setOpenLinks(false);
  connect(text_, &QTextBrowser::anchorClicked, this, &Guide::follow);
  stack_ = new QStackedWidget(this);
  stack_->addWidget(shortcutsOf(window));
  stack_->addWidget(text_);
  connect(list_, &QListWidget::currentRowChanged, this, &Guide::choose);

  auto* splitter = new QSplitter(this);
  splitter->addWidget(list_);
  splitter->addWidget(stack_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({240, 760});
  wanted_ = named(new QLineEdit(this), "guideFind");
  wanted_->setPlaceholderText(tr("Find in all pages"));
  wanted_->setClearButtonEnabled(true);
  connect(wanted_, &QLineEdit::returnPressed, this, &Guide::findNext);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  // The return key is of the search.
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(wanted_, 1);
  bottom->addWidget(buttons);
  auto* column = new QVBoxLayout(this);
  column->addWidget(splitter, 1);
  column->addLayout(bottom);
}

QTableWidget* Guide::shortcutsOf(const QWidget* window) {
  auto* table = named(new QTableWidget(0, 2, this), "shortcutsTable");
  table->setHorizontalHeaderLabels({tr("Key or mouse"), tr("What it does")});
  table->verticalHeader()->hide();
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  const auto add = [table](const QString& keys, const QString& what) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(keys));
    table->setItem(row, 1, new QTableWidgetItem(what));
  };
  for (const QAction* action : window->findChildren<QAction*>())
    if (!action->shortcut().isEmpty())
      add(action->shortcut().toString(QKeySequence::NativeText), action->iconText());
  for (const auto& [keys, what] : paneShortcuts())
    add(QCoreApplication::translate("Shortcut", keys),
        QCoreApplication::translate("Shortcut", what));
  table->resizeColumnsToContents();
  table->horizontalHeader()->setStretchLastSection(true);
  return table;
}

void Guide::choose(int row) {
  const QString name = list_->item(row)->data(kNameRole).toString();
  stack_->setCurrentIndex(name.isEmpty() ? 0 : 1);
  if (!name.isEmpty()) text_->read(textOf(name));
}

void Guide::showPage(const QString& name) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(kNameRole).toString() == name) list_->setCurrentRow(row);
}

void Guide::follow(const QUrl& page) {
  if (page.scheme().startsWith(QLatin1String("http"))) {
    QDesktopServices::openUrl(page);
    return;
  }
  // Relative to the page that is open.
  const QString file = page.fileName();
  if (!file.isEmpty()) showPage(file.section('.', 0, 0));
  if (page.hasFragment()) text_->goTo(page.fragment());
}

void Guide::findNext() {
  const QString wanted = wanted_->text();
  if (wanted.isEmpty()) return;
  // From the cursor on, then through the other pages, and round to the head of this one.
  if (stack_->currentIndex() == 1 && text_->find(wanted)) return;
  for (int step = 1; step <= list_->count(); ++step) {
    const int row = (list_->currentRow() + step) % list_->count();
    if (row == 0) continue;
    if (!textOf(list_->item(row)->data(kNameRole).toString()).contains(wanted, Qt::CaseInsensitive))
      continue;
    if (row == list_->currentRow()) choose(row);
    list_->setCurrentRow(row);
    text_->moveCursor(QTextCursor::Start);
    if (text_->find(wanted)) return;
  }
}

void showGuide(QWidget* window, const QString& page) {
  auto* guide = window->findChild<Guide*>();
  if (!guide) guide = new Guide(window);
  guide->show();
  guide->raise();
  guide->showPage(page);
}

}  // namespace angiomesh
