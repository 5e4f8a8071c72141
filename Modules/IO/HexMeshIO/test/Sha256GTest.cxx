// Test vectors of FIPS 180-4 / NIST CAVP: exact.
#include "moserhex/HexMeshIO/Sha256.h"

#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{
std::string
digestOf(const std::string & text)
{
  Sha256 hash;
  hash.update(text.data(), text.size());
  return hash.hexDigest();
}
} // namespace

TEST(Sha256, EmptyMessage)
{
  EXPECT_EQ(digestOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OneBlockMessage)
{
  EXPECT_EQ(digestOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, TwoBlockMessage)
{
  EXPECT_EQ(digestOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, MillionLetters)
{
  EXPECT_EQ(digestOf(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheBytesAreCut)
{
  std::string text;
  for (int i = 0; i < 300; ++i)
  {
    text += static_cast<char>(i);
  }
  for (const std::size_t cut : { 1u, 55u, 56u, 63u, 64u, 65u, 128u, 299u })
  {
    Sha256 hash;
    hash.update(text.data(), cut);
    hash.update(text.data() + cut, text.size() - cut);
    EXPECT_EQ(hash.hexDigest(), digestOf(text)) << cut;
  }
}

TEST(Sha256, OfAFileIsThatOfItsBytes)
{
  const TestFolder folder;
  writeBytes(folder / "abc", "abc");
  EXPECT_EQ(sha256OfFile(folder / "abc"), digestOf("abc"));
}

TEST(Sha256, WhatIsNoRegularFileIsRefused)
{
  const TestFolder folder;
  EXPECT_THROW((void)sha256OfFile("/nonexistent/file"), BadInput);
  EXPECT_THROW((void)sha256OfFile(folder / "."), BadInput);
}
