// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>

#include "myoface/muscle/response.h"

#include "theme.h"

namespace myoface {

/// Settings that outlive the window, typed.
struct Settings {
    QString language;  ///< "", "en", "ja"
    Theme theme = Theme::Dark;
    ResponseForm response = ResponseForm::Smooth;

    static Settings read();
    void write() const;
};

/// A muscle's response along and across its fibre, as curves.
class ResponsePlot final : public QWidget {
    Q_OBJECT

public:
    explicit ResponsePlot(QWidget* parent = nullptr);
    void setForm(ResponseForm form);
    QSize sizeHint() const override { return {440, 190}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ResponseForm m_form = ResponseForm::Smooth;
};

/// Language, theme, and the method that muscles are computed by. Everything acts at once.
class Preferences final : public QDialog {
    Q_OBJECT

public:
    explicit Preferences(const Settings& settings, QWidget* parent = nullptr);

Q_SIGNALS:
    void edited(const myoface::Settings& settings);

private:
    QWidget* lookPage();
    QWidget* methodPage();

    Settings m_settings;
};

}  // namespace myoface
