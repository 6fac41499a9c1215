import { expect, it } from 'vitest';
import { htmlLines } from './color-source.ts';

it('lines of code wrap at their spaces', () => {
  const html =
    '<span><span class="mtk6">const</span>&#160;a&nbsp;=\u00a01</span><br/><span></span>';
  expect(htmlLines(html)).toEqual([
    '<span><span class="mtk6">const</span> a = 1</span>',
    '<span></span>',
  ]);
});
