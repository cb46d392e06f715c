// SPDX-License-Identifier: GPL-2.0-or-later
#include "large_pages.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace muckpile {

void start_with_large_pages([[maybe_unused]] char** argv) {
#ifdef __GLIBC__
  constexpr int kKeep = 0;  // of setenv: a value that is there stays
  if (std::getenv("GLIBC_TUNABLES") != nullptr) return;
  (void)::setenv("GLIBC_TUNABLES", "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864", kKeep);
  std::error_code unread;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unread);
  if (!unread) (void)::execv(program.c_str(), argv);
#endif
}

}  // namespace muckpile
