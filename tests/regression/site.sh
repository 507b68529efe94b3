#!/bin/bash
# The site of the documents (etc/makeDocs): it is built without a broken link, and broken links are
# errors. Skipped where mkdocs or KaTeX is not installed
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

said=$(etc/makeDocs 2>&1)
case $? in
    0) echo "PASS site";;
    2) echo "SKIP site ${said//$'\n'/; }"; exit;;
    *) echo "FAIL site ${said//$'\n'/; }"; exit;;
esac

if grep -q 'class="arithmatex"' platforms/docs/docs/theory.html \
    && [[ -s platforms/docs/katex/katex.min.js ]]; then echo "PASS siteFormulas"
else
    echo "FAIL siteFormulas docs/theory.md has no formula on its page, or KaTeX is not beside it"
fi

# A copy with a page of its own, whose link is broken
d=docs
copy=$(mktemp -d); trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/etc" "$copy/docs"
cp etc/makeDocs "$copy/etc"
sed '/^nav:/,/^$/d' docs/mkdocs.yml >"$copy/docs/mkdocs.yml"
broken()    # LINK
{
    echo "# A" >"$copy/$d/a.md"
    echo "[a]($d/a.md#a) $1" >"$copy/README.md"
    said=$("$copy/etc/makeDocs" 2>&1)
}
if ! broken ""; then echo "FAIL siteLinks a sound copy is refused: ${said//$'\n'/; }"
elif broken "[b]($d/b.md)" || [[ $said != *"$d/b.md"* ]]
then echo "FAIL siteLinks a link to a file that is not there passes"
elif broken "[b]($d/a.md#b)" || [[ $said != *a.html#b* ]]
then echo "FAIL siteLinks a link to a heading that is not there passes"
else echo "PASS siteLinks"; fi
