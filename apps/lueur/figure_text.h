// SPDX-License-Identifier: MIT
// The tables of a page of figures for a terminal.
#pragma once

#include <string>

#include "report/figure_page.h"

namespace lueur::cli {

// Titles, paragraphs and tables; pictures and plots are left out.
std::string figure_text(const report::FigurePage& page);

}  // namespace lueur::cli
