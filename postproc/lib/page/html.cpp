// SPDX-License-Identifier: GPL-2.0-or-later
// Text of an HTML page.
// Scope: see the header.
#include "page/html.h"

#include <vtkBase64Utilities.h>

#include <fstream>
#include <iterator>

#include "args/input_error.h"

namespace muckpile {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        // XML knows no other control characters.
        out += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

void Html::start(const std::string& tag, HtmlAttributes attributes) {
  text_ += "<" + tag;
  for (const auto& [name, value] : attributes)
    text_ += std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

Html::Open Html::open(const std::string& tag, HtmlAttributes attributes) {
  start(tag, attributes);
  text_ += ">\n";
  return {*this, tag};
}

void Html::element(const std::string& tag, const std::string& text, HtmlAttributes attributes) {
  start(tag, attributes);
  text_.append(">").append(escaped(text)).append("</").append(tag).append(">\n");
}

void Html::single(const std::string& tag, HtmlAttributes attributes) {
  start(tag, attributes);
  text_ += "/>\n";
}

std::string png_as_data_uri(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(path.string(), "cannot be opened");
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  // The signature, and the name of the last chunk before its check sum.
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 16 ||
      bytes.compare(bytes.size() - 8, 4, "IEND") != 0)
    refuse(path.string(), "is no whole PNG file");
  std::vector<unsigned char> coded(2 * bytes.size() + 4);
  const auto length =
      vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
                                 static_cast<unsigned long>(bytes.size()), coded.data());
  return "data:image/png;base64," +
         std::string(coded.begin(), coded.begin() + static_cast<long>(length));
}

}  // namespace muckpile
