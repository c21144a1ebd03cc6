// SPDX-License-Identifier: MIT
#include "report/page.h"

#include "report/text.h"

namespace lueur::report {

std::string page_html(const Page& page) {
  std::string html = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
)";
  html += "<title>" + html_escaped(page.title) + "</title>\n<style>\n";
  for (const std::string_view style : page.styles) html += style;
  html += "</style>\n</head>\n<body>\n";
  html += page.skeleton;
  html +=
      "<script type=\"application/json\" id=\"data\">" + json_for_script(page.data) + "</script>\n";
  for (size_t i = 0; i < page.packed_pictures.size(); ++i)
    html += "<script type=\"text/plain\" id=\"picture-" + std::to_string(i) + "\">" +
            page.packed_pictures[i] + "</script>\n";
  html += "<script type=\"module\">\n";
  for (const std::string_view script : page.scripts) html += script;
  html += "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace lueur::report
