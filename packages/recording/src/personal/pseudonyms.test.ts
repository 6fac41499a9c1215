import { expect, it } from 'vitest';
import {
  createPseudonymKey,
  formatPseudonymKey,
  parsePseudonymKey,
  Pseudonyms,
} from './pseudonyms.ts';

const key = () => createPseudonymKey((bytes) => bytes.fill(7));
const uuid = (i: number): string => `00000000-0000-4000-8000-${String(i).padStart(12, '0')}`;

it('[PD-21] the same value has the same pseudonym with the same key, and another with another', () => {
  const [first, second] = [new Pseudonyms(key()), new Pseudonyms(key())];
  expect(first.of('Ada', 'client')).toMatch(/^client-[0-9a-f]{6}$/);
  expect(second.of('Ada', 'client')).toBe(first.of('Ada', 'client'));
  const other = new Pseudonyms(createPseudonymKey((bytes) => bytes.fill(8)));
  expect(other.of('Ada', 'client')).not.toBe(first.of('Ada', 'client'));
  expect(first.of('', 'client')).toBe('');
});

it('[PD-20] UUIDs stay UUIDs', () => {
  const pseudonym = new Pseudonyms(key()).of(uuid(1), 'client');
  expect(pseudonym).toMatch(
    /^[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/,
  );
  expect(pseudonym).not.toBe(uuid(1));
});

it.each([
  ['names', (i: number) => `person ${i}`],
  ['UUIDs', uuid],
])(
  '[PD-21] 10 000 %s have 10 000 pseudonyms, which stay the same with the key file',
  (_, valueOf) => {
    const values = Array.from({ length: 10_000 }, (_each, i) => valueOf(i));
    const pseudonyms = new Pseudonyms(key());
    const given = values.map((value) => pseudonyms.of(value, 'client'));
    expect(new Set(given).size).toBe(10_000);
    const later = new Pseudonyms(parsePseudonymKey(formatPseudonymKey(pseudonyms.key)));
    // Those whose digits met others' were given more, depending on who came first.
    expect(values.toReversed().map((value) => later.of(value, 'client'))).toEqual(
      given.toReversed(),
    );
  },
);

it('[PD-20] values whose digits are the same get more digits', () => {
  const pseudonyms = new Pseudonyms(key());
  const given = Array.from({ length: 10_000 }, (_, i) => pseudonyms.of(`person ${i}`, 'client'));
  const longer = given.filter((pseudonym) => pseudonym.length > 'client-7f3a9c'.length);
  expect(longer.length).toBeGreaterThan(0);
  for (const pseudonym of longer) expect(given).toContain(pseudonym.slice(0, -2));
});

it('[PD-22] the key file tells what each pseudonym stands for', () => {
  const pseudonyms = new Pseudonyms(key());
  const pseudonym = pseudonyms.of('Ada', 'client');
  const text = formatPseudonymKey(pseudonyms.key);
  expect(JSON.parse(text)).toMatchObject({ pseudonyms: { [pseudonym]: 'Ada' } });
  expect(parsePseudonymKey(text)).toEqual(pseudonyms.key);
});

it.each([
  ['', 'This is no key file of pseudonyms.'],
  ['{"kind":"other"}', 'This is no key file of pseudonyms.'],
  [
    '{"kind":"ubi-interact-pseudonyms","version":2}',
    'The key file has version 2, this program reads 1.',
  ],
  [
    '{"kind":"ubi-interact-pseudonyms","version":1,"key":"00","shiftMs":0,"pseudonyms":{}}',
    'The key file is damaged: its key, shift or table is missing.',
  ],
])('key file %j is refused', (text, message) => {
  expect(() => parsePseudonymKey(text)).toThrow(message);
});

it('a shift is between one and ten years', () => {
  const day = 86_400_000;
  expect(createPseudonymKey((bytes) => bytes.fill(0)).shiftMs).toBe(-365 * day);
  const most = createPseudonymKey((bytes) => bytes.fill(255)).shiftMs;
  expect(most).toBeGreaterThan(-3650 * day);
  expect(most).toBeLessThan(-3649 * day);
});
