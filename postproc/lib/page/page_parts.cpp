// SPDX-License-Identifier: GPL-2.0-or-later
// What the sections of a run's page are made of.
// Scope: see the header.
#include "page/page_parts.h"

#include "args/input_error.h"

namespace muckpile {

using check::Json;

namespace {

Json summary_of(const ResultFolder& folder) {
  const auto path = folder.file("summary.json");
  if (!std::filesystem::exists(path))
    refuse(path.string(), "is not there: measure the run first, with muckpile-post all");
  Json summary = check::read_json_object(path);
  const auto id = summary.find("run_id");
  const std::string found = id != summary.end() && id->is_string() ? id->get<std::string>() : "";
  if (found != folder.run_id())
    refuse(path.string(),
           "is of another run than dump/: measure the run anew, with muckpile-post all");
  return summary;
}

}  // namespace

PageContent page_content(const ResultFolder& folder) {
  return {folder, summary_of(folder), check::read_json_object(folder.dump("scene.json"))};
}

const Json* find(const PageContent& run, const std::string& key) {
  const auto found = run.summary.find(key);
  return found == run.summary.end() || found->is_null() ? nullptr : &*found;
}

std::string scene_value(const PageContent& run, const std::string& key) {
  const auto found = run.scene.find(key);
  return found == run.scene.end() ? std::string() : in_words(key, *found);
}

void add_figure(Html& page, const std::string& tag, const std::string& key, const Json& value) {
  page.element(tag, in_words(key, value),
               {{"class", value.is_number() ? "number" : "text"},
                {"data-key", key},
                {"data-value", value.dump()}});
}

void add_picture(Html& page, const PageContent& run, const std::string& file,
                 const std::string& heading, const std::string& caption) {
  const auto path = run.folder.file(file);
  if (!std::filesystem::exists(path)) return;
  if (!heading.empty()) page.element("h2", heading);
  const auto frame = page.open("figure");
  {
    const auto wide = page.open("div", {{"class", "wide"}});
    page.single("img", {{"alt", caption}, {"src", png_as_data_uri(path)}});
  }
  page.element("figcaption", caption);
}

void add_table(Html& page, const PageContent& run, const std::vector<NamedKey>& rows) {
  std::vector<NamedKey> there;
  for (const NamedKey& row : rows) {
    if (run.summary.contains(row.key)) there.push_back(row);
  }
  if (there.empty()) return;
  const auto table = page.open("table");
  for (const auto& [key, name] : there) {
    const auto row = page.open("tr");
    page.element("td", name);
    add_figure(page, "td", key, run.summary.at(key));
  }
}

const std::set<std::string>& provenance_keys() {
  static const std::set<std::string> keys{"run_id",    "version", "commit",       "compiler",
                                          "libraries", "ranks",   "command_line", "knobs"};
  return keys;
}

void add_rows(Html& page, const Json& object, const std::set<std::string>& left_out) {
  const auto table = page.open("table");
  for (const auto& [key, value] : object.items()) {
    if (left_out.contains(key)) continue;
    const auto row = page.open("tr");
    page.element("td", split_unit(key).name);
    page.element("td", in_words(key, value), {{"class", value.is_number() ? "number" : "text"}});
  }
}

}  // namespace muckpile
