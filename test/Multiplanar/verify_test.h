// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_VERIFY_TEST_H
#define MULTIPLANAR_TEST_VERIFY_TEST_H

#include "verify_fixture_files.h"

#include "verify.h"

#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <stdexcept>

/// Running the verifier on boxes made by hand, with faults planted.
namespace verify_test {

using namespace verify_fixture;
namespace fs = std::filesystem;

struct Outcome
{
  int code;
  std::string text;

  int lines(const std::string& prefix) const
  {
    int n = 0;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) n += line.compare(0, prefix.size(), prefix) == 0;
    return n;
  }
  bool has_line(const std::string& pattern) const
  {
    const std::regex regex(pattern);
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, regex)) return true;
    return false;
  }
};

class Verify : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    dir = fs::path(testing::TempDir()) / (std::string("multiplanar_") + info->test_suite_name() + "_" + info->name());
    fs::remove_all(dir);
  }
  void TearDown() override { fs::remove_all(dir); }

  Outcome run() const
  {
    std::ostringstream out;
    const int code = CGAL::Multiplanar::verify(dir, out);
    return {code, out.str()};
  }

  static Json complete(Joints joints)
  {
    Json model = make_box(joints);
    if (joints == Joints::connectors) add_assembly(model);
    add_sheets(model);
    return model;
  }

  void expect_good() const
  {
    const Outcome outcome = run();
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(outcome.lines("violation:"), 0);
    EXPECT_TRUE(outcome.has_line("Everything that is claimed holds")) << outcome.text;
  }

  void expect_line(int code, const std::string& pattern) const
  {
    const Outcome outcome = run();
    EXPECT_EQ(outcome.code, code) << outcome.text;
    EXPECT_TRUE(outcome.has_line("^" + pattern)) << "expected: " << pattern << "\n" << outcome.text;
    EXPECT_FALSE(outcome.has_line("Everything that is claimed holds"));
  }

  /// The box with connectors, with a fault planted into model.json before anything is drawn: drawings agree with it.
  void expect_fault(const std::function<void(Json&)>& plant, const std::string& pattern,
                    Joints joints = Joints::connectors)
  {
    Json model = complete(joints);
    plant(model);
    write_all(dir, model);
    expect_line(1, "violation: " + pattern);
  }

  /// The same, with the fault planted into a written file.
  void expect_fault_in_file(const std::string& file, const std::function<void(std::string&)>& plant, int code,
                            const std::string& pattern)
  {
    write_all(dir, complete(Joints::connectors));
    std::string text = read_text(dir / file);
    const std::string before = text;
    plant(text);
    ASSERT_NE(text, before);
    write_text(dir / file, text);
    expect_line(code, pattern);
  }

  fs::path dir;
};

inline Json& thing(Json& model, const char* list, const std::string& id)
{
  for (Json& entry : model[list])
    if (entry["id"] == id) return entry;
  throw std::logic_error(id);
}

inline void set_outline(Json& part, const Ring& outline)
{
  part["outline"] = outline;
  double a = area(outline);
  for (const Json& hole : part["holes"]) a -= std::abs(area(hole.get<Ring>()));
  part["area"] = a;
}

inline Ring scaled(const Ring& ring, double factor)
{
  Flat c = {0, 0};
  for (const Flat& p : ring) c = {c[0] + p[0] / ring.size(), c[1] + p[1] / ring.size()};
  Ring result;
  for (const Flat& p : ring) result.push_back({c[0] + factor * (p[0] - c[0]), c[1] + factor * (p[1] - c[1])});
  return result;
}

inline void replace(std::string& text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
}

} // namespace verify_test

#endif // MULTIPLANAR_TEST_VERIFY_TEST_H
