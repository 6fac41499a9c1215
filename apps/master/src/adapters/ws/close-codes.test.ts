import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import type { CloseReason } from '../../index.ts';
import { closeFrame, endingOf } from './close-codes.ts';

const spec = readFileSync(
  new URL('../../../../../docs/spec/extensions.md', import.meta.url),
  'utf8',
);
const documented = [...spec.matchAll(/^\| (\d{4}) ([a-z ]+?) +\|/gm)].map(
  ([, code, reason]) => [Number(code), reason!] as const,
);

describe('the close frame of a WebSocket', () => {
  it('is in the table of docs/spec/extensions.md', () => {
    expect(documented).toHaveLength(12);
  });

  it.each(documented.filter(([code]) => code !== 4000))('has code %i for: %s', (code, reason) => {
    expect(closeFrame(reason as CloseReason).code).toBe(code);
  });

  it('has code 1000 for a deregistered client, and says the reason in words [CL-16]', () => {
    expect(closeFrame('deregistered')).toEqual({ code: 1000, text: 'deregistered' });
    expect(closeFrame('expired')).toEqual({ code: 4012, text: 'the invitation expired' });
    expect(closeFrame('disconnected', 'by Mara')).toEqual({ code: 4010, text: 'by Mara' });
  });

  it('has at most 123 bytes of text, cut between characters [EX-30]', () => {
    const { text } = closeFrame('disconnected', `by an admin: 😀${'ö'.repeat(5000)}`);
    expect(new TextEncoder().encode(text).byteLength).toBeLessThanOrEqual(123);
    expect(text).toMatch(/^by an admin: 😀ö+…$/u);
  });

  it.each([
    [4000, 'left'],
    [1000, 'lost'],
    [1006, 'lost'],
    [undefined, 'lost'],
  ])('of a client with code %s says that it is %s [EX-55]', (code, ending) => {
    expect(endingOf(code)).toBe(ending);
  });
});
