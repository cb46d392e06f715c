// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command all of muckpile-post.
// Scope: see the header.
#include "all_command.h"

#include <cstdio>
#include <memory>
#include <string>

#include "command_words.h"
#include "report/all_reports.h"
#include "report/not_measurable.h"

namespace muckpile {
namespace {

struct AllWords {
  std::string folder;
  bool vtk = false;  // series too
};

void say(const std::string& text) {
  std::printf("muckpile-post: %s\n", text.c_str());
  std::fflush(stdout);  // ahead of what comes on standard error
}

// A report that has no measures for the scene is no failure of the others.
void report_all(const std::string& path, bool vtk) {
  const ResultFolder folder(path);
  std::string refused;
  for (const std::string& name : reports_of(folder, vtk)) {
    say(name + " " + path);
    try {
      make_report(folder, name);
    } catch (const NotMeasurable& refusal) {
      tell(refusal);
      refused += " " + name;
    }
  }
  say("results in " + path);
  std::fputs(summary_lines(folder).c_str(), stdout);
  for (const auto& picture : pictures_in(folder)) say("picture " + picture.string());
  say("page " + folder.file("report.html").string());
  if (!refused.empty()) {
    say("not measured:" + refused + "; the reason is above and in " +
        folder.file("summary.json").string());
  }
}

}  // namespace

void add_all_command(CLI::App& app) {
  const auto o = std::make_shared<AllWords>();
  CLI::App* all = add_command(
      app, "all", "what fits the scene of those above, and the key figures on the screen",
      o->folder);
  all->add_flag("--vtk", o->vtk, "also series, the snapshots as polyhedra for ParaView");
  all->callback([o] { report_all(o->folder, o->vtk); });
}

}  // namespace muckpile
