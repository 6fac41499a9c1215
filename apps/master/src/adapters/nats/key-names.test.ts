import fc from 'fast-check';
import { describe, expect, it } from 'vitest';

import { decodeKey, encodeKey } from './key-names.ts';

describe('[CU-54] names of keys', () => {
  it('are readable', () => {
    expect(encodeKey('my session_1-a')).toBe('my=20session_1-a');
    expect(encodeKey('a.b/ü')).toBe('a=2eb=2f=c3=bc');
  });

  it('are letters that NATS takes, and are read back', () => {
    const texts = fc.string({ unit: 'grapheme', maxLength: 100 });
    fc.assert(
      fc.property(texts, (key) => {
        const name = encodeKey(key);
        expect(name).toMatch(/^[-=\w]+$/);
        expect(decodeKey(name)).toBe(key);
      }),
    );
  });

  it.each(['a.b', 'a=2', 'a=61', '=zz', '*', '=ff', ''])('are not %j', (name) => {
    expect(decodeKey(name)).toBeUndefined();
  });

  it('have a limit that errors tell', () => {
    expect(() => encodeKey('🙂'.repeat(400))).toThrow(/too long to be stored in NATS/);
  });
});
