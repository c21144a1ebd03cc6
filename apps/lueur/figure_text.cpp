// SPDX-License-Identifier: MIT
#include "figure_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "console.h"

namespace lueur::cli {
namespace {

// Columns a terminal counts: one for each character, not for each byte of UTF-8.
size_t width_of(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, size_t width, bool left) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return left ? text + space : space + text;
}

std::string cell_text(const report::Cell& cell, int digits) {
  if (const auto* text = std::get_if<std::string>(&cell)) return printable(*text);
  if (const auto* number = std::get_if<double>(&cell)) {
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "%.*f", digits, *number);
    return std::isfinite(*number) ? buffer : "-";
  }
  return "-";
}

// Decimals with which the column's largest number has the digits that it asks for.
int decimals_of(const report::Table& table, size_t column) {
  double most = 0.0;
  for (const auto& row : table.rows)
    if (const auto* number = std::get_if<double>(&row[column]))
      if (std::isfinite(*number)) most = std::max(most, std::abs(*number));
  const int whole = most >= 1.0 ? static_cast<int>(std::log10(most)) + 1 : 1;
  return std::clamp(table.columns[column].digits - whole, 0, 6);
}

std::string table_text(const report::Table& table) {
  // All cells as text, the two lines of headings first.
  std::vector<std::vector<std::string>> lines(2);
  for (const report::Column& column : table.columns) {
    lines[0].push_back(printable(column.group));
    lines[1].push_back(printable(column.heading) +
                       (column.unit.empty() ? "" : " " + printable(column.unit)));
  }
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (size_t c = 0; c < row.size(); ++c)
      lines.back().push_back(cell_text(row[c], decimals_of(table, c)));
  }
  std::string text;
  for (const auto& line : lines) {
    for (size_t c = 0; c < line.size(); ++c) {
      size_t width = 0;
      for (const auto& other : lines) width = std::max(width, width_of(other[c]));
      text += "  " + padded(line[c], width, c == 0);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string figure_text(const report::FigurePage& page) {
  std::string text = printable(page.title) + "\n";
  for (const auto& [name, value] : page.facts)
    text += "  " + printable(name) + ": " + printable(value) + "\n";
  for (const report::FigureSection& section : page.sections) {
    text += "\n" + printable(section.title) + "\n";
    for (const report::Block& block : section.blocks) {
      if (const auto* paragraph = std::get_if<report::Paragraph>(&block))
        text += "  " + printable(paragraph->text) + "\n";
      if (const auto* table = std::get_if<report::Table>(&block))
        text += "\n  " + printable(table->caption) + "\n" + table_text(*table);
    }
  }
  return text;
}

}  // namespace lueur::cli
