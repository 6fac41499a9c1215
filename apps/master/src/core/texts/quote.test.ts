import { expect, it } from 'vitest';
import { quote } from './quote.ts';

it('keeps any text on one short line', () => {
  expect(quote('/a\n"b"')).toBe('"/a\\n\\"b\\""');
  expect(quote('x'.repeat(100_000)).length).toBeLessThan(130);
});
