// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_runner.h"

#include <nlohmann/json.hpp>

// Meshes that other people made, from model to parts: the promises hold on all of them, as the verifier sees it.
// MULTIPLANAR_CGAL_DATA names the folder of libcgal-demo's data; every OFF file in the folder that
// MULTIPLANAR_TEST_MESHES names is taken as well.

using namespace Multiplanar_test;
using nlohmann::json;

namespace {

struct Corpus_mesh
{
  const char* name;
  int panels; ///< k
};

void PrintTo(const Corpus_mesh& m, std::ostream* out) { *out << m.name; }

class Program_corpus : public Program_test
{
protected:
  void expect_promises(const std::string& mesh, int k) const
  {
    SCOPED_TRACE(mesh);
    const Outcome made = run({"make", mesh, "-o", path("out"), "-k", std::to_string(k), "--effort", "fast", "--quiet"});
    ASSERT_EQ(made.code, 0) << made.err;
    const Outcome verified = run({"verify", path("out")});
    EXPECT_EQ(verified.code, 0) << verified.out;
    const json model = json::parse(content(path("out/model.json"))),
               report = json::parse(content(path("out/report.json")));
    EXPECT_LE(model["panels"].size(), std::size_t(k));
    EXPECT_GE(model["panels"].size(), 4u);
    EXPECT_LE(report["accuracy"]["planarity_deviation"], 1e-9 * double(report["input"]["diagonal"]));
    // What was given up is said, and where.
    for (const std::string warning : report["warnings"])
      if (warning.find("the mesh could not be moved") != std::string::npos)
        EXPECT_NE(warning.find("near ("), std::string::npos) << warning;
  }
};

class Cgal_mesh : public Program_corpus, public ::testing::WithParamInterface<Corpus_mesh>
{
};

TEST_P(Cgal_mesh, KeepsAllPromises)
{
  const char* folder = std::getenv("MULTIPLANAR_CGAL_DATA");
  if (!folder) GTEST_SKIP() << "MULTIPLANAR_CGAL_DATA names no folder";
  expect_promises(std::string(folder) + "/meshes/" + GetParam().name, GetParam().panels);
}

INSTANTIATE_TEST_SUITE_P(Corpus, Cgal_mesh,
                         ::testing::Values(Corpus_mesh{"tetrahedron.off", 4}, Corpus_mesh{"cube.off", 6},
                                           Corpus_mesh{"star.off", 24}, Corpus_mesh{"3torus.off", 40},
                                           Corpus_mesh{"P.off", 30}, Corpus_mesh{"mpi.off", 30},
                                           Corpus_mesh{"blob-closed.off", 40}, Corpus_mesh{"dragknob.off", 40},
                                           Corpus_mesh{"part.off", 40}, Corpus_mesh{"joint.off", 40},
                                           Corpus_mesh{"eight.off", 40}, Corpus_mesh{"blobby.off", 40},
                                           Corpus_mesh{"knot1.off", 60}, Corpus_mesh{"homer.off", 50}));

TEST_F(Program_corpus, EveryMeshOfAFolder)
{
  const char* meshes = std::getenv("MULTIPLANAR_TEST_MESHES");
  if (!meshes) GTEST_SKIP() << "MULTIPLANAR_TEST_MESHES names no folder";
  int found = 0;
  for (const auto& entry : fs::directory_iterator(meshes)) {
    if (entry.path().extension() != ".off" || fs::file_size(entry) > 1000000) continue;
    expect_promises(entry.path().string(), 50);
    ++found;
  }
  EXPECT_GT(found, 0) << meshes;
}

} // namespace
