import { describe, expect, it } from 'vitest';
import { formatFarewell } from './session-lines.ts';
import { formatRestored } from './session-lines.ts';

const many = Array.from({ length: 8 }, (_, index) => `s${index + 1}`);

describe('formatFarewell()', () => {
  it('is one word when no session runs', () => {
    expect(formatFarewell({ startAgain: [], end: [] })).toBe('Stopped.');
  });

  it('says which sessions the master starts again, and that a page starts its own', () => {
    expect(formatFarewell({ startAgain: ['Mirror', 'Hands'], end: ['Seeing'] })).toBe(
      [
        'Stopped.',
        'The master will start 2 sessions again: "Mirror", "Hands"',
        'The master will not start 1 session again: "Seeing"',
        'A page that stays open, such as an example, starts its own session again. For other sessions, turn on "Resume when the master restarts".',
      ].join('\n'),
    );
  });

  it('bounds the names and how long each is, and prints no control characters', () => {
    const text = formatFarewell({ startAgain: many, end: [`\u001b[2J${'x'.repeat(100)}`] });
    expect(text).toContain('The master will start 8 sessions again: "s1", "s2"');
    expect(text).toContain('"s6" and 2 more');
    expect(text).not.toContain('\u001b');
    expect(text).not.toContain('x'.repeat(49));
  });
});

describe('formatRestored()', () => {
  it('prints nothing when there was nothing to start', () => {
    expect(formatRestored({ running: [], others: [] })).toBe('');
  });

  it('says which sessions the master started again, and why others do not run', () => {
    const report = { running: ['Mirror'], others: [{ name: 'Hands', reason: 'No node "lab".' }] };
    expect(formatRestored(report)).toBe(
      '  The master started 1 session again: "Mirror"\n  "Hands" does not run as before: No node "lab".\n',
    );
  });

  it('bounds how many it explains', () => {
    const others = many.map((name) => ({ name, reason: 'Gone.' }));
    expect(formatRestored({ running: [], others })).toContain(
      '2 more do not run as before. The Sessions page lists them.',
    );
  });
});
