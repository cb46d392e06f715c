// SPDX-License-Identifier: GPL-2.0-or-later
// What the sections of a run's page are made of: its files, a figure, a picture, tables.
// Scope: run_page says which of them stand where.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "io/result_folder.h"
#include "page/figures_table.h"
#include "page/html.h"

namespace muckpile {

struct PageContent {
  const ResultFolder& folder;
  check::Json summary, scene;
};

// Throws InputError where summary.json is absent, of another run or no summary.
PageContent page_content(const ResultFolder& folder);

// Nothing where the summary has no such figure, or no value of it.
const check::Json* find(const PageContent& run, const std::string& key);
// In words; "" where the scene does not have it.
std::string scene_value(const PageContent& run, const std::string& key);

// Every figure of the summary on the page carries its key and its exact value.
void add_figure(Html& page, const std::string& tag, const std::string& key,
                const check::Json& value);

// Nothing where the folder does not have it. An empty heading is left out.
void add_picture(Html& page, const PageContent& run, const std::string& file,
                 const std::string& heading, const std::string& caption);

// Rows of those of the keys that the summary has.
void add_table(Html& page, const PageContent& run, const std::vector<NamedKey>& rows);

// Rows of an object's keys but for some.
void add_rows(Html& page, const check::Json& object, const std::set<std::string>& left_out);

// What the program adds behind the numbers and words of the scene.
const std::set<std::string>& provenance_keys();

}  // namespace muckpile
