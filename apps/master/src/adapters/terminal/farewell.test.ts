import { describe, expect, it } from 'vitest';
import { formatFarewell } from './farewell.ts';
import { formatRestored } from './restored.ts';

const many = Array.from({ length: 8 }, (_, index) => `s${index + 1}`);

describe('formatFarewell()', () => {
  it('is one word when no session runs', () => {
    expect(formatFarewell({ startAgain: [], end: [] })).toBe('Stopped.');
  });

  it('names sessions that start again, and those that do not', () => {
    expect(formatFarewell({ startAgain: ['Mirror', 'Hands'], end: ['Seeing'] })).toBe(
      [
        'Stopped.',
        '2 sessions will start again with the master: "Mirror", "Hands"',
        '1 session ended and will not start again: "Seeing"',
        'An open page of an example starts its own session again. For others, turn on "Resume when the master restarts".',
      ].join('\n'),
    );
  });

  it('bounds the names and how long each is, and prints no control characters', () => {
    const text = formatFarewell({ startAgain: many, end: [`\u001b[2J${'x'.repeat(100)}`] });
    expect(text).toContain('8 sessions will start again with the master: "s1", "s2"');
    expect(text).toContain('"s6" and 2 more');
    expect(text).not.toContain('\u001b');
    expect(text).not.toContain('x'.repeat(49));
  });
});

describe('formatRestored()', () => {
  it('prints nothing when there was nothing to start', () => {
    expect(formatRestored({ running: [], others: [] })).toBe('');
  });

  it('says which sessions run again, and why others do not', () => {
    const report = { running: ['Mirror'], others: [{ name: 'Hands', reason: 'No node "lab".' }] };
    expect(formatRestored(report)).toBe(
      '  1 session runs again: "Mirror"\n  "Hands" does not run as before: No node "lab".\n',
    );
  });

  it('bounds how many it explains', () => {
    const others = many.map((name) => ({ name, reason: 'Gone.' }));
    expect(formatRestored({ running: [], others })).toContain(
      '2 more do not run as before. The page Sessions lists them.',
    );
  });
});
