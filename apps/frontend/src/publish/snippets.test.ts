import { expect, it } from 'vitest';
import { MAX_SNIPPETS, readSnippets, snippetsFile, withSnippet } from './snippets.ts';

it('a name stands for one snippet, and files carry them', () => {
  const one = withSnippet([], 'light on', '{"topic":"/l","bool":true}', 1);
  const two = withSnippet(one, 'light off', '{"topic":"/l","bool":false}', 2);
  const again = withSnippet(two, 'light on', '{"topic":"/m","bool":true}', 5);
  expect(again.map(({ name }) => name)).toEqual(['light on', 'light off']);
  expect(again[0]).toMatchObject({ id: one[0]!.id, rateHz: 5 });
  const read = readSnippets(snippetsFile(again).text);
  if (read.kind === 'broken') throw new Error(read.message);
  expect(read.value.map(({ name, text, rateHz }) => ({ name, text, rateHz }))).toEqual(
    again.map(({ name, text, rateHz }) => ({ name, text, rateHz })),
  );
});

it('files that are something else are refused in words, and damaged snippets left out', () => {
  expect(readSnippets('{')).toMatchObject({
    message: expect.stringContaining('not JSON') as string,
  });
  expect(readSnippets('{"kind":"session"}')).toMatchObject({
    message: expect.stringContaining('no snippets') as string,
  });
  const file = {
    kind: 'ubii-publish-snippets',
    snippets: [null, { name: 'a' }, { name: 'b', text: '{}' }],
  };
  expect(readSnippets(JSON.stringify(file))).toMatchObject({
    kind: 'read',
    value: [{ name: 'b', text: '{}', rateHz: 1 }],
  });
});

it('there are only so many', () => {
  let list = withSnippet([], '0', '{}', 1);
  for (let index = 1; index < MAX_SNIPPETS + 5; index++)
    list = withSnippet(list, `${index}`, '{}', 1);
  expect(list).toHaveLength(MAX_SNIPPETS);
});
