# SPDX-License-Identifier: GPL-3.0-or-later
"""What the log of riprapFoam says of a run: steps, time, device, memory, version"""
import re

_number = r'([-+0-9.eE]+)'
_patterns = {
    'version': r'^\s*riprap version\s*:\s*(\S+)',
    'device': r'^\s*device\s*:\s*([^,\n]+)',
    'precision': r'^\s*precision\s*:\s*(\w+)',
    'fluidParticles': rf'^\s*fluid particles\s*:\s*{_number}',
    'wallParticles': rf'^\s*wall particles\s*:\s*{_number}',
    'memory': rf'^\s*device memory\s*:\s*{_number}',
    'steps': rf'^\s*Total particle steps\s*=\s*{_number}',
    'particleSteps': rf'particle-steps\s*=\s*{_number}\s*$',
    'deviceTime': rf'^\s*Device time\s*=\s*{_number}',
    'executionTime': rf'ExecutionTime\s*=\s*{_number}',
    'clockTime': rf'ClockTime\s*=\s*{_number}',
}
_words = ('version', 'device', 'precision')


def readLog(path):
    """The last value of each item that is there; numbers as float, missing ones are None.
    'ended' tells whether the run came to its end."""
    with open(path, errors='replace') as f:
        text = f.read()
    result = {}
    for name, pattern in _patterns.items():
        found = re.findall(pattern, text, re.M)
        value = found[-1].strip() if found else None
        result[name] = value if name in _words or value is None else float(value)
    result['ended'] = bool(re.search(r'^End\s*$', text, re.M))
    result['warnings'] = len(re.findall(r'FOAM Warning', text))
    return result
