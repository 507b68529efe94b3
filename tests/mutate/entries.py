# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries of an OpenFOAM dictionary with their places in its text"""
import re
from dataclasses import dataclass, field

TOKEN = re.compile(r'''
    (?P<skip>\s+|//[^\n]*|/\*.*?\*/)
  | (?P<verbatim>\#\{.*?\#\})
  | (?P<string>"(?:\\.|[^"\\])*")
  | (?P<mark>[{}()\[\];])
  | (?P<word>[^\s{}()\[\];"]+(?:\([^\s(){};]*\))?)
''', re.S | re.X)
NUMBER = re.compile(r'[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$')


@dataclass
class Token:
    kind: str
    text: str
    begin: int
    end: int

    @property
    def number(self):
        return self.kind == 'word' and bool(NUMBER.match(self.text))

    @property
    def plain(self):
        """A word that is neither number nor macro"""
        return self.kind == 'word' and not self.number and self.text[0] not in '$#'


@dataclass
class Entry:
    path: str                   # walls/motion/gate
    name: Token
    # tokens between name and ; or all of a block with its braces
    value: list = field(default_factory=list)
    end: int = 0                # of the entry with its ; or }
    block: bool = False


def tokens(text):
    found, at = [], 0
    while at < len(text):
        m = TOKEN.match(text, at)
        if not m:
            raise ValueError('no token at %r' % text[at:at + 20])
        if m.lastgroup != 'skip':
            found.append(Token(m.lastgroup, m.group(), m.start(), m.end()))
        at = m.end()
    return found


def entries(text):
    """All entries, those of sub-dictionaries after their own, without the header"""
    found = []
    readBlock(tokens(text), 0, '', found, text)
    return [e for e in found if e.path.split('/')[0] != 'FoamFile']


def readBlock(all, i, path, found, text):
    """\\return index of the token that ends the block, } or ), or len(all)"""
    while i < len(all) and all[i].text not in ('}', ')'):
        name = all[i]
        if name.text[0] == '#':         # directive: to the end of its line
            line = text.find('\n', name.begin)
            while i < len(all) and all[i].begin < line:
                i += 1
            continue
        if name.kind not in ('word', 'string') or name.text[0] == '$':
            i += 1
            continue
        e = Entry(path + name.text.strip('"'), name)
        found.append(e)
        first = i = i + 1
        if i < len(all) and all[i].text == '{':
            e.block = True
            i = min(readBlock(all, i + 1, e.path + '/', found, text), len(all) - 1)
        else:
            depth = 0
            while i < len(all) and (depth or all[i].text not in (';', '}')):
                depth += {'(': 1, ')': -1, '[': 1, ']': -1}.get(all[i].text, 0)
                # regions ( column { ... } ... )
                if depth and all[i].plain and i + 1 < len(all) and all[i + 1].text == '{':
                    i = readBlock(all, i, e.path + '/', found, text)
                    continue
                i += 1
        i = min(i, len(all) - 1)
        e.value = all[first:i + 1] if e.block else all[first:i]
        e.end = all[i].end
        i += 1
    return i
