import { createHmac } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import type { ResumeTokens } from '../../core/ports/resume-tokens.ts';

const ADA = '4f5b2c1e-0d5a-4c36-9a51-2d4f0f1f0a01';
const BEN = '4f5b2c1e-0d5a-4c36-9a51-2d4f0f1f0a02';

/**
 * Acceptance tests of resume tokens.
 * @param createTokens Called twice, gives the tokens of two runs of one master.
 */
export function resumeTokensSuite(name: string, createTokens: () => ResumeTokens): void {
  describe(`${name}, ResumeTokens`, () => {
    it('know what they issued, in a later run as well [EX-3]', () => {
      const token = createTokens().issue(ADA);
      expect(createTokens().verify(ADA, token)).toBe(true);
    });

    it('give an id the same token each time', () => {
      const tokens = createTokens();
      expect(tokens.issue(ADA)).toBe(tokens.issue(ADA));
    });

    it('refuse the token of another id', () => {
      const tokens = createTokens();
      expect(tokens.verify(ADA, tokens.issue(BEN))).toBe(false);
    });

    it.each(['', ' ', 'x', '\u0000', 'é'.repeat(32), 'a'.repeat(100_000), '../../etc'])(
      'refuse %j without throwing',
      (token) => {
        expect(createTokens().verify(ADA, token)).toBe(false);
      },
    );

    it('prove that they could have issued a token [CU-85]', () => {
      const token = createTokens().issue(ADA);
      const expected = createHmac('sha256', token).update('a text').digest('hex');
      expect(createTokens().prove(ADA, 'a text')).toBe(expected);
      expect(createTokens().prove(BEN, 'a text')).not.toBe(expected);
    });

    it('issue what can stand in a URL as it is', () => {
      const token = createTokens().issue(ADA);
      expect(encodeURIComponent(token)).toBe(token);
    });
  });
}
