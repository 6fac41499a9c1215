import { describe, expect, it } from 'vitest';

import { resumeTokensSuite } from '../../testing/acceptance/index.ts';
import { HmacResumeTokens } from './hmac-resume-tokens.ts';

resumeTokensSuite('HmacResumeTokens', () => new HmacResumeTokens(new Uint8Array(32).fill(1)));

const tokens = new HmacResumeTokens(new Uint8Array(32).fill(1));

describe('[EX-3] resume tokens', () => {
  it('belong to one client and one key', () => {
    const token = tokens.issue('client');
    expect(tokens.verify('client', token)).toBe(true);
    expect(tokens.verify('other', token)).toBe(false);
    expect(new HmacResumeTokens(new Uint8Array(32).fill(1)).verify('client', token)).toBe(true);
    expect(new HmacResumeTokens(new Uint8Array(32).fill(2)).verify('client', token)).toBe(false);
  });

  it.each(['', 'x', '%%%', 'A'.repeat(43), 'A'.repeat(10_000), '\u0000'])('are not %j', (text) => {
    expect(tokens.verify('client', text)).toBe(false);
  });
});
