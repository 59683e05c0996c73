// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What `make` asks of the verifier before it hands a folder over.

#include "failure.h"
#include "proof.h"
#include "verify_test.h"

namespace {

using namespace verify_test;

using Proof = Verify;

TEST_F(Proof, good_parts_are_handed_over)
{
  write_all(dir, complete(Joints::connectors));
  EXPECT_NO_THROW(require_proof(dir.string(), "out"));
}

TEST_F(Proof, broken_parts_are_not)
{
  Json model = complete(Joints::connectors);
  Json& part = thing(model, "parts", "P05");
  set_outline(part, scaled(part["outline"].get<Ring>(), 1.05));
  write_all(dir, model);
  try {
    require_proof(dir.string(), "out/bunny");
    FAIL();
  } catch (const Failure& failure) {
    const std::string text = failure.what();
    EXPECT_EQ(failure.code, exit_broken_promise);
    EXPECT_EQ(text.find("out/bunny: the parts break what is promised ("), 0u) << text;
    EXPECT_NE(text.find("P05"), std::string::npos) << text;
    EXPECT_NE(text.find("nothing was written"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST_F(Proof, what_cannot_be_read_is_not)
{
  write_all(dir, complete(Joints::connectors));
  write_text(dir / "model.json", read_text(dir / "model.json").substr(0, 500));
  EXPECT_THROW(require_proof(dir.string(), "out"), Failure);
}

} // namespace
