# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM dictionaries as nested Python dictionaries of strings.

Reads what foamDictionary writes and what people write by hand: comments, sub-dictionaries, lists
(kept as one string), #include and #includeIfPresent of a file beside it; $name is replaced by an
entry or sub-dictionary seen before.
"""
import os
import re

_token = re.compile(r'"[^"]*"|[{}();]|[^\s{}();"]+')


def readDictionary(path, text=None):
    """Nested dictionary of the file at path, or of this text; values are strings, lists keep their
    brackets"""
    return _parse(iter(_token.findall(_text(path, text))), {})


def numberOf(text, default=None):
    """The last number of an entry: 'rho [1 -3 0 0 0 0 0] 1000' and '1000' both give 1000"""
    numbers = re.findall(r'[-+]?\d*\.?\d+(?:[eE][-+]?\d+)?', re.sub(r'\[[^\]]*\]', ' ', text or ''))
    return float(numbers[-1]) if numbers else default


def entry(dictionary, path, default=None):
    """Entry at 'walls/model', or default"""
    for word in path.split('/'):
        if not isinstance(dictionary, dict) or word not in dictionary:
            return default
        dictionary = dictionary[word]
    return dictionary


def _text(path, text=None):
    if text is None:
        with open(path) as f:
            text = f.read()
    text = re.sub(r'/\*.*?\*/', ' ', text, flags=re.S)
    text = re.sub(r'//[^\n]*', ' ', text)
    text = re.sub(r'#inputMode\s+\w+', ' ', text)
    folder = os.path.dirname(path)

    def included(match):
        file = os.path.join(folder, match.group(2))
        return '' if match.group(1) and not os.path.exists(file) else _text(file)
    return re.sub(r'#include(IfPresent)?\s+"([^"]+)"', included, text)


def _parse(tokens, outer):
    result = {}
    words = []
    for token in tokens:
        if token == '{':
            name = words[0] if words else ''
            result[name] = _parse(tokens, {**outer, **result})
            words = []
        elif token == '}':
            return result
        elif token == ';':
            if len(words) == 1 and isinstance({**outer, **result}.get(words[0][1:]), dict):
                result.update({**outer, **result}[words[0][1:]])
            elif words:
                result[words[0]] = ' '.join(_expand(w, {**outer, **result}) for w in words[1:])
            words = []
        elif token == '(':
            words.append(_list(tokens))
        else:
            words.append(token)
    return result


def _list(tokens):
    """Everything up to the matching bracket, as text"""
    text, depth = '(', 1
    for token in tokens:
        depth += (token == '(') - (token == ')')
        text += ' ' + token
        if depth == 0:
            return text
    raise ValueError('unbalanced list')


def _expand(word, known):
    def value(match):
        found = known.get(match.group(1))
        return found if isinstance(found, str) else match.group(0)
    return re.sub(r'\$(\w+)', value, word)
