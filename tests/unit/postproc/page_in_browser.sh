#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# page_in_browser.sh PAGE_OF_A_TEST: opens the page of a run in headless Chromium, 400, 1200 and 1700 px wide, light and dark.
# The page must load without a request, show its pictures, have no sideways scroll with all of it unfolded, and change its ground with the reader's scheme.
# Scope: skipped with exit status 77 where no Chromium is installed.
set -euo pipefail
make_page=$1
for browser in chromium chromium-browser google-chrome ''; do
  if [[ -z $browser ]]; then echo "SKIPPED, the page was not looked at: no Chromium (Debian: apt-get install chromium)" >&2 && exit 77; fi
  if command -v "$browser" >/dev/null; then break; fi
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$make_page" "$folder/run"

# A copy measures itself in a frame, as a window cannot be as narrow; the policy of the page itself allows no script.
script='<script>addEventListener("load", () => {
  document.querySelectorAll("details").forEach(d => d.open = true);
  const images = [...document.images];
  parent.postMessage([innerWidth, document.documentElement.scrollWidth <= innerWidth, images.length,
    images.every(i => i.naturalWidth > 0), getComputedStyle(document.body).backgroundColor].join(";"), "*"); });</script>'
sed -E -e '/Content-Security-Policy/d' "$folder/run/report.html" >"$folder/page.html"
printf '%s\n' "$script" >>"$folder/page.html"

seen() {  # seen WIDTH SCHEME (0 dark, 1 light)
  printf '<html><body><script>addEventListener("message", e => document.documentElement.setAttribute("data-seen", e.data));</script>
    <iframe src="page.html" width="%s" height="900" frameborder="0"></iframe></body></html>\n' "$1" >"$folder/frame.html"
  HOME=$folder timeout 100 "$browser" --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars \
    --user-data-dir="$folder/profile" --host-resolver-rules='MAP * ~NOTFOUND' --blink-settings=preferredColorScheme="$2" \
    --window-size="1800,1000" --virtual-time-budget=4000 --dump-dom "file://$folder/frame.html" 2>"$folder/messages" |
    grep -oE 'data-seen="[^"]*"' | head -n 1
}

wrong=0
expect() {  # expect WIDTH SCHEME GROUND
  local found
  found=$(seen "$1" "$2") || true
  echo "width $1, scheme $2: $found"
  [[ $found == "data-seen=\"$1;true;5;true;$3\"" ]] || { echo "  should be $1;true;5;true;$3" && wrong=1; }
}
expect 400 1 'rgb(246, 247, 248)'
expect 1200 1 'rgb(246, 247, 248)'
expect 1700 1 'rgb(246, 247, 248)'
expect 400 0 'rgb(21, 24, 27)'
expect 1200 0 'rgb(21, 24, 27)'
if grep -qiE 'src="(http|//)|url\(' "$folder/run/report.html"; then echo "the page asks for something outside" && wrong=1; fi
exit "$wrong"
