// SPDX-License-Identifier: GPL-2.0-or-later
// Text of an HTML page that is well-formed XML, too: elements are closed in the order in which they
// were opened, and every text is escaped.
// Scope: building only; what a page says is run_page's.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace muckpile {

using HtmlAttributes = std::initializer_list<std::pair<const char*, std::string>>;

class Html {
 public:
  // An element stays open as long as the value lives.
  class Open {
   public:
    Open(Html& page, std::string tag) : page_(page), tag_(std::move(tag)) {}
    ~Open() { page_.text_ += "</" + tag_ + ">\n"; }
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;

   private:
    Html& page_;
    std::string tag_;
  };

  [[nodiscard]] Open open(const std::string& tag, HtmlAttributes attributes = {});
  // With text inside.
  void element(const std::string& tag, const std::string& text, HtmlAttributes attributes = {});
  // Without content, e.g. an image.
  void single(const std::string& tag, HtmlAttributes attributes);
  // Not escaped: style sheets, and drawings made here.
  void raw(const std::string& text) { text_ += text; }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void start(const std::string& tag, HtmlAttributes attributes);
  std::string text_;
};

std::string escaped(const std::string& text);

// The file's bytes as a data URI. Throws InputError if it is no PNG file that has its end.
std::string png_as_data_uri(const std::filesystem::path& path);

}  // namespace muckpile
