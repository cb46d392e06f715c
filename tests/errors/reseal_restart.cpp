// SPDX-License-Identifier: GPL-2.0-or-later
// reseal_restart FILE: puts the seal anew that fixes/engine/restart_seal.cpp puts behind a restart
// file, so that a test can change what is before it. Scope: files with a seal.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "provenance/fingerprint.h"

int main(int argc, char** argv) {
  constexpr std::size_t kSeal = 24;  // mark, length, hash
  if (argc != 2) return 2;
  std::ifstream in(argv[1], std::ios::binary);
  std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (bytes.size() < kSeal) return 1;
  const std::size_t before = bytes.size() - kSeal;
  const std::uint64_t length = before;
  const std::uint64_t hash = muckpile::Fingerprint().add_bytes(bytes.data(), before).value();
  std::memcpy(bytes.data() + before + 8, &length, sizeof(length));
  std::memcpy(bytes.data() + before + 16, &hash, sizeof(hash));
  std::ofstream out(argv[1], std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return out ? 0 : 1;
}
