import { expect, it } from 'vitest';
import { LinesAfter } from './lines-after.ts';

it('holds lines until it is opened, and writes them in order', () => {
  const written: string[] = [];
  const lines = new LinesAfter((line) => written.push(line));
  lines.write('one');
  lines.write('two');
  expect(written).toEqual([]);
  written.push('banner');
  lines.open();
  lines.write('three');
  lines.open();
  expect(written).toEqual(['banner', 'one', 'two', 'three']);
});
