import { describe, expect, it } from 'vitest';
import { NO_MEMORY, readMemory, remember, settingsOf, writeMemory } from './camera-memory.ts';
import { FIRST_SETTINGS } from './picture-choices.ts';

const jpeg = { width: 640, rateHz: 5, encoding: 'JPEG', quality: 0.5 } as const;

describe('what is remembered of cameras', () => {
  it('is their settings, each its own, and which was used last', () => {
    const back = remember(NO_MEMORY, 'back', jpeg);
    const both = readMemory(writeMemory(remember(back, 'front', { ...jpeg, width: 160 })));
    expect(both.chosen).toBe('front');
    expect(settingsOf(both, 'back')).toEqual(jpeg);
    expect(settingsOf(both, 'front').width).toBe(160);
    expect(settingsOf(both, 'new')).toEqual(FIRST_SETTINGS);
  });

  it('lets go of cameras of long ago, and of one without a name', () => {
    let memory = remember(NO_MEMORY, '', jpeg);
    expect(memory).toBe(NO_MEMORY);
    for (let i = 0; i < 20; i++) memory = remember(memory, `camera ${i}`, jpeg);
    expect([...memory.settings.keys()].at(0)).toBe('camera 12');
    expect(memory.settings.size).toBe(8);
    // Used again, it is the newest.
    expect([...remember(memory, 'camera 12', jpeg).settings.keys()].at(-1)).toBe('camera 12');
  });

  it('is empty, or the valid part, when another program wrote it', () => {
    for (const text of ['', 'null', '3', '{}', '{"settings":{}}', '[']) {
      expect(readMemory(text), text).toEqual(NO_MEMORY);
    }
    const odd = readMemory(
      JSON.stringify({
        chosen: 7,
        settings: [null, 'x', ['', jpeg], ['a', null], ['b', { ...jpeg, width: 1e9, quality: 7 }]],
      }),
    );
    expect(odd.chosen).toBe('');
    expect([...odd.settings]).toEqual([
      ['a', FIRST_SETTINGS],
      ['b', { ...jpeg, width: 320, quality: 0.7 }],
    ]);
  });
});
