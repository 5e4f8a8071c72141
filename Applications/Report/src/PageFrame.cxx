#include "PageFrame.h"

#include "HtmlText.h"
#include "PageName.h"
#include "ReportAssets.h"

namespace moserhex::app
{

std::string
pageText(const PageFrame & frame)
{
  requirePagesFor(frame.title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
         "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; script-src "
         "'unsafe-inline'; img-src data: blob:\">\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\">\n<title>" +
         escapeHtml(frame.title) + "</title>\n<style>" + reportAssets()->style +
         "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n<header "
         "class=\"page-head\">\n<p class=\"brand\">MoserHex</p>\n<h1>" +
         escapeHtml(frame.heading) + "</h1>\n<p class=\"subtitle\">" + escapeHtml(frame.subtitle) +
         "</p>\n</header>\n<main id=\"content\">\n" + frame.body + "</main>\n<footer class=\"page-foot\">\n" +
         frame.footer + "</footer>\n<script>" + frame.script + "</script>\n</body>\n</html>\n";
}

std::string
dataElement(const std::string & id, const std::string & json)
{
  return "<script type=\"application/json\" id=\"" + id + "\">" + escapeScriptJson(json) + "</script>\n";
}

std::string
section(const std::string & id, const std::string & heading, const std::string & content)
{
  return "<section id=\"" + id + "\" aria-labelledby=\"" + id + "-heading\">\n<h2 id=\"" + id + "-heading\">" +
         escapeHtml(heading) + "</h2>\n" + content + "</section>\n";
}

std::string
licenceDetails()
{
  return std::string("<details class=\"licence\"><summary>The 3-D view uses three.js ") +
         escapeHtml(reportAssets()->threeVersion) + ", MIT licence</summary><pre>" +
         escapeHtml(reportAssets()->threeLicence) + "</pre></details>\n";
}

} // namespace moserhex::app
