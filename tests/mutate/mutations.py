# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be wrong with an entry: kind -> new text of the file, or None where the kind does not
apply"""
import random

# Never right: if such a case runs, something has been ignored
NEVER_RIGHT = {'word', 'dictionary', 'list', 'emptyList', 'empty', 'nan', 'inf', 'overflow',
               'unbalanced', 'noSemicolon', 'unknownWord', 'number', 'value', 'dimensions',
               'duplicate', 'selfInclude', 'surplus', 'misspelt'}


def replaced(text, begin, end, by):
    return text[:begin] + by + text[end:]


def numbers(entry):
    return [t for t in entry.value if t.number] if not entry.block else []


def words(entry):
    return [t for t in entry.value if t.plain] if not entry.block else []


def ofNumber(make):
    """One number of the value, the same one for each kind of an entry"""
    def mutate(text, e, file):
        found = numbers(e)
        if not found:
            return None
        t = random.Random(e.path).choice(found)
        new = make(t.text)
        return None if new is None else replaced(text, t.begin, t.end, new)
    return mutate


def ofWord(new):
    def mutate(text, e, file):
        found = words(e)
        return replaced(text, found[0].begin, found[0].end, new) if found else None
    return mutate


def wholeValue(new, block):
    """The entry with another value; block: of dictionaries, else of values"""
    def mutate(text, e, file):
        return (replaced(text, e.name.end, e.end, new) if e.block == block and (e.value or block)
                else None)
    return mutate


def misspelt(text, e, file):
    name = e.name.text
    if len(name) < 3 or e.name.kind != 'word':
        return None
    return replaced(text, e.name.begin, e.name.end,
                    name[:-2] + name[-1] + name[-2] if name[-1] != name[-2] else name[:-1])


def unbalanced(text, e, file):
    """Without its last bracket"""
    for t in reversed(e.value):
        if t.text in '})]':
            return replaced(text, t.begin, t.end, '')
    return None


def dimensions(text, e, file):
    brackets = [t for t in e.value if t.text in '[]'] if not e.block else []
    if brackets:
        return replaced(text, brackets[0].begin, brackets[-1].end, '[0 0 3 0 0 0 0]')
    return (replaced(text, e.value[0].begin, e.value[0].begin, '[0 0 3 0 0 0 0] ')
            if len(numbers(e)) == len(e.value) == 1 else None)


def surplus(text, e, file):
    one = len(e.value) == 1 and (e.value[0].number or e.value[0].plain)
    return (replaced(text, e.end - 1, e.end, ' 17 banana;') if one and text[e.end - 1] == ';'
            else None)


MUTATIONS = {
    'missing': lambda text, e, file: replaced(text, e.name.begin, e.end, ''),
    'misspelt': misspelt,
    'word': ofNumber(lambda t: 'banana'),
    'negative': ofNumber(lambda t: None if float(t) == 0 else t[1:] if t[0] == '-' else '-' + t),
    'zero': ofNumber(lambda t: None if float(t) == 0 else '0'),
    'nan': ofNumber(lambda t: 'nan'),
    'inf': ofNumber(lambda t: 'inf'),
    'overflow': ofNumber(lambda t: '1e400'),
    'huge': ofNumber(lambda t: '1e18'),
    'hugeNegative': ofNumber(lambda t: '-1e18'),
    'large': ofNumber(lambda t: '1e12'),
    'largeNegative': ofNumber(lambda t: '-1e12'),
    'small': ofNumber(lambda t: '1e-12'),
    'tiny': ofNumber(lambda t: '1e-30'),
    'unknownWord': ofWord('banana'),
    'number': ofWord('17'),
    'dictionary': wholeValue(' { banana 1; }', False),
    'list': wholeValue(' (1 2 banana 4 5);', False),
    'emptyList': wholeValue(' ();', False),
    'empty': wholeValue(' ;', False),
    'value': wholeValue(' 17;', True),
    'emptyDictionary': wholeValue(' {}', True),
    'dimensions': dimensions,
    'surplus': surplus,
    'noSemicolon': lambda text, e, file: replaced(text, e.end - 1, e.end, '')
    if not e.block and text[e.end - 1] == ';' else None,
    'unbalanced': unbalanced,
    'duplicate': lambda text, e, file: replaced(text, e.end, e.end,
                                                '\n' + text[e.name.begin:e.end]),
    'selfInclude': lambda text, e, file: replaced(text, e.name.begin, e.name.begin,
                                                  '#include "%s"\n' % file),
}
