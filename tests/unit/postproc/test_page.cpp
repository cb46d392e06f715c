// SPDX-License-Identifier: GPL-2.0-or-later
// The page of a run: well-formed, self-contained, with every figure of the summary.
// Scope: page/ on a made-up bench; page_in_browser.sh opens a page in a browser.
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <map>

#include "args/input_error.h"
#include "page/figures_table.h"
#include "page/html.h"
#include "page/run_page.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

vtkSmartPointer<vtkXMLDataElement> parsed(const std::string& page) {
  return vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(page.c_str()));
}

// Calls visit for an element and all in it.
template <class Visit>
void each_element(vtkXMLDataElement* element, const Visit& visit) {
  visit(element);
  for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
    each_element(element->GetNestedElement(k), visit);
}

std::string attribute(vtkXMLDataElement* element, const char* name) {
  const char* value = element->GetAttribute(name);
  return value == nullptr ? std::string() : std::string(value);
}

class Page : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(temporary_.path());
    report_profile(folder(), {kCube, 0.125}, {});
    report_fragments(folder(), {kCube, {}});
    report_energy(folder());
  }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  void expect_refused(const std::string& part) const {
    try {
      (void)page_of(folder());
      FAIL() << "made";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  TemporaryFolder temporary_;
};

TEST_F(Page, ShowsEveryFigureOfTheSummary) {
  const auto root = parsed(page_of(folder()));
  ASSERT_NE(root, nullptr) << "not well-formed";
  std::multimap<std::string, std::pair<std::string, std::string>> shown;  // key: value, words
  each_element(root, [&](vtkXMLDataElement* element) {
    const char* words = element->GetCharacterData();
    if (element->GetAttribute("data-key") != nullptr)
      shown.insert({attribute(element, "data-key"),
                    {attribute(element, "data-value"), words == nullptr ? "" : words}});
  });
  const auto summary = read_json_object(folder().file("summary.json"));
  for (const auto& [key, value] : summary.items())
    EXPECT_TRUE(shown.contains(key)) << key << " is not on the page";
  EXPECT_GE(shown.count("throw_cg_m"), 2U);  // among the key figures and among all
  for (const auto& [key, figure] : shown) {
    EXPECT_EQ(figure.first, summary.at(key).dump()) << key;
    EXPECT_EQ(figure.second, in_words(key, summary.at(key))) << key;
  }
}

TEST_F(Page, FetchesNothing) {
  report_movement(folder(), {kCube, 0.125}, {});
  const auto root = parsed(page_of(folder()));
  ASSERT_NE(root, nullptr);
  int pictures = 0;
  each_element(root, [&](vtkXMLDataElement* element) {
    const std::string tag = element->GetName();
    EXPECT_NE(tag, "script");
    EXPECT_NE(tag, "link");
    EXPECT_EQ(attribute(element, "href"), "");
    if (tag != "img") return;
    ++pictures;
    EXPECT_TRUE(attribute(element, "src").starts_with("data:image/png;base64,iVBOR"));
    EXPECT_FALSE(attribute(element, "alt").empty());
  });
  EXPECT_EQ(pictures, 5);  // profile, face velocity, movement, fragments, energy
}

TEST_F(Page, SaysWhatDoesNotHold) {
  EXPECT_EQ(page_of(folder()).find("STILL MOVING"), std::string::npos);
  std::string text = text_of(folder().dump("run.json"));
  write_text(folder().dump("run.json"), text.replace(text.find("true"), 4, "false"));
  report_profile(folder(), {kCube, 0.125}, {});
  const std::string page = page_of(folder());
  EXPECT_NE(page.find("STILL MOVING"), std::string::npos);
  EXPECT_EQ(page.find("Height of the pile"), std::string::npos);  // null: no key figure
}

TEST_F(Page, SaysWhatTheAuditMissesAndWhatTheGasLost) {
  auto run = read_json_object(folder().dump("run.json"));
  run["energy_audit_J"] = {
      {"explosive", 1e7}, {"rock_heat", 5e6}, {"vented", 2e6}, {"wall_work", 2.8e6}};
  run["energy_audit_error"] = 0.02;
  write_text(folder().dump("run.json"), run.dump());
  report_profile(folder(), {kCube, 0.125}, {});
  report_energy(folder());
  const std::string page = page_of(folder());
  for (const std::string& said :
       {"Gas gave " + in_words("_share", 0.5) + " of", "took " + in_words("_share", 0.2) + " of",
        std::string("not accounted for"), in_words("_J", 2e5)})
    EXPECT_NE(page.find(said), std::string::npos) << said;
  const std::string warning = "class=\"warning\">Audit of the explosive's energy: ";
  EXPECT_NE(page.find(warning), std::string::npos);
  run["energy_audit_error"] = -0.009;
  write_text(folder().dump("run.json"), run.dump());
  report_profile(folder(), {kCube, 0.125}, {});
  const std::string closed = page_of(folder());
  EXPECT_EQ(closed.find(warning), std::string::npos);
  EXPECT_NE(closed.find("energy misses " + in_words("_fraction", -0.009)), std::string::npos);
}

TEST_F(Page, EscapesTheTextsOfARun) {
  std::string text = text_of(folder().dump("scene.json"));
  text.insert(1, R"("explosive": "a<b>&\"c\"", )");
  write_text(folder().dump("scene.json"), text);
  const std::string page = page_of(folder());
  ASSERT_NE(parsed(page), nullptr);
  EXPECT_NE(page.find("a&lt;b&gt;&amp;&quot;c&quot;"), std::string::npos);
}

TEST_F(Page, NeedsTheSummaryOfItsOwnRun) {
  const std::string summary = text_of(folder().file("summary.json"));
  std::filesystem::remove(folder().file("summary.json"));
  expect_refused("summary.json: is not there");
  write_text(folder().file("summary.json"), summary.substr(0, summary.size() / 2));
  expect_refused("summary.json: ");
  write_text(folder().file("summary.json"), R"({"run_id": "812b0b01e8ba37ac"})");
  expect_refused("is of another run than dump/");
}

TEST_F(Page, RefusesACutPicture) {
  const std::string bytes = text_of(folder().file("energy.png"));
  write_text(folder().file("energy.png"), bytes.substr(0, bytes.size() - 20));
  expect_refused("energy.png: is no whole PNG file");
}

TEST(InWords, RoundsAndNamesTheUnit) {
  EXPECT_EQ(in_words("throw_cg_m", 18.669), "18.7\u202fm");
  EXPECT_EQ(in_words("explosive_energy_J", 1.6585e8), "166\u202fMJ");
  EXPECT_EQ(in_words("beyond_toe_fraction", 0.8383), "83.8\u202f%");
  EXPECT_EQ(in_words("repose_angle_deg", 41.309), "41.3°");
  EXPECT_EQ(in_words("blocks", 10634), "10\u202f634");
  EXPECT_EQ(in_words("pile_mass_kg", 1234567.4), "1\u202f234\u202f567\u202fkg");
  EXPECT_EQ(in_words("rock_density_kg_m3", 2650), "2\u202f650\u202fkg/m³");
  EXPECT_EQ(in_words("energy_audit_J.vented", 2500.0), "2.5\u202fkJ");
  EXPECT_EQ(in_words("still", true), "yes");
  EXPECT_EQ(in_words("swell_factor", nullptr), "none");
  EXPECT_EQ(split_unit("face_velocity_m_s").name, "face velocity");
}

}  // namespace
}  // namespace muckpile
