# SPDX-License-Identifier: GPL-3.0-or-later
"""What the log of riprapFoam says of a run: particles, steps, time, device, memory, version"""
import re

_number = r'([-+]?\d*\.?\d+(?:[eE][-+]?\d+)?)'
_items = {
    'version': r'^\s*riprap(?: version)?\s*:\s*([^\s,]+)',
    'device': r'^\s*device[\s:]\s*(\S.*?)(?: \(|$)',
    'precision': r'^\s*precision[\s:]\s*(\w+)',
    'fluidParticles': rf'^\s*particles\s+(?:fluid |solids )?{_number}',
    'wallParticles': rf'^\s*particles\s+fluid {_number[1:-1]}, walls {_number}',
    'memory': rf'^\s*memory[\s:].*?{_number} bytes',
    'steps': rf'^Particle steps = \d+ \((?:total )?{_number}',
    'cellSize': rf'^\s*grid\s.* cells of {_number} m',
    'solidSteps': rf'^Solids: steps = \d+ \({_number}',
    'clumps': rf'^\s*particles\s+\d+, clumps {_number}',
    'deviceTime': rf'^Device time = {_number}',
    'executionTime': rf'ExecutionTime = {_number}',
    'throughWalls': rf'^Escaped through walls in all: {_number}',
    'takenOut': rf'^Taken out in all: {_number}',
    'clockTime': rf'ClockTime = {_number}',
}
_words = ('version', 'device', 'precision')


def readLog(path):
    """The last value of each item that is there; numbers as float, missing ones are None.
    'ended' tells whether the run came to its end."""
    with open(path, errors='replace') as f:
        text = f.read()
    result = {}
    for name, pattern in _items.items():
        found = re.findall(pattern, text, re.M)
        # solids say theirs after the water's
        value = found[0 if name == 'device' else -1].strip() if found else None
        result[name] = value if name in _words or value is None else float(value)
    # of a coupled scene both are told
    fluid = re.findall(rf'^\s*particles\s+(?:fluid {_number}|{_number}, spacing)', text, re.M)
    if fluid:
        result['fluidParticles'] = float(max(fluid[-1]))
    for count in ('throughWalls', 'takenOut'):
        result[count] = result[count] or 0.0
    steps, particles = result['steps'], result['fluidParticles']
    result['particleSteps'] = steps*particles if steps and particles else None
    result['ended'] = bool(re.search(r'^End\s*$', text, re.M))
    result['warnings'] = len(re.findall(r'FOAM Warning', text))
    return result
