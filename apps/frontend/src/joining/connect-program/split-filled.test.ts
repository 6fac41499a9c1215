import { expect, it } from 'vitest';
import { splitFilled } from './split-filled.ts';

const marked = (text: string, filled: readonly string[]) =>
  splitFilled(text, filled)
    .map((part) => (part.isFilled ? `[${part.text}]` : part.text))
    .join('');

it('marks each part that was filled in, the longest first', () => {
  expect(marked('node a.mjs http://a:1 K7-Q', ['http://a:1', 'K7-Q'])).toBe(
    'node a.mjs [http://a:1] [K7-Q]',
  );
  expect(marked('http://a:1/sdk http://a:1', ['http://a', 'http://a:1'])).toBe(
    '[http://a:1]/sdk [http://a:1]',
  );
  expect(marked('nothing', ['', 'else'])).toBe('nothing');
  expect(marked('', ['a'])).toBe('');
});
